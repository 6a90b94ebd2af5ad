// Inside scenefile only: values of a file's table replaced before it is read.
#pragma once
#include <toml++/toml.h>

#include "base/result.h"
#include "scenefile/scene_override.h"

namespace nullscope {

// Sections that are not there are made. What is replaced has no line. Errors (bad input), said of the command line's words: a section of several
// without a number or beyond the last, a value where a section should be.
Status override_values(toml::table& root, const SceneOverrides& overrides);

// An error of a value that was replaced is the command line's, not the file's.
Error where_overridden(Error error, const SceneOverrides& overrides);

}  // namespace nullscope
