// Schwarzschild's rays next to the critical one in as many digits as their distance from it takes: b of the ray, and from that the
// swept angles as Carlson's R_F of the roots of the orbit's cubic. Nothing is expanded about the critical ray, and nothing is shared with
// observer/ring_view.h, the tables or the reference.
#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <optional>

#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::proof {

// 400 digits: 300 for what is relative to 1e-300, and 100 to spare.
using Big = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>, boost::multiprecision::et_off>;
using Big3 = std::array<Big, 3>;

struct ExactRingRay {
    bool escapes = false;
    Big swept = 0;                              // to the sky; of rays that escape
    std::array<double, 3> sky{};                // world axes
    std::optional<std::array<double, 2>> disc;  // first meeting of the disc: x, y
    int order = 0;                              // half turns to the sky
};

// A camera with a zoom: at rest outside of the photon sphere, in motion by camera.velocity, or in orbit, or falling from infinity.
class ExactRing {
public:
    explicit ExactRing(const Scene& scene);
    // px from the picture's middle, y up.
    ExactRingRay ray(const Big& x, const Big& y) const;

private:
    Scene scene_;
    Big u0_, lapse_;
    Big3 motion_, forward_, right_, up_;  // of the camera, in the axes of the observer at rest
    Big pixel_;
};

}  // namespace nullscope::proof
