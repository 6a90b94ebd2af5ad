// The disc about a rotating hole: what of the ray's crossings of the equatorial plane (mino/kept_crossings.glsl) lies between its radii.
// As planar/disc.glsl.
#include "mino/trace.glsl"
#include "object/disc_rim.glsl"
#ifdef EFFECT_DISC_LEAN
#include "mino/leaning.glsl"
#endif
#include "shared/frame.glsl"

struct DiscWalk {
    bool more;            // is there this crossing?
    int number;
    float covered;        // part of the pixel
};

DiscWalk disc_walk(Trace trace) {
    DiscWalk walk;
    walk.number = 0;
    walk.more = kept_more(trace.kept, 0);
    walk.covered = 1.0;
    return walk;
}

DiscWalk disc_next(Trace trace, DiscWalk walk) {
    walk.number += 1;
    walk.more = walk.more && kept_more(trace.kept, walk.number);
    return walk;
}

DiscCrossing disc_walk_crossing(Trace trace, DiscWalk walk) {
    int k = walk.number;
    DiscCrossing crossing = trace.kept.crossing_0;
    if (k == 1) crossing = trace.kept.crossing_1;
    if (k == 2) crossing = trace.kept.crossing_2;
    if (k == 3) crossing = trace.kept.crossing_3;
    crossing.r = max(crossing.r, 1.0e-6);
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    vec4 footprint = vec4(crossing.along, crossing.across);
    float reach = min(0.5 * sqrt(dot(footprint, footprint)), disc_rim());
    crossing.hit = kept_more(trace.kept, k) && crossing.r >= inner - reach && crossing.r <= outer + reach;
    return crossing;
}

vec3 crossing_place_in_world(DiscCrossing crossing) {
    return crossing.place.x * vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z) +
           crossing.place.y * vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z);
}

#ifdef LAYERS
int disc_walk_order(DiscWalk walk, DiscCrossing crossing) { return int(crossing.number) - 1; }
#endif

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
