// Inside scenefile only: values of a file's table replaced before it is read.
#pragma once
#include <toml++/toml.h>

#include <functional>
#include <optional>

#include "base/result.h"
#include "scenefile/scene_override.h"

namespace nullscope {

// Sections that are not there are made. What is replaced has no line. Errors (bad input), said of the command line's words: a section of several
// without a number or beyond the last, a value where a section should be, a key that is to be left out and is not there.
Status override_values(toml::table& root, const SceneOverrides& overrides);

// An error, said of the words that give its key, or a key of its section; nothing: none do.
std::optional<Error> error_of_override(Error error, const SceneOverrides& overrides);
std::optional<Error> error_of_section(const Error& error, const SceneOverrides& overrides);

// An error of a value that was replaced is the command line's, not the file's; so is one of the file's own keys where the file can be read without
// the words. reads: whether it can be with these; asked overrides.size() + 3 times at most.
Error where_overridden(Error error, const SceneOverrides& overrides,
                       const std::function<bool(const SceneOverrides&)>& reads);

}  // namespace nullscope
