// The orbit table of shaders/core/orbit.glsl: where every ray of the family is after a swept angle. Needed by objects, not by the sky.
//
// Each column is one orbit zeta(phi) with its derivative by the view direction, integrated from the camera with the sixth-order
// Nystrom method RKN6(4)6FM (Dormand, El-Mikkawy, Prince 1987): zeta'' = -V'(zeta)/2, regular at turning points.
#pragma once
#include "table/ray_family.h"
#include "table/strip.h"

namespace nullscope {

struct OrbitTable {
    TexelGrid places;  // zeta
    TexelGrid delays;  // D of table/delay_column.h in the same cells; empty where nothing asks how long light takes
};

// Error of zeta: 1e-7 relative to the ray's conditioning. About 7 core-milliseconds, with delays twice that.
OrbitTable build_orbit_table(const RayFamily& family, bool delays);

// Both branches as one texture, each place's texel with its delay's to the right: what is fetched together lies together.
TexelGrid side_by_side(const TexelGrid& places, const TexelGrid& delays);

}  // namespace nullscope
