// The subcommands of nullscope: each adds itself to the program, with its options and what it runs, which returns the
// exit status.
#pragma once
#include <memory>
#include <string>

#include "base/command_line.h"
#include "base/result.h"

namespace nullscope::cli {

void add_capture(Command& parent);
void add_trace(Command& parent);
void add_compare(Command& parent);
void add_bench(Command& parent);
void add_plan(Command& parent);
void add_scenes(Command& parent);
void add_info(Command& parent);
void add_figure(Command& parent);
void add_lightcurve(Command& parent);
void add_light_time(Command& parent);

// --context of what draws; help says what for.
inline void context_option(Command& command, std::string& context,
                           const char* help = "OpenGL context: auto, egl, osmesa") {
    command.add_option("--context", &context, help).one_of({"auto", "egl", "osmesa"}).show_default();
}

// One line on standard error; the exit status that goes with it (1 or 2).
int report(const Error& error);

}  // namespace nullscope::cli
