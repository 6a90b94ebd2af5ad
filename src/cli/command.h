// A subcommand registers itself with CLI11 and runs when it was named; it returns the process's exit status.
#pragma once
#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"

namespace nullscope::cli {

struct Command {
    CLI::App* app = nullptr;
    std::function<int()> run;
};

Command add_capture(CLI::App& parent);
Command add_trace(CLI::App& parent);
Command add_compare(CLI::App& parent);
Command add_bench(CLI::App& parent);
Command add_plan(CLI::App& parent);
Command add_scenes(CLI::App& parent);
Command add_info(CLI::App& parent);
Command add_figure(CLI::App& parent);
Command add_lightcurve(CLI::App& parent);
Command add_light_time(CLI::App& parent);

// --context of what draws; help says what for.
inline void context_option(CLI::App* app, std::string& context, const char* help = "OpenGL context: auto, egl, osmesa") {
    app->add_option("--context", context, help)->check(CLI::IsMember({"auto", "egl", "osmesa"}))->capture_default_str();
}

// One line on standard error; the exit status that goes with it (1 or 2).
int report(const Error& error);

}  // namespace nullscope::cli
