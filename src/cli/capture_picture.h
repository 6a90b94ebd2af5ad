// One picture of a scene, drawn by the shader or by the reference, and its file.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/capture_layers.h"
#include "cli/frame_store.h"
#include "command/session.h"
#include "image/image.h"
#include "scene/exposure.h"
#include "scene/ray.h"

namespace nullscope::cli {

struct Captured {
    Image<float> linear;                   // for .exr and .fits
    Image<unsigned char> display;          // for .png and .jpg
    std::optional<RayFrame> rays;          // with options.raydata
    std::optional<LayeredPicture> layers;  // with options.layers
    std::string made_by;
};

// Of .png and .jpg. Errors: bad input.
Status check_size8(int width, int height);

// session: what the shader draws on; null: the reference draws. next: the next frame's scene, for motion vectors; null: there is none.
Result<Captured> capture_picture(Session* session, const Exposure& shown, const CaptureOptions& options,
                                 const Scene* next = nullptr);

// The same for many pictures of what this scene shows: of it by other cameras, or at other times.
using PictureDrawer = std::function<Result<Captured>(const Exposure&)>;
Result<PictureDrawer> picture_drawer(Session* session, const Scene& scene, const CaptureOptions& options);

// The same of pictures that are too large to be held whole, which go straight into an .exr. Returns what it was made by.
// shown: what stands side by side in it; told: the scene that the file says it is of. frame: of a sequence or film.
Result<std::string> capture_large_exr(Session& session, const Scene& told, const std::vector<Exposure>& shown,
                                      const CaptureOptions& options, const std::string& file_name,
                                      std::optional<int> frame);

// In the format that the name says: .exr, .fits, .jpg (.jpeg) or .png. What a file says of itself: docs/command-line.md.
Status write_picture(const std::string& file_name, const Scene& scene, const Captured& captured,
                     const CaptureOptions& options, std::optional<int> frame);

}  // namespace nullscope::cli
