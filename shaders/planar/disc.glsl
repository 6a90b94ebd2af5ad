// The disc, as every kind of path meets it: its crossings one after another, the delay of their light, and what frequency it has.
#ifdef NEEDS_LIGHT_TIMES
#include "planar/delay.glsl"
#endif
#ifdef EFFECT_DISC_WARP
#include "planar/warped.glsl"
#else
#include "planar/disc_walk.glsl"
#endif
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#ifdef NEEDS_LIGHT_TIMES
// How long ago, by the camera's clock, the light left.
float disc_delay(Trace trace, DiscCrossing crossing) { return light_time(trace, crossing.phi, crossing.r, crossing.zeta_slope); }
#endif

// Frequency in the camera over that in matter of velocity (u^t, u^phi, u^r g_rr): of a photon with energy 1 there it is
// u^t - (L_z/E) u^phi - (k_r/E) u^r, L_z/E = (n x e) . normal / (q s), k_r/E = (1/q) (d zeta / d phi) / A.
float disc_g(Trace trace, DiscCrossing crossing, vec3 u) {
    float inverse_v = 1.0 / q_sine(trace.c);
    float momentum = dot(crossed_direction(trace), crossing_axis(crossing)) * inverse_v;
    float frequency = u.x - momentum * u.y;
#ifdef NEEDS_ZETA_SLOPE
    frequency -= trace.s * inverse_v * crossing.zeta_slope * u.z;
#endif
    return g_of(trace) / max(frequency, 1.0e-6);
}

#ifdef SLOT_DISC_LIGHT
// Of matter that moves within the disc's plane, between its light and the plane's normal: the photon's momentum across the plane, which
// that motion leaves as it is, over its frequency there. Per unit of energy the one is |L x normal|/r, the other g_of/g.
float disc_cosine(Trace trace, DiscCrossing crossing, float g) {
    vec3 across = cross(crossed_direction(trace), disc_axis());
    return sqrt(dot(across, across)) / max(q_sine(trace.c) * crossing.r, 1.0e-20) * (g / g_of(trace));
}
#endif

#ifdef NEEDS_POLARISATION
// Of the photon, over its energy: 1, L_z, p_r A, p_theta. p = L x r/r^2, and theta points against the disc's normal there.
vec4 disc_photon(Trace trace, DiscCrossing crossing) {
    float inverse_v = 1.0 / q_sine(trace.c);
    vec3 momentum = crossed_direction(trace) * inverse_v;
    vec2 outward = crossing.place / crossing.r;
    vec3 at = outward.x * vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z) + outward.y * vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z);
    return vec4(1.0, dot(momentum, disc_axis()), trace.s * inverse_v * crossing.zeta_slope, -dot(cross(momentum, at), disc_axis()));
}
#endif
