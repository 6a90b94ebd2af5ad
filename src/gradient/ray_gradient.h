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
        Number r, phi;   // of the azimuth no windings
        Number bearing;  // azimuth in the plane, from its x towards its y, no windings
        Number rise;     // w of flow.h there
        Number around;   // angular momentum of the photon about the plane's normal, of frequency 1 in the camera
        Number cosine;   // of theta
    };
    struct Sky {
        Triple direction;  // world axes
        Number delay;      // T, r_s/c
    };
    std::optional<Sky> sky;  // of rays that end there
    Number g;                // camera frequency over frequency at infinity, of an observer without angular momentum
    Photon photon;
    std::vector<Crossing> crossings;
    // How far the view is from the critical curve, rad, by the first derivative; infinite where there is none.
    double off_critical = std::numeric_limits<double>::infinity();
    std::optional<Number> clearance;  // what it is told by: 0 on the critical curve, above where light falls in
    bool falls_in = false;
};

struct GradientTask {
    DiscLean lean;
    double time = 0;    // of the scene
    int crossings = 0;  // most
    // Rays that have left these radii, outward and falling in, are not followed any further, r_s.
    double farthest = std::numeric_limits<double>::infinity(), nearest = 0;
    double tolerance = 1e-12;  // of a step, values and derivatives
};

// What is known of a ray without following it: g, photon, off_critical, clearance, falls_in. Some 30 microseconds.
RayGradient ray_survey(const Flow& flow, const Launch& from);

// from: of an observer without angular momentum outside the horizon. Half a millisecond.
RayGradient ray_gradient(const Flow& flow, const Launch& from, const GradientTask& task);

}  // namespace nullscope
