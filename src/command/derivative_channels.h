// How the ray data of a picture change with keys of its scene, as channels of its EXR: what nullscope capture --derivatives does (docs/ray-data.md).
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/image_file.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::cli {

// Errors: PictureMotion's. Cheap: before a picture is drawn.
Status check_derivatives(const Scene& scene, const std::vector<std::string>& keys);

// By one unit of each key (numbers, r_s, rad) d_KEY.x, .y, .z of the direction on the sky, .shift, .delay; and .right, .down, px: where what is seen there moves to in the
// picture. As ray data, 0 where there is none. advance: by rows. Half a core-millisecond a pixel.
Status add_derivative_channels(const Scene& scene, const std::vector<std::string>& keys, const RayFrame& rays,
                               const std::function<void(long long)>& advance, ChannelImage& image);

}  // namespace nullscope::cli
