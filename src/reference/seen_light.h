// What a camera sees of a black body, for the reference: the disc's rings and point stars.
#pragma once
#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope::reference {

// The frequency ratio g in its two parts, as observers at rest at the source and at the camera split it: gravity, the ratio between
// these two; doppler, what the motion of both adds.
struct Shift {
    double gravity = 1, doppler = 1;
    double seen(const LightSpec& light) const { return (light.gravity ? gravity : 1) * (light.doppler ? doppler : 1); }
};

// Linear Rec. 709 of a black body of temperature_K whose frequencies arrive multiplied by g, as far as the switches of `light` let them;
// its brightness in the unit of log2_brightness (light/black_body.h). Black where it is too cold to be seen. About 0.2 us, within 1e-12 of
// what the sum over wavelengths gives.
Vec3 seen_black_body(double temperature_K, double g, const LightSpec& light);

// log2_brightness (light/black_body.h) by the same sums.
double seen_log2_brightness(double temperature_K, bool bolometric);

}  // namespace nullscope::reference
