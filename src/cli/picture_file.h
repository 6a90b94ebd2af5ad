// The file of a picture.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/capture_options.h"
#include "command/capture_picture.h"
#include "scenefile/picture_scene.h"

namespace nullscope::cli {

// Draws pictures that are too large to be held whole straight into an .exr. Returns what it was made by.
// shown: what stands side by side in it; origin: what the file says of itself, but for the renderer.
Result<std::string> capture_large_exr(Session& session, const PictureOrigin& origin, const std::vector<Exposure>& shown,
                                      const CaptureOptions& options, const std::string& file_name);

// In the format that the name says, which is one (image/picture_formats.h). What a file says of itself: docs/command-line.md.
Status write_picture(const std::string& file_name, const PictureOrigin& origin, const Captured& captured,
                     const CaptureOptions& options);

// What it writes there: the file itself, or of a FITS of several frequencies one for each, "NAME-{86GHz,230GHz}.fits".
std::string files_of(const std::string& file_name, const Scene& scene, const CaptureOptions& options);

}  // namespace nullscope::cli
