// The ray data of a frame as EXR channels (docs/ray-data.md). Names of one letter would be taken for colours: OpenImageIO and Blender do not
// tell g from G.
#pragma once
#include "base/result.h"
#include "image/image_file.h"
#include "scene/ray.h"

namespace nullscope {

// kBesideLayers: no layer of the file has more than four channels, and those of three are vectors x, y, z, as Blender needs them.
enum class RayNames { kAlone, kBesideLayers };
void add_ray_channels(const RayFrame& frame, RayNames names, ChannelImage& image);
// By any of these names, and those of files before 1.1. Errors: a channel is missing.
Result<RayFrame> ray_frame_from(const ChannelImage& image);

}  // namespace nullscope
