// The disc about a rotating hole: what of the ray's crossings of the equatorial plane (mino/trace.glsl) lies between its radii.
// As planar/disc.glsl.
#include "mino/trace.glsl"
#include "shared/frame.glsl"

struct DiscCrossing {
    bool hit;
    float r;          // r_s
    vec2 place;       // disc (x, y), r_s
    float phi;        // Mino's time
    vec2 along;       // footprint of one pixel on the disc in (x, y), r_s: image of its side to the right
    vec2 across;      // ... and upward
    float climb; // d zeta / d tau along the ray
#ifdef EFFECT_DELAY
    float late;
#endif
};

SpinCrossing spin_kept(Trace trace, int k) {
    SpinCrossing kept = trace.crossing_0;
    if (k == 1) kept = trace.crossing_1;
    if (k == 2) kept = trace.crossing_2;
    if (k == 3) kept = trace.crossing_3;
    return kept;
}

bool spin_disc_more(Trace trace, int k) { return k < min(trace.crossings, SPIN_CROSSINGS); }

DiscCrossing spin_disc_cross(Trace trace, int k, vec4 foot) {
    SpinCrossing kept = spin_kept(trace, k);
    DiscCrossing crossing;
    crossing.r = max(kept.r, 1.0e-6);
    crossing.place = kept.place;
    crossing.phi = kept.along;
    crossing.climb = kept.climb;
#ifdef EFFECT_DELAY
    crossing.late = kept.late;
#endif
    crossing.along = vec2(foot.x, foot.y);
    crossing.across = vec2(foot.z, foot.w);
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    float reach = min(0.5 * sqrt(dot(foot, foot)), SPIN_RIM * min(outer - inner, inner));
    crossing.hit = spin_disc_more(trace, k) && crossing.r >= inner - reach && crossing.r <= outer + reach;
    return crossing;
}

#ifdef NEEDS_FOOTPRINT
// How the crossings move from pixel to pixel. Where a neighbour has none of this number: as if the disc were looked at from here, straight.
struct DiscFeet {
    vec4 foot_0;
    vec4 foot_1;
    vec4 foot_2;
    vec4 foot_3;
};

vec4 spin_foot(Trace trace, int k, vec2 place, float r, float number) {
    vec4 foot = vec4(dFdx(place), dFdy(place));
    float there = spin_disc_more(trace, k) ? number : 0.0;
    float edge = abs(dFdx(there)) + abs(dFdy(there));
    float side = trace.pixel_angle * (r + 1.0 / frame.shift.y);
    return edge == 0.0 ? foot : vec4(side, 0.0, 0.0, side);
}

DiscFeet spin_feet(Trace trace) {
    DiscFeet feet;
    feet.foot_0 = spin_foot(trace, 0, trace.crossing_0.place, trace.crossing_0.r, trace.crossing_0.number);
    feet.foot_1 = spin_foot(trace, 1, trace.crossing_1.place, trace.crossing_1.r, trace.crossing_1.number);
    feet.foot_2 = spin_foot(trace, 2, trace.crossing_2.place, trace.crossing_2.r, trace.crossing_2.number);
    feet.foot_3 = spin_foot(trace, 3, trace.crossing_3.place, trace.crossing_3.r, trace.crossing_3.number);
    return feet;
}

vec4 spin_foot_of(DiscFeet feet, int k) {
    vec4 foot = feet.foot_0;
    if (k == 1) foot = feet.foot_1;
    if (k == 2) foot = feet.foot_2;
    if (k == 3) foot = feet.foot_3;
    return foot;
}
#endif

struct DiscWalk {
    bool more;            // is there this crossing?
    int number;
    float covered;        // part of the pixel
#ifdef NEEDS_FOOTPRINT
    DiscFeet feet;
#endif
};

DiscWalk disc_walk(Trace trace) {
    DiscWalk walk;
    walk.number = 0;
    walk.more = spin_disc_more(trace, 0);
    walk.covered = 1.0;
#ifdef NEEDS_FOOTPRINT
    walk.feet = spin_feet(trace);
#endif
    return walk;
}

DiscWalk disc_walk_on(Trace trace, DiscWalk walk) {
    walk.number += 1;
    walk.more = walk.more && spin_disc_more(trace, walk.number);
    return walk;
}

DiscCrossing disc_walk_crossing(Trace trace, DiscWalk walk) {
#ifdef NEEDS_FOOTPRINT
    return spin_disc_cross(trace, walk.number, spin_foot_of(walk.feet, walk.number));
#else
    return spin_disc_cross(trace, walk.number, vec4(0.0, 0.0, 0.0, 0.0));
#endif
}

#ifdef EFFECT_DELAY
float disc_late(Trace trace, DiscCrossing crossing) { return crossing.late; }
#endif

// k_r/E = (d zeta / d tau) g_rr / E (mino/kerr.glsl). By frequencies, not by ratios to E: light may reach a camera in the hole with an
// energy below 0.
float disc_g(Trace trace, DiscCrossing crossing, vec3 u) {
    return trace.doppler / max(trace.energy * u.x - trace.momentum * u.y - crossing.climb * u.z, 1.0e-6);
}
