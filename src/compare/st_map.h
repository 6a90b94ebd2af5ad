// ST maps: where on a picture of the sky each pixel looks, for the nodes of compositors that lay pictures out by such maps (STMap in Nuke,
// Map UV in Blender). Any picture is then seen through the spacetime.
#pragma once
#include <array>
#include <functional>
#include <optional>

#include "image/image.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope {

// A place on a picture: s from 0 on its left to 1 on its right side, t from 0 at the bottom to 1 at the top.
using StPlace = std::array<double, 2>;

// Of an equirectangular picture, azimuth 0 in the middle and growing to the left, by the direction in the picture's own axes.
StPlace panorama_place(Vec3 direction);
// Of a flat plate: the picture that the same camera takes of the sky at rest, where light runs straight; beside the picture below 0 or
// above 1. By the direction in world axes; nothing where the projection shows no such place, or
// one too far for a float, as a deep zoom's is.
std::optional<StPlace> plate_place(const CameraSpec& camera, Vec3 direction);

// Of each pixel's middle: s, t and 1 where the ray comes from the sky (at l = -infinity of a wormhole: not) and has a place there; else 0, 0, 0.
Image<float> st_map(const RayFrame& rays, const std::function<std::optional<StPlace>(Vec3 direction)>& place);

}  // namespace nullscope
