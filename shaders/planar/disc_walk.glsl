// The crossings of a ray in a plane with a flat disc, one after another.
#include "planar/disc_crossing.glsl"
#include "planar/trace.glsl"
#ifdef DISC_IS_THIN
#include "planar/disc_thin.glsl"
#ifdef EFFECT_REFINE
#include "shared/fragment_at.glsl"
#endif
#endif
#include "shared/frame.glsl"

#ifdef NEEDS_FOOTPRINT
#define DISC_MARGIN 0.5   // px by which rims are widened, for pixels that are covered in part
#else
#define DISC_MARGIN 0.0
#endif

struct DiscWalk {
    bool more;            // is there this crossing?
    int number;
    float covered;        // part of the pixel
    PlaneMeeting meeting;
#ifdef DISC_IS_THIN
    bool thin;
#endif
};

#ifdef EFFECT_REFINE
#ifdef EFFECT_NARROW_DISC
// A disc thinner than a pixel may lie between two rays: one crosses its plane before it, the other within it or behind it.
float narrow_disc_way(DiscCrossing crossing) {
    return (crossing.r > frame.disc_y.w && crossing.zeta_slope > 0.0 ? 1.0 : 0.0) + (crossing.r < frame.disc_x.w ? 2.0 : 0.0);
}

float disc_way(Trace trace, PlaneMeeting meeting) {
    return meeting.phi < trace.phi_end ? narrow_disc_way(disc_cross(trace, meeting, 0, 0.0)) : 0.0;
}
#else
float disc_way(Trace trace, PlaneMeeting meeting) { return 0.0; }
#endif

// For effect/edge.glsl.
float path_way(Trace trace) {
    PlaneMeeting meeting = disc_meeting(trace);
    float way = disc_way(trace, meeting);
#ifdef DISC_IS_THIN
    // All pixels that a thin ring may cover differ from their neighbours: it is one colour only while a pixel has one ray.
    ivec2 place = ivec2(fragment_at());
    way = disc_thin_near(trace, meeting) ? 1.0 + float((place.x + place.y) % 2) : way;
#endif
    return way;
}
#endif

#ifdef EFFECT_ZOOM
// In the middle of its way a ray that winds is next to the photon sphere, not in the disc: the first crossing behind that. ring.w: table/
// critical_images.h.
int disc_past_winding(Trace trace, PlaneMeeting meeting, int number) {
    float phi = meeting.phi + 3.14159265358979323846 * float(number);
    float rest = trace.phi_end - frame.ring.w - phi;
    return phi > frame.ring.w && rest > 0.0 ? number + int(ceil(rest * (1.0 / 3.14159265358979323846))) : number;
}
#endif

DiscWalk disc_walk_at(Trace trace, DiscWalk walk) {
#ifdef EFFECT_ZOOM
    walk.number = disc_past_winding(trace, walk.meeting, walk.number);
#endif
    walk.more = disc_reachable(trace, walk.meeting, walk.number);
    walk.covered = 1.0;
#ifdef DISC_IS_THIN
    DiscThin ring = disc_thin(trace, walk.meeting, walk.number);
    walk.thin = ring.thin;
    walk.more = ring.thin ? ring.more : walk.more;
    walk.covered = ring.thin ? ring.covered : 1.0;
#endif
    walk.more = walk.more && walk.number < DISC_MOST_CROSSINGS;
    return walk;
}

DiscWalk disc_walk(Trace trace) {
    DiscWalk walk;
    walk.meeting = disc_meeting(trace);
    int passed = int(frame.disc_surface.w);
    int first = disc_first(trace, walk.meeting);
    walk.number = passed > first ? passed : first;
    return disc_walk_at(trace, walk);
}

DiscWalk disc_next(Trace trace, DiscWalk walk) {
    walk.number += 1;
    return disc_walk_at(trace, walk);
}

DiscCrossing disc_walk_crossing(Trace trace, DiscWalk walk) {
    DiscCrossing crossing = disc_cross(trace, walk.meeting, walk.number, DISC_MARGIN);
#ifdef DISC_IS_THIN
    if (walk.thin) crossing = disc_thin_crossing(walk.meeting, walk.number);
#endif
    return crossing;
}

#ifdef LAYERS
// 0: the direct image.
int disc_walk_order(DiscWalk walk, DiscCrossing crossing) { return walk.number; }
#endif

// Crossing `number`, where it is known to be within the disc.
DiscCrossing disc_crossing_within(Trace trace, int number) { return disc_cross(trace, disc_meeting(trace), number, 0.0); }
