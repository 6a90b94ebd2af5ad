// The shader core in float. Compiled with -fsingle-precision-constant, so that literals are float as in GLSL.
#include <cmath>
#include <glm/glm.hpp>

#include "shadercore/core_trace.h"

#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
namespace nullscope {
namespace {
using Real = float;
#include "shadercore/core_precision.inl"
}  // namespace

RayPixel trace_core32(const CoreInput& input, double x, double y) { return dispatch(input, x, y); }

std::array<std::size_t, kFrameVectors> frame_offsets() {
    using F = flat::FrameData;
    return {offsetof(F, image),
            offsetof(F, ray_0),
            offsetof(F, ray_x),
            offsetof(F, ray_y),
            offsetof(F, polar_0),
            offsetof(F, polar_x),
            offsetof(F, polar_y),
            offsetof(F, radial),
            offsetof(F, meridian),
            offsetof(F, transverse),
            offsetof(F, shift),
            offsetof(F, strip),
            offsetof(F, orbit),
            offsetof(F, series),
            offsetof(F, boost),
            offsetof(F, boost_colour),
            offsetof(F, sky),
            offsetof(F, sky_light),
            offsetof(F, disc_normal),
            offsetof(F, disc_x),
            offsetof(F, disc_y),
            offsetof(F, disc_map),
            offsetof(F, disc_look),
            offsetof(F, critical),
            offsetof(F, disc_heat),
            offsetof(F, point_stars),
            offsetof(F, point_spread),
            offsetof(F, bloom),
            offsetof(F, sphere_form),
            offsetof(F, sphere_map),
            offsetof(F, sphere_colour),
            offsetof(F, sphere_second),
            offsetof(F, cylinder_form),
            offsetof(F, cylinder_map),
            offsetof(F, cylinder_colour),
            offsetof(F, cylinder_second),
            offsetof(F, ball_form),
            offsetof(F, ball_map),
            offsetof(F, ball_colour),
            offsetof(F, ball_second),
            offsetof(F, surface_form),
            offsetof(F, surface_map),
            offsetof(F, surface_colour),
            offsetof(F, surface_second),
            offsetof(F, march),
            offsetof(F, disc_coat_map),
            offsetof(F, disc_coat_colour),
            offsetof(F, disc_coat_second),
            offsetof(F, dome_x),
            offsetof(F, dome_y),
            offsetof(F, dome_z),
            offsetof(F, dome_map),
            offsetof(F, dome_colour),
            offsetof(F, dome_second),
            offsetof(F, delay),
            offsetof(F, disc_winding),
            offsetof(F, spot),
            offsetof(F, spot_look),
            offsetof(F, spot_motion),
            offsetof(F, ball_path),
            offsetof(F, spin_hole),
            offsetof(F, spin_energy),
            offsetof(F, spin_across),
            offsetof(F, spin_climb),
            offsetof(F, spin_place),
            offsetof(F, spin_turn),
            offsetof(F, throat)};
}

}  // namespace nullscope
