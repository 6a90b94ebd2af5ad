#include "shadercore/polarised_light.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#pragma GCC diagnostic ignored "-Wshadow"

namespace nullscope {
namespace {

using Real = double;
#include "shadercore/core_types.inl"
using glm::log;

#define float Real  // NOLINT: GLSL's float is this precision
#include "core/polarisation.glsl"
#undef float

vec3 vector_of(Vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace

std::complex<double> polarised_light(const PolarisedPhoton& photon, const PolarisedPlace& place,
                                     std::optional<double> fraction, std::complex<double> phase) {
    const vec4 k =
        local_photon(photon.energy, photon.momentum, photon.climb, photon.p_theta, place.r, place.a, place.lapse);
    const vec4 u = local_matter(vector_of(place.u), place.r, place.a, place.lapse);
    const vec3 way = seen_from(u, k);
    const double part =
        fraction.value_or(scattering_fraction(std::min(std::abs(way.y) / std::sqrt(dot(way, way)), 1.0)));
    const vec2 turn = stokes_direction({phase.real(), phase.imag()}, emitted_kappa(k, u, vector_of(place.field)));
    return part * std::complex<double>(turn.x, turn.y);
}

}  // namespace nullscope
