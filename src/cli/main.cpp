// nullscope: headless pictures, rays and measurements of curved spacetimes. Links no window system.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
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
        const auto good = [](const std::optional<double>& n) { return n && *n >= 1 && *n <= kMost && *n == static_cast<int>(*n); };
        if (good(w) && good(h)) return Size{static_cast<int>(*w), static_cast<int>(*h)};
    }
    return bad_input(fmt::format("--size {}: not a size; allowed: WIDTHxHEIGHT, whole numbers from 1x1 to 65536x65536", text));
}

}  // namespace nullscope::cli

int main(int argc, char** argv) {
    using namespace nullscope::cli;
    CLI::App app{"nullscope: accurate real-time pictures of curved spacetimes, without a window.\n"
                 "Try: nullscope capture first-light -o first-light.png",
                 "nullscope"};
    app.require_subcommand(1);
    app.set_version_flag("--version", NULLSCOPE_VERSION);
    const std::vector<Command> commands = {add_capture(app), add_trace(app), add_compare(app), add_bench(app),
                                           add_plan(app),    add_scenes(app), add_info(app)};
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
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
