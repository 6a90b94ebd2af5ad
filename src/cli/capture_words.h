// Command lines of nullscope capture, as commands that plan its runs make them.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/capture_options.h"

namespace nullscope::cli {

using Words = std::vector<std::string>;

// One line that a POSIX shell reads back as these words. Errors (bad input): a line break in one of them.
Result<std::string> shell_line(const Words& words);

// What capture itself makes of the words "nullscope capture ...". Errors: as capture's.
Result<CaptureOptions> capture_options_of(const Words& words);

}  // namespace nullscope::cli
