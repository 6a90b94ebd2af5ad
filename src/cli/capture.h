// nullscope capture, as the command that plans its runs needs it.
#pragma once
#include <functional>

#include "base/result.h"
#include "cli/command.h"
#include "cli/frame_store.h"

namespace nullscope::cli {

// Adds the command with another function to run.
void add_capture_to(Command& parent, const std::function<Status(const CaptureOptions&)>& run_it);

// Everything that capture checks of a sequence before it opens OpenGL and files. Errors: bad input.
Status check_sequence(const CaptureOptions& options);

}  // namespace nullscope::cli
