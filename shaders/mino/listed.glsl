// What a list of rays asks of one about a rotating hole (stage/ray_list.glsl). As planar/listed.glsl.
#include "mino/disc.glsl"
#include "mino/trace.glsl"
#include "shared/frame.glsl"

struct ListedCrossing {
    bool there;
    vec2 place;     // x and y, azimuth of Boyer and Lindquist, r_s
    float climb;    // d zeta/d tau; of a disc that leans instead the photon's momentum about its axis
    float along;    // Mino's time
};

ListedCrossing listed_crossing(Trace trace, int k) {
    DiscWalk walk = disc_walk(trace);
    walk.number = k;
    DiscCrossing met = disc_walk_crossing(trace, walk);
    ListedCrossing crossing;
    crossing.there = kept_more(trace.kept, k);
    crossing.place = met.place;
#ifdef EFFECT_DISC_LEAN
    crossing.climb = met.momentum;
#else
    crossing.climb = met.climb;
#endif
    crossing.along = met.phi;
    return crossing;
}

// Only those that are kept can be the disc's: the others in another draw.
bool listed_more(Trace trace) { return trace.kept.count >= SPIN_CROSSINGS; }
float listed_passed() { return frame.disc_surface.w; }

// No angle is swept in a plane.
float listed_at(Trace trace, float angle) { return 0.0; }
