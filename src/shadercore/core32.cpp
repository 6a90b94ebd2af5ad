// The shader core in float. Compiled with -fsingle-precision-constant, so that literals are float as in GLSL.
#include <cmath>
#include <glm/glm.hpp>

#include "shadercore/core_trace.h"

#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
namespace nullscope {
namespace {
using Real = float;
#include "shadercore/core_precision.inl"
}  // namespace

RayPixel trace_core32(const CoreInput& input, double x, double y) { return dispatch(input, x, y); }

std::array<std::size_t, kFrameVectors> frame_offsets() {
    using F = flat::FrameData;
    return {offsetof(F, image),   offsetof(F, ray_0),  offsetof(F, ray_x),    offsetof(F, ray_y), offsetof(F, polar_0),
            offsetof(F, polar_x), offsetof(F, polar_y), offsetof(F, radial), offsetof(F, meridian), offsetof(F, transverse),  offsetof(F, strip), offsetof(F, orbit),  offsetof(F, series), offsetof(F, boost),
            offsetof(F, shift),   offsetof(F, sky),    offsetof(F, disc_normal), offsetof(F, disc_x), offsetof(F, disc_y),
            offsetof(F, disc_map), offsetof(F, disc_look), offsetof(F, critical)};
}

}  // namespace nullscope
