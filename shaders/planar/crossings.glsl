// Where a ray crosses the disc's plane, wherever that is: for tiles that pass the disc clear of it (stage/tile_disc.glsl).
#include "generated/tiles"
#include "planar/disc_crossing.glsl"
#include "planar/disc_thin.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

// Disc (x, y), r_s; 0 if there is no crossing k, 0 or 1.
vec2 crossing_place(Trace trace, int k) {
    PlaneMeeting meeting = disc_meeting(trace);
    DiscCrossing crossing = disc_cross(trace, meeting, k, 0.0);
    return crossing.phi < trace.phi_end ? crossing.place : vec2(0.0, 0.0);
}

// Are there no others, and no ring thinner than a pixel near?
bool crossings_known(Trace trace) {
    float offset = (trace.ray.u - 1.0) / frame.strip.z;   // the angle from the critical direction
    return disc_meeting(trace).phi + 2.0 * 3.14159265358979323846 > trace.phi_end && offset > (DISC_THIN_PX + 2.0 * float(TILE_SIDE) * pixel_longest()) * trace.pixel_angle;
}
