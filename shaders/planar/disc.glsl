// The disc, as every kind of path meets it: its crossings one after another, the delay of their light, and what frequency it has.
#ifdef NEEDS_LIGHT_TIMES
#include "planar/delay.glsl"
#endif
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

#ifdef NEEDS_LIGHT_TIMES
// How long ago, by the camera's clock, the light left.
float disc_delay(Trace trace, DiscCrossing crossing) { return light_time(trace, crossing.phi, crossing.r, crossing.zeta_slope); }
#endif

// Frequency in the camera over that in matter of velocity (u^t, u^phi, u^r g_rr): of a photon with energy 1 there it is
// u^t - (L_z/E) u^phi - (k_r/E) u^r, L_z/E = (n x e) . normal / (q s), k_r/E = (1/q) (d zeta / d phi) / A.
float disc_g(Trace trace, DiscCrossing crossing, vec3 u) {
    float inverse_v = 1.0 / q_sine(trace.c);
    float momentum = dot(crossed_direction(trace), disc_axis()) * inverse_v;
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
