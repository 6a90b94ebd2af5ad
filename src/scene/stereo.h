// Stereo pictures: where the eyes are in the camera's axes, and how their pictures lie in the one that is written.
//
// Pair: an eye is half of eye_distance to the left or right of the camera. All-round: omnidirectional stereo (Google, "Rendering
// omni-directional stereo content", 2015; Blender's spherical stereo): the eyes lie on a circle of diameter eye_distance about the camera,
// level in its axes, across the direction of each column. It is drawn in strips of kStrip_px columns, each from the eye of its middle
// column. A strip's other columns are then seen from a place before or behind their eye, which shifts nothing on the horizon, to first
// order, and at most seam_px() towards the poles. observer/eye.h has what an eye is in curved spacetime.
#pragma once
#include <array>
#include <vector>

#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope {

// Width and height of the picture that is written: an eye's, or two of them.
std::array<int, 2> stereo_size(const CameraSpec& camera);

inline constexpr int kStrip_px = 8;
// How far what is at `distance` from the camera moves between two strips, px of the height of one: at most.
double seam_px(const CameraSpec& camera, double distance);

enum class EyeSide { kLeft, kRight };
// From the camera to the eye that sees column x, along (right, up, backward), r_s.
Vec3 eye_offset(const CameraSpec& camera, EyeSide side, double x);

// A part of the picture that one eye's camera draws.
struct EyePart {
    CameraSpec camera;  // of the middle, for this part
    Vec3 offset;        // to the eye
    int skip, columns;  // of the part: those that are used
    int left, top;      // where they go
};
// All of them, from left to right, the left eye's first. camera.stereo is not kOff.
std::vector<EyePart> eye_parts(const CameraSpec& camera);

}  // namespace nullscope
