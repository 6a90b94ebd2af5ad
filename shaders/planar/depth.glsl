// How far away a place on a ray is: the affine parameter there, of a photon of unit frequency in the camera. Close to the camera a length.
//
// With u = 1/r and u'^2 = q^2 - u^2 A(u) it grows by r^2 for a swept angle, of which q^-2 (-u'/u)' is nearly all; the rest is bounded:
//     q^2 int r^2 dphi = [-u'/u] - (1/2) int u dA/du dphi
#ifdef EFFECT_LENSING
#include "core/orbit.glsl"
#else
#include "planar/delay.glsl"
#endif
#ifdef MEDIUM_MEAN
#include "planar/medium.glsl"
#include "planar/place.glsl"
#endif
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#define DEPTH_PANELS 4   // of four nodes each: 1e-5 r_s

#ifdef EFFECT_LENSING
// u dA/du after the swept angle phi.
float depth_bend(Trace trace, float phi) {
    float u = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, phi, trace.phi_end, trace.phi_end_slope).zeta;
    return u * (2.0 * frame.delay.x * frame.delay.y * u - frame.delay.x - frame.delay.y);
}

// Gauss and Legendre's nodes, from an angle on.
float depth_panel(Trace trace, float from, float wide) {
    float middle = from + 0.5 * wide;
    float inner = 0.5 * wide * 0.33998104358485626;
    float outer = 0.5 * wide * 0.86113631159405258;
    return wide * (0.32607257743127307 * (depth_bend(trace, middle - inner) + depth_bend(trace, middle + inner)) +
                   0.17392742256872693 * (depth_bend(trace, middle - outer) + depth_bend(trace, middle + outer)));
}
#endif

// After the swept angle `along`, of the ray through picture_place() `pixel`.
float affine_depth(vec2 pixel, Trace trace, float along) {
#ifdef EFFECT_LENSING
    OrbitPoint end = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, along, trace.phi_end, trace.phi_end_slope);
    float energy = energy_at(trace.c);
    float per_q = trace.s / q_sine(trace.c);
    float wide = along / float(DEPTH_PANELS);
    float bend = 0.0;
    for (int i = 0; i < DEPTH_PANELS; ++i) bend += depth_panel(trace, wide * float(i), wide);
    float start = -(frame.shift.z + frame.shift.x * trace.c) / (energy * frame.shift.y);   // u'/(q u)
    return trace.doppler / energy * (start - clamp(end.along * per_q, -1.0, 1.0) / max(end.zeta, 1.0e-12) - 0.5 * per_q * bend);
#else
    float zeta = frame.shift.y * sin(max(trace.phi_end - along, 0.0)) / trace_sine(trace);
    return trace.doppler * (light_time(trace, along, 1.0 / max(zeta, 1.0e-12), 0.0) + 1.0 / frame.shift.y);
#endif
}

#ifdef MEDIUM_MEAN
// Of a place in matter, by where the walk through it has it: x, y, z, r_s, and its depth.
vec4 medium_depth(vec2 pixel, Trace trace, float along) {
    vec3 at = medium_at(trace, place_tangent(trace), along).at;
#ifdef EFFECT_LENSING
    return vec4(at, affine_depth(pixel, trace, along));
#else
    vec3 away = at - radial_direction() / frame.shift.y;
    return vec4(at, trace.doppler * sqrt(dot(away, away)));
#endif
}
#endif
