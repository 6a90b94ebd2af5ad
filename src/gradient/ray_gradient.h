// A ray's end and its crossings of the disc's plane with their derivatives by the seeds of flow.h. Error of the derivatives: 2e-7 of their size or of 0.1
// (tests/unit/test_ray_gradient.cpp), but for rays so near the critical curve that the ray itself is not known so well.
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "gradient/flow.h"
#include "scene/disc_plane.h"

namespace nullscope {

struct RayGradient {
    struct Crossing {
        Number r, phi;  // of the azimuth no windings
    };
    struct Sky {
        Triple direction;  // world axes
        Number delay;      // T, r_s/c
    };
    std::optional<Sky> sky;  // of rays that end there
    Number g;                // camera frequency over frequency at infinity
    std::vector<Crossing> crossings;
    // How far the view is from the critical curve, rad, by the first derivative; infinite where there is none.
    double off_critical = std::numeric_limits<double>::infinity();
};

struct GradientTask {
    DiscLean lean;
    double time = 0;    // of the scene
    int crossings = 0;  // most
};

// from: of an observer at rest outside the horizon. Half a millisecond.
RayGradient ray_gradient(const Flow& flow, const Launch& from, const GradientTask& task);

}  // namespace nullscope
