// Where the light of a picture goes round in Q and U while a hot spot goes round a hole: what polarimeters see of one that they do not
// resolve (Wielgus et al. 2022, A&A 665, L6).
#pragma once
#include <array>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace nullscope {

// Of all light; I is luminance times solid angle (sr), angles of Q and U are from the picture's right towards up.
struct StokesPoint {
    double time = 0.0;  // r_s/c
    double i = 0.0, q = 0.0, u = 0.0;
};

// Of the pixels of [x0, x1) and [y0, y1), region = x0, y0, x1, y1. stokes: I, Q, U, V of each pixel of this camera.
StokesPoint stokes_sum(const Image<float>& stokes, const CameraSpec& camera, const std::array<int, 4>& region,
                       double time);

using StokesLoop = std::vector<StokesPoint>;

// Q and U over the mean of I: what loops are drawn in. Without light 0.
std::vector<std::array<double, 2>> loop_shape(const StokesLoop& loop);

// Whether the last point is where the first is: closer than both are to their neighbours.
bool is_closed(const StokesLoop& loop);

// How many times the direction of way turns along a closed loop, counterclockwise positive with Q to the right and U up: 1 of an oval, 2 of one
// with a smaller loop in it, or of a circle that is gone round twice. 0 of fewer than four points, and of a loop that is not closed.
int loop_turns(const StokesLoop& loop);

}  // namespace nullscope
