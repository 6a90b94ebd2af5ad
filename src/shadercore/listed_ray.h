// Rays of a list (shaders/stage/ray_list.glsl): what is told of each, and what comes back.
#pragma once
#include <array>

#include "scene/ray.h"
#include "shadercore/frame_data.h"

namespace nullscope {

// What of the frame's numbers is a ray's own, where all start at one radius (about a rotating hole at one polar angle too) as one observer's.
struct RayNumbers {
    FrameVector start;  // FrameData::polar_0; about a rotating hole FrameData::spin_place
    FrameVector
        radial;  // outward, .w = cosine of the polar angle; about a rotating hole .x = the peak next to the critical curve
    FrameVector meridian;  // .w = the swept angle for which zeta is asked; 0 or less: for none
    FrameVector ray;       // FrameData::ray_0
};

// Crossings of the disc's plane that are told at once: from number `first` on (0 is the ray's first), at most `most` of them.
inline constexpr int kListedCrossings = 4;
struct ListedCrossings {
    int first = 0, most = 0;
};

struct ListedRay {
    RayPixel end;  // without place, delay where nothing tells it is 0
    struct Crossing {
        double x, y;  // r_s
        double
            climb;  // d zeta/d phi; about a rotating hole d zeta/d tau, of Mino's time, or of a disc that leans the photon's
                    // momentum about its axis, per frequency in the observer's frame
    };
    std::array<Crossing, kListedCrossings> crossings;
    int count = 0;      // of them that are there
    bool more = false;  // maybe there are others behind them, that the ray may end on too
    double at = 0;      // zeta at the angle that was asked for; 0: the ray has ended
};

}  // namespace nullscope
