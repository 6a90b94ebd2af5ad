#include "shadercore/stokes_transfer.h"

#include <glm/glm.hpp>

#pragma GCC diagnostic ignored "-Wshadow"

namespace nullscope {
namespace {

using Real = float;
#include "shadercore/core_types.inl"
using glm::exp;

#define float Real  // NOLINT: GLSL's float is this precision
#include "core/stokes_transfer.glsl"
#undef float

vec3 vector_of(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }
StokesRow row_of(const vec4& v) { return {v.x, v.y, v.z, v.w}; }

}  // namespace

StokesSeen stokes_seen(const StokesRow& row, const StokesWay& way) {
    const vec4 from{row[0], row[1], row[2], row[3]};
    const vec3 a = vector_of(way.absorbed), rho = vector_of(way.turned);
    const StokesRows rows =
        stokes_rows(from, stokes_factors(way.depth, dot(a, a) - dot(rho, rho), dot(a, rho)), a, rho);
    return {row_of(rows.mean), row_of(rows.behind)};
}

}  // namespace nullscope
