// A sphere about the centre, and hot caps on it (scene.h).
#pragma once
#include <cstddef>
#include <string_view>

#include "base/vec.h"

namespace nullscope {

inline constexpr std::size_t kMostCaps = 16;  // of a scene

struct SphereSpec {
    static constexpr std::string_view kName = "sphere";
    double radius = 3.0;     // outside the horizon
    double amplitude = 0.0;  // pulsation: radius (1 + amplitude sin(2 pi t/period)), [0, 0.5]
    double period = 40.0;    // r_s/c
    double spin_rate = 0.0;  // of its rotation about the polar axis, as seen from infinity: rad per r_s/c
    friend bool operator==(const SphereSpec&, const SphereSpec&) = default;
};

// A hot cap: black-body light, on the scale of the sphere's own.
struct CapSpec {
    double colatitude = 0.7853981633974483, azimuth = 0.0;  // of its middle, rad; the azimuth at time 0
    double radius = 0.2617993877991494;                     // rad, as seen from the sphere's middle, (0, pi]
    double temperature_K = 20000.0, brightness = 1.0;
    Vec3 colour{1.0, 1.0, 1.0};
    friend bool operator==(const CapSpec&, const CapSpec&) = default;
};

}  // namespace nullscope
