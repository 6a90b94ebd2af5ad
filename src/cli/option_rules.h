// Which options of nullscope capture cannot be given together, or not with a file of another format: a row each, by which they are refused
// and by which options that a picture recorded give way to those that are given.
#pragma once
#include <string_view>
#include <vector>

#include "cli/capture_options.h"
#include "scene/scene.h"

namespace nullscope::cli {

// Errors: bad input, of the first row that is broken.
Status check_rules(const CaptureOptions& options, const Scene& scene);

// Names of the options that cannot stand beside this one; and of those that files of this kind do not have.
std::vector<std::string_view> excluded_by(std::string_view option);
std::vector<std::string_view> without_place(const CaptureOptions& options);

}  // namespace nullscope::cli
