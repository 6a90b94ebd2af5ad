// nullscope: headless pictures, rays and measurements of curved spacetimes. Links no window system.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "base/text.h"
#include "cli/command.h"

namespace nullscope::cli {

int report(const Error& error) {
    fmt::print(stderr, "nullscope: {}\n", error.message);
    return static_cast<int>(error.kind);
}

Result<Size> parse_size(const std::string& text) {
    constexpr double kMost = 65536;
    const auto parts = split(text, 'x');
    if (parts.size() == 2) {
        const auto w = parse_number(parts[0]), h = parse_number(parts[1]);
        const auto good = [](const std::optional<double>& n) {
            return n && *n >= 1 && *n <= kMost && *n == static_cast<int>(*n);
        };
        if (good(w) && good(h)) return Size{static_cast<int>(*w), static_cast<int>(*h)};
    }
    return bad_input(
        fmt::format("--size {}: not a size; allowed: WIDTHxHEIGHT, whole numbers from 1x1 to 65536x65536", text));
}

namespace {

std::string in_one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
}

std::vector<std::string> subcommands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> long_options(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

// What is wrong with the command line, in one line, with the nearest known word.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App* at = &app;  // the innermost command that was named
    std::string name = app.get_name();
    while (!at->get_subcommands().empty()) {
        at = at->get_subcommands().front();
        name += " " + at->get_name();
    }
    const auto commands = subcommands(*at);
    std::string message = in_one_line(error.what()), nearest;
    const auto unknown = app.remaining(true);
    for (const std::string& word : unknown)
        if (nearest.empty()) nearest = nearest_word(word, word.starts_with("--") ? long_options(*at) : commands);
    if (!commands.empty()) {
        const bool named = !unknown.empty() && !unknown.front().starts_with("-");
        message = fmt::format("{}; allowed: {}",
                              named ? in_one_line(unknown.front()) + ": no such command" : "a command is missing",
                              fmt::join(commands, ", "));
    }
    if (!nearest.empty()) message += fmt::format(" (nearest: {})", nearest);
    return fmt::format("{} (see: {} --help)", message, name);
}

}  // namespace
}  // namespace nullscope::cli

int main(int argc, char** argv) {
    using namespace nullscope::cli;
    CLI::App app{
        "nullscope: accurate real-time pictures of curved spacetimes, without a window.\n"
        "Try: nullscope capture first-light -o first-light.png",
        "nullscope"};
    app.require_subcommand(1);
    app.set_version_flag("--version", NULLSCOPE_VERSION);
    const std::vector<Command> commands = {add_capture(app), add_trace(app),  add_compare(app), add_bench(app),
                                           add_plan(app),    add_scenes(app), add_info(app), add_figure(app)};
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
        return report(nullscope::bad_input(usage_message(app, e)));
    }
    try {
        for (const Command& command : commands)
            if (command.app->parsed()) return command.run();
    } catch (const std::bad_alloc&) {
        return report(nullscope::failed("out of memory"));
    } catch (const std::exception& e) {
        return report(nullscope::failed(e.what()));
    }
    return 2;
}
