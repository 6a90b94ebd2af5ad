// nullscope capture, as the command that plans its runs needs it.
#pragma once
#include <functional>
#include <string>

#include "base/result.h"
#include "cli/command.h"
#include "cli/frame_store.h"

namespace nullscope::cli {

// Adds the command with another function to run.
void add_capture_to(Command& parent, const std::function<Status(const CaptureOptions&)>& run_it);

// The stamp that a sequence's pictures have (frame_store.h), after everything that capture checks before it opens OpenGL and files.
// Errors: bad input.
Result<std::string> sequence_stamp(const CaptureOptions& options);

}  // namespace nullscope::cli
