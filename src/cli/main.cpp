// nullscope: headless pictures, rays and measurements of curved spacetimes. Links no window system.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

#include "base/atomic_file.h"
#include "base/credits.h"
#include "base/text.h"
#include "cli/command.h"
#include "command/session.h"
#include "platform/console.h"
#include "version/version.h"

namespace nullscope::cli {

int report(const Error& error) {
    const bool input = error.kind == ErrorKind::kBadInput;  // a driver's log may have lines
    fmt::print(stderr, "nullscope: {}\n", input ? without_controls(error.message()) : error.message());
    return static_cast<int>(error.kind);
}

namespace {

// Called when stdio has said so; what is left in its buffer is lost.
int report_unwritable_output() {
    const std::error_code reason(errno, std::generic_category());
    return report(failed("standard output cannot be written" + (reason ? ": " + reason.message() : "")));
}

}  // namespace
}  // namespace nullscope::cli

int main(int argc, char** argv) {
    nullscope::platform::begin_console();
    nullscope::clean_up_on_signals();
    nullscope::cli::name_driver_at_death("nullscope");
    using namespace nullscope::cli;
    nullscope::Command program(
        "nullscope",
        "nullscope: draw, trace and measure black holes and other curved spacetimes, without a window.\n"
        "Try: nullscope capture first-light -o first-light.png");
    program.set_version(nullscope::kVersionText);
    program.set_credits(nullscope::kCredits);
    for (const auto add : kCommands) add(program);
    program.set_footer("\nnullscope help COMMAND lists the options of a command. For a window, run nullscope-viewer.");
    const auto asked = nullscope::parse_command_line(program, argc, argv);
    if (!asked) return report(asked.error());
    try {
        const nullscope::Result<int> ran = asked->run ? asked->run() : (fmt::print("{}", asked->text), 0);
        const int status = ran ? *ran : report(ran.error());
        if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
        return status != 0 ? status : report_unwritable_output();
    } catch (const std::bad_alloc&) {
        return report(nullscope::failed("out of memory"));
    } catch (const std::exception& e) {
        return std::ferror(stdout) != 0 ? report_unwritable_output() : report(nullscope::failed(e.what()));
    }
}
