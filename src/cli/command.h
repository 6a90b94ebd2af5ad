// The subcommands of nullscope: each adds itself to the program, with its options and what it runs, which returns the
// exit status.
#pragma once
#include "base/result.h"
#include "bench/bench.h"
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
void add_devices(Command& parent);
void add_figure(Command& parent);
void add_fit(Command& parent);
void add_flux(Command& parent);
void add_lightcurve(Command& parent);
void add_light_time(Command& parent);
void add_profile(Command& parent);
void add_spectrum(Command& parent);
void add_study(Command& parent);
void add_visibility(Command& parent);
void add_landmarks(Command& parent);

// In the order of nullscope --help.
inline constexpr void (*kCommands[])(Command&) = {
    add_capture,    add_frames,     add_study,   add_path,     add_trace,      add_compare,   add_bench,
    add_plan,       add_scenes,     add_info,    add_devices,  add_figure,     add_fit,       add_flux,
    add_lightcurve, add_light_time, add_profile, add_spectrum, add_visibility, add_landmarks, add_manual};

// One line on standard error; the exit status that goes with it (1 or 2).
int report(const Error& error);

}  // namespace nullscope::cli
