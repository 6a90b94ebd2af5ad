// Where a ray crosses the disc's plane, wherever that is: for tiles that pass the disc clear of it (stage/tile_disc.glsl).
#include "mino/trace.glsl"

// Disc (x, y), r_s; 0 if there is no crossing k, 0 or 1.
vec2 crossing_place(Trace trace, int k) { return k == 0 ? trace.kept.crossing_0.place : trace.kept.crossing_1.place; }

// Are there no others?
bool crossings_known(Trace trace) { return trace.kept.count <= 2; }

#ifdef CROSSINGS_TOLD
// Of the light from there: how long ago it left (0 where light times are not asked for), and d zeta/d tau.
vec2 crossing_moves(Trace trace, int k) {
    float climb = k == 0 ? trace.kept.crossing_0.climb : trace.kept.crossing_1.climb;
#ifdef NEEDS_LIGHT_TIMES
    return vec2(k == 0 ? trace.kept.crossing_0.delay : trace.kept.crossing_1.delay, climb);
#else
    return vec2(0.0, climb);
#endif
}
#endif
