// The disc about a rotating hole: what of the ray's crossings of the equatorial plane (mino/kept_crossings.glsl) lies between its radii.
// As planar/disc.glsl.
#include "mino/disc_footprint.glsl"
#include "mino/disc_photon.glsl"
#include "mino/trace.glsl"

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
    crossing.hit = kept_more(trace.kept, k) && on_disc(crossing);
    return crossing;
}

#ifdef LAYERS
int disc_walk_order(DiscWalk walk, DiscCrossing crossing) { return int(crossing.number) - 1; }
#endif
