#include "cli/capture_words.h"

#include <algorithm>

namespace nullscope::cli {
namespace {

std::string shell_word(const std::string& word) {
    constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

}  // namespace

Result<std::string> shell_line(const Words& words) {
    std::string line;
    for (const std::string& word : words) {
        if (word.find_first_of("\n\r") != std::string::npos)
            return bad_input("a line break in an argument: each command is one line");
        line += (line.empty() ? "" : " ") + shell_word(word);
    }
    return line;
}

Result<CaptureOptions> capture_options_of(const Words& words) {
    Command program("nullscope", "");
    CaptureOptions found;
    add_capture_to(program, [&](const CaptureOptions& options) -> Status {
        found = options;
        return Done{};
    });
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    TRY(asked, parse_command_line(program, static_cast<int>(argv.size()), argv.data()));
    if (!asked->run) return bad_input("after --: options of capture that draw");
    TRY(ran, asked->run());
    return found;
}

}  // namespace nullscope::cli
