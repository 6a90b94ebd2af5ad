// What a camera sees of a black body, for the reference: the disc's rings and point stars.
#pragma once
#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope::reference {

// Linear Rec. 709 of a black body of temperature_K whose frequencies arrive multiplied by g, as far as the switches of `light` let them;
// its brightness in the unit of log2_brightness (light/black_body.h). Black where it is too cold to be seen. About 2 us.
Vec3 seen_black_body(double temperature_K, double g, const LightSpec& light);

}  // namespace nullscope::reference
