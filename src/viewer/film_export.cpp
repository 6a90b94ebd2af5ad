#include "viewer/film_export.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "scenefile/scene_writer.h"
#include "viewer/user_files.h"

namespace nullscope::viewer {
namespace {

namespace fs = std::filesystem;

constexpr int kNiceness = 10;  // the viewer goes first

// Beside this program. Empty: it is not there.
fs::path capture_program() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path() / "nullscope";
    return !error && fs::is_regular_file(program, error) ? program : fs::path();
}

}  // namespace

Status FilmExport::start(const Scene& scene, const std::string& output) {
    cancel();
    const fs::path program = capture_program();
    if (program.empty()) return failed("the program nullscope, which draws films, is not beside nullscope-viewer");
    std::error_code error;
    const fs::path home = state_folder(), folder = home.empty() ? fs::temp_directory_path(error) : home;
    fs::create_directories(folder, error);
    const fs::path file = folder / "film.toml";  // one name: the same film goes on where it was left
    TRY(written, write_text_atomically(file, scene_file_text(scene, {})));
    std::vector<std::string> words = {program.string(),
                                      "capture",
                                      file.string(),
                                      "-o",
                                      output,
                                      "--size",
                                      fmt::format("{}x{}", scene.camera.width, scene.camera.height)};
    if (!output.ends_with(".mp4"))
        for (const std::string& word :
             {std::string("--frames"), fmt::format("0:{}", scene.path->frames), std::string("--resume")})
            words.push_back(word);
    TRY(started, process_.start(std::move(words)));
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(process_.id()), kNiceness);
    share_ = 0.0;
    output_ = output, said_.clear(), line_.clear(), message_.clear();
    return Done{};
}

// Lines "frames: 37% (12.1 s, 20 s left)"; of others the last is kept, for it may say what went wrong.
void FilmExport::read_output() {
    for (const char c : process_.read()) {
        if (c != '\n') {
            line_ += c;
            continue;
        }
        int percent = 0;
        if (std::sscanf(line_.c_str(), "frames: %d%%", &percent) == 1)
            share_ = 0.01 * percent;
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
    message_ = *status == 0 ? fmt::format("Film drawn: {}", output_) : without_controls("No film: " + said_);
    return true;
}

std::string FilmExport::take_message() { return std::exchange(message_, {}); }

}  // namespace nullscope::viewer
