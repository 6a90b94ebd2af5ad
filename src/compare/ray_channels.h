// The ray data of a frame as EXR channels: fate, sky.x sky.y sky.z, g, delay, angle, order, hit, u, v (docs/ray-data.md).
#pragma once
#include "base/result.h"
#include "image/image_file.h"
#include "scene/ray.h"

namespace nullscope {

void add_ray_channels(const RayFrame& frame, ChannelImage& image);
// Errors: a channel is missing.
Result<RayFrame> ray_frame_from(const ChannelImage& image);

}  // namespace nullscope
