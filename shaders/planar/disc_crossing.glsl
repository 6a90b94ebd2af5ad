// The disc: a plane through the centre between two radii. Every crossing of the ray with it, in order along the ray.
#ifdef EFFECT_LENSING
#include "core/orbit.glsl"
#endif
#include "core/plane.glsl"
#include "planar/disc_hit.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

#ifdef EFFECT_ZOOM
#define DISC_MOST_CROSSINGS 24   // ... down to kFinestRing
#else
#define DISC_MOST_CROSSINGS 12   // tables resolve windings down to 1e-13 of the critical angle: phi_end < 12 pi
#endif

// Of the disc's plane, in world axes.
vec3 disc_axis() { return vec3(frame.disc_normal.x, frame.disc_normal.y, frame.disc_normal.z); }

// The first crossing of the plane; crossing k lies k half turns further and on alternating sides.
PlaneMeeting disc_meeting(Trace trace) {
    return plane_meet(crossed_direction(trace), radial_direction(), trace.s, disc_axis(), frame.disc_normal.w);
}

// Unit vector from the centre to crossing `number`, disc (x, y).
vec2 disc_outward(PlaneMeeting meeting, int number) {
    vec3 m = (number & 1) == 0 ? meeting.direction : -meeting.direction;
    return vec2(dot(m, vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z)), dot(m, vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z)));
}

// Two bounds that cost nothing. |d zeta / d phi| <= q outside the horizon, so zeta grows from zeta0 and falls to
// 0 at the sky no faster than q phi. (Inside, zeta0 alone is above that of any disc; q < 0 there is light that never met one.) DISC_WIDENED leaves room for the rims' covered fractions (see margin).
#define DISC_WIDENED 1.15
#define DISC_LONGEST 64.0   // of its outer radius: a longer footprint shows no less of the disc, and its square has no room in a float

// Does the ray still reach crossing `number` (counted from 0), and, on its way out, may any later one be within the disc?
bool disc_reachable(Trace trace, PlaneMeeting meeting, int number) {
    float rest = trace.phi_end - (meeting.phi + 3.14159265358979323846 * float(number));
    float slowest = trace.escapes ? trace.s / (DISC_WIDENED * frame.disc_y.w) : 0.0;
    return rest * q_sine(trace.c) > slowest && rest > 0.0;
}

// The first crossing that may be close enough to the centre, coming from the camera: number 0 or 1.
int disc_first(Trace trace, PlaneMeeting meeting) {
    float zeta_most = frame.shift.y * trace.s + q_sine(trace.c) * meeting.phi;   // times s
    return zeta_most * DISC_WIDENED * frame.disc_y.w >= trace.s ? 0 : 1;
}

// Position on crossing `number` (0, 1, ...). margin: pixels by which the rims are widened (for covered fractions).
DiscCrossing disc_cross(Trace trace, PlaneMeeting meeting, int number, float margin) {
    DiscCrossing crossing;
    crossing.hit = false;
    crossing.phi = meeting.phi + 3.14159265358979323846 * float(number);
#ifdef EFFECT_LENSING
    OrbitPoint point = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, crossing.phi, trace.phi_end, trace.phi_end_slope);
    float zeta = max(point.zeta, 1.0e-12);
    float r = 1.0 / zeta;
    float r_along = -point.along * r * r;
    float r_across = -point.across * r * r;
#ifdef NEEDS_ZETA_SLOPE
    crossing.zeta_slope = point.along;
#endif
#else
    float zeta0 = frame.shift.y;
    float sine = trace_sine(trace);
    float sin_rest = max(sine * cos(crossing.phi) - trace.c * sin(crossing.phi), 0.0);   // of alpha - phi: alpha itself has no digits from afar
    float zeta = max(zeta0 * sin_rest / sine, 1.0e-12);
    float r = 1.0 / zeta;
    float r_along = r * (trace.c * cos(crossing.phi) + sine * sin(crossing.phi)) / max(sin_rest, 1.0e-6);
    float r_across = -r * r * zeta0 * sin(crossing.phi) / (sine * sine);
#ifdef NEEDS_ZETA_SLOPE
    crossing.zeta_slope = -r_along * zeta * zeta;
#endif
#endif
    // Moving the pixel by d(chi) about the radial axis: the crossing moves along the ray and round the disc by
    // d phi_1 = height hN / rho^2, d lambda = height / rho^2 with hN = orbital normal . disc normal, rho^2 = 1 - hN^2.
    float inverse_s = 1.0 / trace_sine(trace);
    float orbital = -dot(crossed_direction(trace), disc_axis()) * inverse_s;
    float turn = frame.disc_normal.w / max((1.0 - orbital) * (1.0 + orbital), 1.0e-6) * inverse_s * trace.pixel_angle;
    float across_r = r_along * orbital * turn;
    float across_t = r * turn;
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    float along_r = clamp(r_across * trace.pixel_angle, -DISC_LONGEST * outer, DISC_LONGEST * outer);
    float reach = min(margin * sqrt(along_r * along_r + across_r * across_r), 0.125 * (outer - inner));   // DISC_WIDENED
    crossing.r = r;
    crossing.hit = r >= inner - reach && r <= outer + reach;
    vec2 outward = disc_outward(meeting, number);
    vec2 around = vec2(-outward.y, outward.x);
    crossing.place = r * outward;
    crossing.along = along_r * outward;
    crossing.across = across_r * outward + across_t * around;
    return crossing;
}

vec3 crossing_axis(DiscCrossing crossing) { return disc_axis(); }
vec3 crossing_place_in_world(DiscCrossing crossing) {
    return crossing.place.x * vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z) +
           crossing.place.y * vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z);
}
