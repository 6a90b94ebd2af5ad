// The subcommands of nullscope: each adds itself to the program, with its options and what it runs, which returns the
// exit status.
#pragma once
#include "base/result.h"
#include "command/options.h"

namespace nullscope::cli {

void add_capture(Command& parent);
void add_frames(Command& parent);
void add_path(Command& parent);
void add_manual(Command& parent);
void add_trace(Command& parent);
void add_compare(Command& parent);
void add_plan(Command& parent);
void add_scenes(Command& parent);
void add_info(Command& parent);
void add_figure(Command& parent);
void add_lightcurve(Command& parent);
void add_light_time(Command& parent);
void add_profile(Command& parent);
void add_spectrum(Command& parent);

// One line on standard error; the exit status that goes with it (1 or 2).
int report(const Error& error);

}  // namespace nullscope::cli
