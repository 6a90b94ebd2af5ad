#include "cli/frame_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <filesystem>
#include <vector>

#include "base/text.h"

extern char** environ;

namespace nullscope::cli {
namespace {

// The program's exit status, -1 if it could not be started. No shell: names are passed as they are.
int run_quietly(std::vector<std::string> words) {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int started = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (started != 0) return -1;
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status) == 127 ? -1 : WEXITSTATUS(status);
}

// For names that ffmpeg reads as a pattern.
std::string percent_doubled(const std::string& name) {
    std::string doubled;
    for (const char c : name) doubled += c == '%' ? "%%" : std::string(1, c);
    return doubled;
}

}  // namespace

bool have_ffmpeg() { return run_quietly({"ffmpeg", "-loglevel", "quiet", "-version"}) == 0; }

Status encode_film(const std::string& folder, int first, int count, double rate, const std::string& output) {
    const std::string part = output + ".part.mp4";
    std::vector<std::string> words =
        split(fmt::format("ffmpeg -y -loglevel error -framerate {} -start_number {} -i", rate, first), ' ');
    words.push_back(percent_doubled(folder) + "/%05d.png");
    // Sides are made even: 4:2:0 halves them.
    for (const std::string& word : split(fmt::format("-frames:v {} -vf crop=trunc(iw/2)*2:trunc(ih/2)*2 -c:v libx264 "
                                                     "-crf 16 -pix_fmt yuv420p -movflags +faststart",
                                                     count),
                                         ' '))
        words.push_back(word);
    words.push_back(part);
    const int status = run_quietly(std::move(words));
    std::error_code error;
    if (status == 0) std::filesystem::rename(part, output, error);
    if (status == 0 && !error) return Done{};
    std::filesystem::remove(part, error);
    return failed(status < 0 ? "ffmpeg is not installed; the pictures are in " + folder
                             : fmt::format("ffmpeg could not write {} (exit status {}); the pictures are in {}", output,
                                           status, folder));
}

}  // namespace nullscope::cli
