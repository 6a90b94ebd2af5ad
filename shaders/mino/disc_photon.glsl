// The photon that the disc sent along a ray about a rotating hole from where the ray crosses its plane, traced or interpolated.
#ifdef EFFECT_DISC_LEAN
#include "mino/leaning.glsl"
#endif
#ifdef INTERPOLATED_DISC
#include "mino/interpolated.glsl"
#else
#include "mino/trace.glsl"
#endif
#include "shared/frame.glsl"

vec3 crossing_place_in_world(DiscCrossing crossing) {
    return crossing.place.x * vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z) +
           crossing.place.y * vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z);
}

#ifdef NEEDS_LIGHT_TIMES
float disc_delay(Trace trace, DiscCrossing crossing) { return crossing.delay; }
#endif

// k_r/E = (d zeta / d tau) g_rr / E (mino/kerr.glsl). By frequencies, not by ratios to E: light may reach a camera in the hole with an
// energy below 0.
#ifdef EFFECT_DISC_LEAN
// u: 1, the angular velocity about the disc's axis, 0.
float disc_g(Trace trace, DiscCrossing crossing, vec3 u) {
    return trace.doppler / max((trace.energy * u.x - crossing.momentum * u.y) * leaning_u_t(crossing, u.y), 1.0e-6);
}
#else
float disc_g(Trace trace, DiscCrossing crossing, vec3 u) {
    return trace.doppler / max(trace.energy * u.x - trace.momentum * u.y - crossing.climb * u.z, 1.0e-6);
}
#endif

#ifdef SLOT_DISC_LIGHT
#ifndef EFFECT_DISC_LEAN
float disc_across(DiscCrossing crossing) { return abs(crossing.rise) / crossing.r; }
#endif
// As planar/disc.glsl; the momentum across the equatorial plane is |p_theta|/r.
float disc_cosine(Trace trace, DiscCrossing crossing, float g) { return disc_across(crossing) * (g / trace.doppler); }
#endif

#ifdef NEEDS_POLARISATION
// Of the photon: E, L_z, p_r Delta/r^2, p_theta.
vec4 disc_photon(Trace trace, DiscCrossing crossing) { return vec4(trace.energy, trace.momentum, crossing.climb, crossing.rise); }
#endif
