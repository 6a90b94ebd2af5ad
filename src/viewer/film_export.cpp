#include "viewer/film_export.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "scenefile/scene_writer.h"
#include "viewer/user_files.h"

extern char** environ;

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
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return failed(std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    const int failure = ::posix_spawn(&process_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_fd_ = ends[0];
    if (failure != 0) {
        process_ = 0;
        ::close(std::exchange(output_fd_, -1));
        return failed(fmt::format("{}: {}", program.string(), std::strerror(failure)));
    }
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(process_), kNiceness);
    share_ = 0.0;
    output_ = output, said_.clear(), line_.clear(), message_.clear();
    return Done{};
}

// Lines "frames: 37% (12.1 s, 20 s left)"; of others the last is kept, for it may say what went wrong.
void FilmExport::read_output() {
    std::array<char, 4096> bytes;
    for (ssize_t count = 0; (count = ::read(output_fd_, bytes.data(), bytes.size())) > 0;)
        for (ssize_t i = 0; i < count; ++i) {
            const char c = bytes[static_cast<std::size_t>(i)];
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
    if (process_ == 0) return false;
    const double before = share_;
    read_output();
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) != process_) return share_ != before;
    read_output();
    ::close(std::exchange(output_fd_, -1));
    process_ = 0;
    message_ = WIFEXITED(status) && WEXITSTATUS(status) == 0 ? fmt::format("Film drawn: {}", output_)
                                                             : without_controls("No film: " + said_);
    return true;
}

std::string FilmExport::take_message() { return std::exchange(message_, {}); }

void FilmExport::cancel() {
    if (process_ == 0) return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    ::close(std::exchange(output_fd_, -1));
    process_ = 0;
}

}  // namespace nullscope::viewer
