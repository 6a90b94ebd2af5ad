// nullscope: headless pictures, rays and measurements of curved spacetimes. Links no window system.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "cli/command.h"

namespace nullscope::cli {

int report(const Error& error) {
    const bool input = error.kind == ErrorKind::kBadInput;  // a driver's log may have lines
    fmt::print(stderr, "nullscope: {}\n", input ? without_controls(error.message) : error.message);
    return static_cast<int>(error.kind);
}

namespace {

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
    std::string message = error.what(), nearest;
    const auto unknown = app.remaining(true);
    for (const std::string& word : unknown)
        if (nearest.empty()) nearest = nearest_word(word, word.starts_with("--") ? long_options(*at) : commands);
    if (!commands.empty()) {
        const bool named = !unknown.empty() && !unknown.front().starts_with("-");
        message = fmt::format("{}; allowed: {}",
                              named ? unknown.front() + ": no such command" : "a command is missing",
                              fmt::join(commands, ", "));
    }
    if (!nearest.empty()) message += fmt::format(" (nearest: {})", nearest);
    return fmt::format("{} (see: {} --help)", message, name);
}

int run_named(const std::vector<Command>& commands) {
    for (const Command& command : commands)
        if (command.app->parsed()) return command.run();
    return 2;
}

// Called when stdio has said so; what is left in its buffer is lost.
int report_unwritable_output() {
    const std::error_code reason(errno, std::generic_category());
    return report(failed("standard output cannot be written" + (reason ? ": " + reason.message() : "")));
}

}  // namespace
}  // namespace nullscope::cli

int main(int argc, char** argv) {
    nullscope::clean_up_on_signals();
    using namespace nullscope::cli;
    CLI::App app{
        "nullscope: accurate real-time pictures of curved spacetimes, without a window.\n"
        "Try: nullscope capture first-light -o first-light.png",
        "nullscope"};
    app.require_subcommand(1);
    app.set_version_flag("--version", NULLSCOPE_VERSION);
    const std::vector<Command> commands = {add_capture(app), add_trace(app),  add_compare(app), add_bench(app),
                                           add_plan(app),    add_scenes(app), add_info(app), add_figure(app),
                                           add_lightcurve(app), add_light_time(app)};
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
        return report(nullscope::bad_input(usage_message(app, e)));
    }
    try {
        const int status = run_named(commands);
        if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
        return status != 0 ? status : report_unwritable_output();
    } catch (const std::bad_alloc&) {
        return report(nullscope::failed("out of memory"));
    } catch (const std::exception& e) {
        return std::ferror(stdout) != 0 ? report_unwritable_output() : report(nullscope::failed(e.what()));
    }
}
