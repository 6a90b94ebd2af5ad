// Where a ray about a rotating hole (mino/kerr.glsl) is within a step, by the fraction s of it.
#include "core/trig.glsl"
#ifdef EFFECT_DISC
#include "mino/disc_crossing.glsl"
#endif
#include "mino/kerr.glsl"
#include "shared/frame.glsl"

// Over a step, as a polynomial of the fraction s of it: the quintic with the values, slopes and curvatures of both ends.
struct SpinArc {
    vec4 c0;
    vec4 c1;
    vec4 c2;
    vec4 c3;
    vec4 c4;
    vec4 c5;
#ifdef NEEDS_FINE_ZETA
    float fine;       // of c0
#endif
};

SpinArc spin_arc(SpinState from, SpinState to, float h) {
    SpinArc arc;
    arc.c0 = from.y;
    arc.c1 = h * from.v;
    arc.c2 = (0.5 * h * h) * from.f;
    vec4 d = to.y - arc.c0 - arc.c1 - arc.c2;
#ifdef NEEDS_FINE_ZETA
    arc.fine = from.fine;
    d.w += to.fine - from.fine;
#endif
    vec4 dv = h * to.v - arc.c1 - 2.0 * arc.c2;
    vec4 df = (h * h) * to.f - 2.0 * arc.c2;
    arc.c3 = 10.0 * d - 4.0 * dv + 0.5 * df;
    arc.c4 = -15.0 * d + 7.0 * dv - df;
    arc.c5 = 6.0 * d - 3.0 * dv + 0.5 * df;
    return arc;
}

vec4 spin_at(SpinArc arc, float s) {
    vec4 more = s * (arc.c1 + s * (arc.c2 + s * (arc.c3 + s * (arc.c4 + s * arc.c5))));
    vec4 at = arc.c0 + more;
#ifdef NEEDS_FINE_ZETA
    at.w = rounded_sum(arc.c0.w, more.w);
#endif
    return at;
}

// Of zeta in what spin_at() gives.
float spin_fine_at(SpinArc arc, float s, float zeta) {
#ifdef NEEDS_FINE_ZETA
    return arc.fine + (s * (arc.c1.w + s * (arc.c2.w + s * (arc.c3.w + s * (arc.c4.w + s * arc.c5.w)))) - (zeta - arc.c0.w));
#else
    return 0.0;
#endif
}

vec4 spin_slope_at(SpinArc arc, float s) {
    return arc.c1 + s * (2.0 * arc.c2 + s * (3.0 * arc.c3 + s * (4.0 * arc.c4 + s * (5.0 * arc.c5))));
}

// A sum from 0 to s of what is known at Lobatto's five points of a step, as a polynomial of t = 2 s - 1.
struct SpinSum {
    float c0;   // of what is summed: c0 + c1 t + ... + c4 t^4
    float c1;
    float c2;
    float c3;
    float c4;
};

#define LOBATTO_POINT 0.17267316464601143   // the points: 0, this, 1/2, 1 - this, 1

SpinSum spin_sum(float d0, float d1, float d2, float d3, float d4) {
    float near = 0.5 * (d1 + d3) - d2;
    float far = 0.5 * (d0 + d4) - d2;
    float odd = 0.76376261582597333 * (d3 - d1);   // sqrt(7/3)/2: the points are at t^2 = 3/7
    SpinSum sum;
    sum.c0 = d2;
    sum.c4 = (49.0 / 12.0) * ((3.0 / 7.0) * far - near);
    sum.c2 = far - sum.c4;
    sum.c3 = 1.75 * (0.5 * (d4 - d0) - odd);
    sum.c1 = 0.5 * (d4 - d0) - sum.c3;
    return sum;
}

float spin_sum_to(SpinSum sum, float s) {
    float t = 2.0 * s - 1.0;
    float even = sum.c0 + t * t * (sum.c2 * (1.0 / 3.0) + t * t * (sum.c4 * 0.2));
    float start = sum.c0 + sum.c2 * (1.0 / 3.0) + sum.c4 * 0.2;
    float more = 2.0 * s * (t - 1.0);   // t^2 - 1
    return 0.5 * (t * even + start + more * (0.5 * sum.c1 + 0.25 * sum.c3 * (t * t + 1.0)));
}

// A step, and what is summed over it. The azimuth is Boyer and Lindquist's anywhere outside the horizon: psi + winding * (what is left of
// int a/Delta dr to the sky).
struct SpinSegment {
    SpinArc arc;
    float h;
    float psi;        // at its start
    SpinSum turn;
    float winding;    // 1 where psi belongs to the ingoing azimuth, -1 where phi winds up towards the past horizon
#ifdef NEEDS_LIGHT_TIMES
    bool keeps;
    float travel_time;
    int afar;
    vec3 start;       // zeta, zeta', fine
    SpinSum travel_times;
#endif
};

float segment_turning(SpinRay ray, SpinState from, bool inward, vec4 y, float fine, float slope) {
    float regular = spin_regular_drag(ray, y.w, fine, slope);
    float turning = spin_turning(ray, from, y.w, fine);
    return inward ? regular : turning;
}

SpinSegment spin_segment(SpinRay ray, SpinState from, SpinState to, float h) {
    SpinSegment segment;
    segment.arc = spin_arc(from, to, h);
    segment.h = h;
    bool inward = from.v.w > 0.0 && to.v.w > 0.0;
    vec4 y1 = spin_at(segment.arc, LOBATTO_POINT);
    vec4 y2 = spin_at(segment.arc, 0.5);
    vec4 y3 = spin_at(segment.arc, 1.0 - LOBATTO_POINT);
    float fine1 = spin_fine_at(segment.arc, LOBATTO_POINT, y1.w);
    float fine2 = spin_fine_at(segment.arc, 0.5, y2.w);
    float fine3 = spin_fine_at(segment.arc, 1.0 - LOBATTO_POINT, y3.w);
    segment.turn = spin_sum(h * segment_turning(ray, from, inward, from.y, spin_fine_of(from), from.v.w), h * segment_turning(ray, from, inward, y1, fine1, spin_slope_at(segment.arc, LOBATTO_POINT).w / h),
                        h * segment_turning(ray, from, inward, y2, fine2, spin_slope_at(segment.arc, 0.5).w / h),
                        h * segment_turning(ray, from, inward, y3, fine3, spin_slope_at(segment.arc, 1.0 - LOBATTO_POINT).w / h), h * segment_turning(ray, from, inward, to.y, spin_fine_of(to), to.v.w));
    segment.winding = inward ? -1.0 : 0.0;
    float wound = spin_winding(ray, from.y.w, spin_fine_of(from));
    segment.psi = from.psi + (inward ? wound : 0.0);
#ifdef EFFECT_SPIN_FALL
    segment.winding = from.ingoing ? 1.0 : segment.winding;
#endif
#ifdef NEEDS_LIGHT_TIMES
    segment.keeps = travel_time_keeps(ray, from, to);
    segment.travel_time = from.travel_time;
    segment.afar = from.afar;
    segment.start = vec3(from.y.w, from.v.w, spin_fine_of(from));
    segment.travel_times = spin_sum(h * travel_time_rate(ray, segment.keeps, from.y, spin_fine_of(from)), h * travel_time_rate(ray, segment.keeps, y1, fine1), h * travel_time_rate(ray, segment.keeps, y2, fine2), h * travel_time_rate(ray, segment.keeps, y3, fine3),
                        h * travel_time_rate(ray, segment.keeps, to.y, spin_fine_of(to)));
#endif
    return segment;
}

// Azimuth of Boyer and Lindquist less that of n. y: spin_at(segment.arc, s)
float segment_turned(SpinRay ray, SpinSegment segment, float s, vec4 y) {
    return segment.psi + spin_sum_to(segment.turn, s) + segment.winding * spin_winding(ray, y.w, spin_fine_at(segment.arc, s, y.w));
}

// psi at its end: where phi winds up better than the step itself has it, for places next to the horizon.
float segment_psi(SpinRay ray, SpinSegment segment, SpinState to) { return segment.winding < 0.0 ? segment_turned(ray, segment, 1.0, to.y) : to.psi; }

#ifdef NEEDS_LIGHT_TIMES
// How long ago, by the camera's clock, the light left, less the camera's r.
float segment_delay(SpinRay ray, SpinSegment segment, float s, vec4 y) {
    float climb = spin_slope_at(segment.arc, s).w / segment.h;
    float travel_time = segment.travel_time + travel_time_jump(ray, segment.keeps, segment.afar, segment.start, vec3(y.w, climb, spin_fine_at(segment.arc, s, y.w))) + spin_sum_to(segment.travel_times, s);
    float radius = spin_tortoise(ray, max(y.w, 1.0e-12), spin_fine_at(segment.arc, s, y.w));
    float from_near = travel_time + radius - frame.delay.z;
    float from_afar = travel_time + (segment.keeps && segment.afar == AFAR_INWARD ? -radius : radius) + frame.delay.x;
    return segment.afar == AFAR_NOT ? from_near : from_afar;
}
#endif

#ifdef EFFECT_DISC
#ifndef EFFECT_DISC_LEAN
// Newton's step towards n_z = 0.
float spin_newton(SpinArc arc, float s) {
    float slope = spin_slope_at(arc, s).z;
    return clamp(s - spin_at(arc, s).z / (abs(slope) > 1.0e-30 ? slope : 1.0e-30), 0.0, 1.0);
}

// Within a step that begins at Mino's time tau and between whose ends n_z changes its sign.
DiscCrossing spin_crossing(SpinRay ray, SpinState from, SpinState to, float h, float tau) {
    SpinSegment segment = spin_segment(ray, from, to, h);
    float change = from.y.z - to.y.z;
    float s = clamp(from.y.z / (abs(change) > 1.0e-30 ? change : 1.0e-30), 0.0, 1.0);
    s = spin_newton(segment.arc, s);
    s = spin_newton(segment.arc, s);
    s = spin_newton(segment.arc, s);
    s = spin_newton(segment.arc, s);
    vec4 at = spin_at(segment.arc, s);
    float psi = segment_turned(ray, segment, s, at);
    float inverse = inversesqrt(max(at.x * at.x + at.y * at.y, 1.0e-30));
    vec2 turn = sine_cosine(psi) * inverse;
    float c = turn.y;
    float t = turn.x;
    DiscCrossing crossing = no_crossing();
    crossing.phi = tau + s * h;
    crossing.r = 1.0 / max(at.w, 1.0e-12);
    crossing.place = crossing.r * vec2(c * at.x - t * at.y, t * at.x + c * at.y);
    crossing.climb = spin_slope_at(segment.arc, s).w / h;
#ifdef NEEDS_RISE
    crossing.rise = spin_slope_at(segment.arc, s).z / h;
#endif
#ifdef NEEDS_LIGHT_TIMES
    crossing.delay = segment_delay(ray, segment, s, at);
#endif
    return crossing;
}
#endif
#endif
