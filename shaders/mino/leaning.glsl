// A disc's plane that leans from the equator of a rotating hole: rays do not keep to planes there, and cross it where they happen to. Each step
// knows the height of its ends over it and how that changes; one that dips through it and comes back is taken in two. As spin_crossing of
// mino/segment.glsl for the equatorial plane.
#include "core/plane_search.glsl"
#include "core/trig.glsl"
#include "mino/height.glsl"
#include "mino/kerr.glsl"
#include "mino/segment.glsl"
#include "mino/step.glsl"
#include "shared/frame.glsl"

bool step_crosses(SpinState from, SpinState to) { return from.height.x * to.height.x < 0.0 || (to.height.x == 0.0 && from.height.x != 0.0); }

// Where a step is farthest beyond the plane, if it comes back; else 1.
float leaning_dip(vec2 from, vec2 to) { return plane_dip(from, to, LEANING_ON); }

// A step, or its part to where it is beyond the plane: once more in a loop, as software drivers run both sides of a branch.
SpinState next_step(SpinRay ray, SpinState from, inout float h) {
    SpinState to;
    float part = 1.0;
    bool again;
    do {
        again = part < 1.0;
        h *= part;
        to = spin_step(ray, from, h);
        to.height = leaning_end(ray, to);
        part = leaning_dip(vec2(from.height.x, h * from.height.y), vec2(to.height.x, h * to.height.y));
    } while (part < 1.0 && !again);
    return to;
}

// Once psi has what a zoom leaves out.
#ifdef EFFECT_ZOOM
SpinState state_turned(SpinRay ray, SpinState now) {
    now.height = leaning_end(ray, now);
    return now;
}
#else
SpinState state_turned(SpinRay ray, SpinState now) { return now; }
#endif

vec2 leaning_height_within(SpinRay ray, SpinSegment segment, float s) {
    vec4 y = spin_at(segment.arc, s);
    float drag = segment.h * spin_drag(ray, y.w, spin_fine_at(segment.arc, s, y.w));
    return leaning_height(y, spin_slope_at(segment.arc, s), segment_turned(ray, segment, s, y), drag);
}

DiscCrossing spin_crossing(SpinRay ray, SpinState from, SpinState to, float h, float tau) {
    SpinSegment segment = spin_segment(ray, from, to, h);
    vec2 begin = vec2(from.height.x, h * from.height.y);
    vec2 end = vec2(to.height.x, h * to.height.y);
    PlaneSearch search = plane_search(begin, end);
    search = plane_narrowed(search, leaning_height_within(ray, segment, search.s), begin.x);
    search = plane_narrowed(search, leaning_height_within(ray, segment, search.s), begin.x);
    search = plane_narrowed(search, leaning_height_within(ray, segment, search.s), begin.x);
    float s = search.s;
    vec4 at = spin_at(segment.arc, s);
    vec4 slope = spin_slope_at(segment.arc, s) / h;
    vec3 n = normalize(vec3(at.x, at.y, at.z));
    vec2 turn = sine_cosine(segment_turned(ray, segment, s, at));
    vec3 outward = vec3(turn.y * n.x - turn.x * n.y, turn.x * n.x + turn.y * n.y, n.z);
    vec3 around = cross(n, vec3(slope.x, slope.y, slope.z));
    vec3 turned = vec3(turn.y * around.x - turn.x * around.y, turn.x * around.x + turn.y * around.y, around.z);
    DiscCrossing crossing = no_crossing();
    crossing.phi = tau + s * h;
    crossing.r = 1.0 / max(at.w, 1.0e-12);
    crossing.place = crossing.r * vec2(dot(outward, vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z)), dot(outward, vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z)));
    crossing.climb = slope.w;
    crossing.momentum = -dot(turned, vec3(frame.disc_normal.x, frame.disc_normal.y, frame.disc_normal.z));
    crossing.north = n.z;
#ifdef NEEDS_RISE
    crossing.rise = leaning_height_within(ray, segment, s).y / h;
#endif
#ifdef NEEDS_LIGHT_TIMES
    crossing.delay = segment_delay(ray, segment, s, at);
#endif
    return crossing;
}

// u^t of the disc's matter, which goes round its axis at this rate (spacetime/leaning_circle.h).
float leaning_u_t(DiscCrossing crossing, float rate) {
    float a2 = frame.spin_hole.y;
    float r2 = crossing.r * crossing.r;
    float sine2 = max(1.0 - crossing.north * crossing.north, 1.0e-12);
    float across = frame.disc_normal.z;
    float part = min(across * across / sine2, 1.0);
    float sigma = r2 + a2 * (1.0 - sine2);
    float pull = (crossing.r - frame.spin_turn.z) / sigma;
    float lapse2 = 1.0 - pull + 2.0 * frame.spin_hole.x * pull * rate * across - rate * rate * (sigma * (1.0 - part) + (r2 + a2 + a2 * pull * sine2) * part);
    return inversesqrt(max(lapse2, 1.0e-6));
}

#ifdef SLOT_DISC_LIGHT
// The photon's momentum along the plane's unit normal: k N/sqrt(N^2) with N the height's gradient, Sigma k N = rise, and
// Sigma N^2 = 1 - a^2 N_phi^2/Delta, N_phi^2 = sin^2 - cos(tilt)^2.
float disc_across(DiscCrossing crossing) {
    float a2 = frame.spin_hole.y;
    float r = crossing.r;
    float sine2 = 1.0 - crossing.north * crossing.north;
    float delta = (r - frame.spin_hole.z) * (r - frame.spin_hole.w);
    float beside = a2 * max(sine2 - frame.disc_normal.z * frame.disc_normal.z, 0.0) / max(delta, 1.0e-6);
    return abs(crossing.rise) * inversesqrt(max((r * r + a2 * (1.0 - sine2)) * (1.0 - beside), 1.0e-6));
}
#endif
