// The ray's crossings of the disc's plane that are kept, those on the disc or close to its rims; without a disc none. Reads the global `frame`.
#ifdef EFFECT_DISC
#ifdef NEEDS_FOOTPRINT
#include "effect/sampling.glsl"
#include "mino/disc_footprint.glsl"
#include "shared/quad_step.glsl"
#endif
#include "mino/segment.glsl"
#include "object/disc_rim.glsl"
#endif
#ifdef EFFECT_DISC_LEAN
#include "mino/leaning.glsl"
#endif
#ifdef EFFECT_REFINE
#include "mino/ray_way.glsl"
#endif
#include "mino/step.glsl"
#include "shared/frame.glsl"

#ifdef EFFECT_DISC
#define SPIN_CROSSINGS 4   // layers of a translucent disc
#define SPIN_FARTHEST 1.0e10   // a crossing beyond it lies behind the sky

struct KeptCrossings {
    float number;         // of the plane so far, kept or not
    int count;            // of those to be kept: the first SPIN_CROSSINGS are
    DiscCrossing crossing_0;
    DiscCrossing crossing_1;
    DiscCrossing crossing_2;
    DiscCrossing crossing_3;
#ifdef EFFECT_REFINE
    float within;         // inside of the inner rim
    float beyond;         // outside of the outer rim
    bool covered;         // by an opaque disc
#ifdef EFFECT_NARROW_DISC
    float narrow_disc;    // whether the first is outside of the outer rim, on the way in
#endif
#endif
};

KeptCrossings kept_none() {
    KeptCrossings kept;
    kept.number = 0.0;
    kept.count = 0;
    DiscCrossing none = no_crossing();
    kept.crossing_0 = none;
    kept.crossing_1 = none;
    kept.crossing_2 = none;
    kept.crossing_3 = none;
#ifdef EFFECT_REFINE
    kept.within = 0.0;
    kept.beyond = 0.0;
    kept.covered = false;
#ifdef EFFECT_NARROW_DISC
    kept.narrow_disc = 0.0;
#endif
#endif
    return kept;
}

// Is there crossing k among them?
bool kept_more(KeptCrossings kept, int k) { return k < min(kept.count, SPIN_CROSSINGS); }

#ifndef EFFECT_DISC_LEAN
// Does a step pass the plane?
bool step_crosses(SpinState from, SpinState to) { return from.y.z * to.y.z < 0.0 || (to.y.z == 0.0 && from.y.z != 0.0); }
#endif

bool within_disc(float r) { return r >= frame.disc_x.w && r <= frame.disc_y.w; }

// Which place a crossing takes.
int kept_place(KeptCrossings kept, DiscCrossing crossing) {
    int place = kept.count;
#ifndef EVERY_CROSSING
    // Light that winds close to a rim may cross the plane beside the disc more often than there are places.
    if (place >= SPIN_CROSSINGS && !within_disc(kept.crossing_3.r) && within_disc(crossing.r)) place = 3;
#endif
    return place;
}

#ifdef EFFECT_REFINE
#ifdef EFFECT_NARROW_DISC
KeptCrossings kept_before(KeptCrossings kept, DiscCrossing crossing, SpinStep at, bool crossed) {
    bool inward = at.from.v.w + at.to.v.w > 0.0;
    kept.narrow_disc = crossed && kept.number == 1.0 && inward && crossing.r > frame.disc_y.w ? 1.0 : kept.narrow_disc;
    return kept;
}
float before_way(KeptCrossings kept) { return 4.0 * kept.narrow_disc; }
#else
KeptCrossings kept_before(KeptCrossings kept, DiscCrossing crossing, SpinStep at, bool crossed) { return kept; }
float before_way(KeptCrossings kept) { return 0.0; }
#endif

KeptCrossings kept_counts(KeptCrossings kept, DiscCrossing crossing, SpinStep at, bool crossed) {
    bool counts = crossed && !kept.covered && crossing.number > frame.disc_surface.w;
    kept.within += counts && crossing.r < frame.disc_x.w ? 1.0 : 0.0;
    kept.beyond += counts && crossing.r > frame.disc_y.w ? 1.0 : 0.0;
    kept.covered = kept.covered || (counts && within_disc(crossing.r) && frame.disc_surface.x >= 1.0 && frame.disc_surface.y == 0.0);
    return kept_before(kept, crossing, at, crossed);
}
#else
KeptCrossings kept_counts(KeptCrossings kept, DiscCrossing crossing, SpinStep at, bool crossed) { return kept; }
#endif

// And the one on a step that passes the plane, of a ray that meets what is ours.
KeptCrossings kept_with(KeptCrossings kept, SpinRay ray, SpinStep at, bool ours) {
#ifdef EVERY_CROSSING
    float rim = SPIN_FARTHEST;
#else
    float rim = disc_rim();
#endif
    DiscCrossing crossing = spin_crossing(ray, at.from, at.to, at.h, at.begun);
    bool crossed = at.crosses && ours;
    kept.number += crossed ? 1.0 : 0.0;
    crossing.number = kept.number;
    kept = kept_counts(kept, crossing, at, crossed);
    if (crossed && kept.number > frame.disc_surface.w && crossing.r > max(ray.outer, frame.disc_x.w - rim) && crossing.r < min(SPIN_FARTHEST, frame.disc_y.w + rim)) {
        int place = kept_place(kept, crossing);
        if (place == 0) kept.crossing_0 = crossing;
        if (place == 1) kept.crossing_1 = crossing;
        if (place == 2) kept.crossing_2 = crossing;
        if (place == 3) kept.crossing_3 = crossing;
        ++kept.count;
    }
    return kept;
}

#ifdef NEEDS_FOOTPRINT
// Crossing k with its footprint. Where a neighbour has none of this number: as if the disc were looked at from here,
// straight.
DiscCrossing kept_footprint(KeptCrossings kept, int k, DiscCrossing crossing, float pixel_angle) {
    float there = kept_more(kept, k) ? crossing.number : 0.0;
    QuadStep beside = quad_step(vec4(crossing.place, there, 0.0));
    float edge = abs(beside.along.z) + abs(beside.across.z);
    bool known = edge == 0.0 && !kept_as_points();
    return with_footprint(crossing, known, beside.along.xy * sampling_share(), beside.across.xy * sampling_share(), pixel_angle);
}

KeptCrossings kept_footprints(KeptCrossings kept, float pixel_angle) {
    kept.crossing_0 = kept_footprint(kept, 0, kept.crossing_0, pixel_angle);
    kept.crossing_1 = kept_footprint(kept, 1, kept.crossing_1, pixel_angle);
    kept.crossing_2 = kept_footprint(kept, 2, kept.crossing_2, pixel_angle);
    kept.crossing_3 = kept_footprint(kept, 3, kept.crossing_3, pixel_angle);
    return kept;
}
#endif

#ifdef EFFECT_REFINE
float kept_way(KeptCrossings kept, bool escapes) {
    return kept.covered ? 0.0 : spin_way(escapes, kept.within, kept.beyond) + before_way(kept);
}
#endif
#else
struct KeptCrossings {
    float number;
};

KeptCrossings kept_none() {
    KeptCrossings kept;
    kept.number = 0.0;
    return kept;
}

bool step_crosses(SpinState from, SpinState to) { return false; }
KeptCrossings kept_with(KeptCrossings kept, SpinRay ray, SpinStep at, bool ours) { return kept; }
KeptCrossings kept_footprints(KeptCrossings kept, float pixel_angle) { return kept; }
#ifdef EFFECT_REFINE
float kept_way(KeptCrossings kept, bool escapes) { return spin_way(escapes, 0.0, 0.0); }
#endif
#endif
