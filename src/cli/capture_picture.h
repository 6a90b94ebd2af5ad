// One picture of a scene, drawn by the shader or by the reference, and its file.
#pragma once
#include <optional>
#include <string>

#include "base/image.h"
#include "base/result.h"
#include "cli/capture_options.h"
#include "cli/session.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::cli {

struct Captured {
    Image<float> linear;           // for .exr
    Image<unsigned char> display;  // for .png
    std::optional<RayFrame> rays;  // with options.raydata
    std::string made_by;
};

// session: what the shader draws on; null: the reference draws. exr: linear light is asked for.
Result<Captured> capture_picture(Session* session, const Scene& scene, const CaptureOptions& options, bool exr);

Status write_picture(const std::string& file_name, const Scene& scene, const Captured& captured, bool exr);

}  // namespace nullscope::cli
