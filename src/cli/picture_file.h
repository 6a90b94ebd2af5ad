// The file of a picture.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/capture_options.h"
#include "command/capture_picture.h"

namespace nullscope::cli {

// Draws pictures that are too large to be held whole straight into an .exr. Returns what it was made by.
// shown: what stands side by side in it; told: the scene that the file says it is of. frame: of a sequence or film.
Result<std::string> capture_large_exr(Session& session, const Scene& told, const std::vector<Exposure>& shown,
                                      const CaptureOptions& options, const std::string& file_name,
                                      std::optional<int> frame);

// In the format that the name says: .exr, .fits, .jpg (.jpeg) or .png. What a file says of itself: docs/command-line.md.
Status write_picture(const std::string& file_name, const Scene& scene, const Captured& captured,
                     const CaptureOptions& options, std::optional<int> frame);

}  // namespace nullscope::cli
