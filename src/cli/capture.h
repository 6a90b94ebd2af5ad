// nullscope capture, as the command that plans its runs needs it.
#pragma once
#include <string>

#include "base/result.h"
#include "cli/capture_options.h"

namespace nullscope::cli {

// The stamp that a sequence's pictures have (frame_store.h), after everything that capture checks before it opens OpenGL and files.
// Errors: bad input.
Result<std::string> sequence_stamp(const CaptureOptions& options);

}  // namespace nullscope::cli
