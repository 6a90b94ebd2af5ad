#include "studio/film_export.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "platform/places.h"
#include "scenefile/scene_writer.h"
#include "studio/user_files.h"

namespace nullscope::viewer {
namespace {

namespace fs = std::filesystem;

// Beside this program. Empty: it is not there.
fs::path capture_program() {
    std::error_code error;
    const fs::path program = platform::program_file().parent_path() / platform::program_name("nullscope");
    return fs::is_regular_file(program, error) ? program : fs::path();
}

}  // namespace

std::string film_words(double share, int frames, std::optional<double> left_s) {
    if (share <= 0.0) return fmt::format("{} frames", frames);
    std::string words = fmt::format("frame {:.0f} of {}", share * frames, frames);
    constexpr double kMinute = 60.0, kHour = 3600.0;
    if (!left_s) return words;
    if (*left_s < kMinute) return words + fmt::format(", {:.0f} s left", *left_s);
    if (*left_s < 1.5 * kHour) return words + fmt::format(", {:.0f} min left", *left_s / kMinute);
    return words + fmt::format(", {:.1f} h left", *left_s / kHour);
}

Status FilmExport::start(const Scene& scene, const std::string& output) {
    cancel();
    const fs::path program = capture_program();
    if (program.empty()) return failed("the program nullscope, which draws films, is not beside nullscope-viewer");
    std::error_code error;
    const fs::path home = state_folder(), folder = home.empty() ? fs::temp_directory_path(error) : home;
    fs::create_directories(folder, error);
    file_ = folder / fmt::format("film-{}.toml", platform::process_id());
    Scene named = scene;
    if (named.name.empty()) named.name = "film";  // not the file's name: the same film goes on where it was left
    TRY(written, write_text_atomically(file_, scene_file_text(named, {})));
    std::vector<std::string> words = {program.string(),
                                      "capture",
                                      file_.string(),
                                      "-o",
                                      output,
                                      "--size",
                                      fmt::format("{}x{}", scene.camera.width, scene.camera.height)};
    if (!output.ends_with(".mp4"))
        for (const std::string& word :
             {std::string("--frames"), fmt::format("0:{}", scene.path->frames), std::string("--resume")})
            words.push_back(word);
    TRY(started, process_.start(std::move(words)));
    process_.give_way();  // the viewer goes first
    share_ = 0.0, left_s_.reset(), frames_ = scene.path->frames;
    output_ = output, said_.clear(), line_.clear(), message_.clear();
    return Done{};
}

void FilmExport::cancel() {
    process_.end();
    remove_file();
}

void FilmExport::remove_file() {
    std::error_code error;
    if (!file_.empty()) fs::remove(std::exchange(file_, {}), error);
}

std::string FilmExport::progress_words() const { return film_words(share_, frames_, left_s_); }

// Lines "frames: 37% (12.1 s, 20 s left)"; of others the last is kept, for it may say what went wrong.
void FilmExport::read_output() {
    for (const char c : process_.read()) {
        if (c != '\n') {
            line_ += c;
            continue;
        }
        int percent = 0;
        double passed_s = 0.0, left_s = 0.0;
        if (const int read =
                std::sscanf(line_.c_str(), "frames: %d%% (%lf s, %lf s left)", &percent, &passed_s, &left_s);
            read >= 1)
            share_ = 0.01 * percent, left_s_ = read == 3 ? std::optional(left_s) : std::nullopt;
        else if (!line_.empty())
            said_ = line_;
        line_.clear();
    }
}

bool FilmExport::poll() {
    if (!runs()) return false;
    const double before = share_;
    const auto status = process_.poll();
    read_output();
    if (!status) return share_ != before;
    remove_file();
    message_ = *status == 0 ? fmt::format("Film drawn: {}", output_) : without_controls("No film: " + said_);
    return true;
}

std::string FilmExport::take_message() { return std::exchange(message_, {}); }

}  // namespace nullscope::viewer
