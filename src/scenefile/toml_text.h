// Inside scenefile only: the text of a file as TOML, whatever is in it.
#pragma once
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "base/result.h"

namespace nullscope {

// Errors, of bad input: larger than kLargestSceneFile, so many dots that keys could nest too deeply, and what is no TOML, each without
// control characters. file_label: named in errors.
Result<toml::table> toml_of(std::string_view text, const std::string& file_label);

// The same, fit for a line of a terminal: no part of it has control characters.
Error without_controls(Error error);

}  // namespace nullscope
