// Where a ray about a rotating hole is within a step (mino/segment.glsl), in flat coordinates about the centre: for solid bodies. In place of
// place.glsl, for rays that stay in planes.
#include "core/trig.glsl"
#include "mino/segment.glsl"
#include "shared/frame.glsl"

struct RayPlace {
    vec3 at;          // r_s, world axes; azimuth of Boyer and Lindquist
    vec3 outward;     // unit vector from the centre to it
    vec3 velocity;    // d(at)/ds, s the fraction of the step
    float r;
#ifdef NEEDS_PLACE_LATE
    float delay;       // how long ago the light left that is seen now; 0 where things are seen at once
#endif
#ifdef NEEDS_PLACE_TIME
    float light_time;  // that light took, whenever what it left is seen
#endif
};

vec3 place_turned(vec3 v, float c, float s) { return vec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z); }

// s: 0 ... 1, and a little before: the end of the step before.
RayPlace segment_place(SpinRay ray, SpinSegment segment, float s) {
    vec4 y = spin_at(segment.arc, s);
    vec4 slope = spin_slope_at(segment.arc, s);
    float zeta = max(y.w, 1.0e-10);
    float psi = segment_turned(ray, segment, s, y);
    vec2 turn = sine_cosine(psi);
    float c = turn.y;
    float t = turn.x;
    RayPlace place;
    place.r = 1.0 / zeta;
    place.outward = place_turned(vec3(y.x, y.y, y.z), c, t);
    place.at = place.r * place.outward;
    float turning = spin_drag(ray, zeta, spin_fine_at(segment.arc, s, y.w)) * segment.h;
    turning = ray.outer * zeta < 1.0 ? turning : 0.0;
    place.velocity = place.r * (place_turned(vec3(slope.x, slope.y, slope.z), c, t) + turning * vec3(-place.outward.y, place.outward.x, 0.0) -
                                (slope.w * place.r) * place.outward);
#ifdef NEEDS_PLACE_TIME
    place.light_time = segment_delay(ray, segment, s, vec4(y.x, y.y, y.z, zeta));
#endif
#ifdef NEEDS_PLACE_LATE
#ifdef EFFECT_DELAY
    place.delay = segment_delay(ray, segment, s, vec4(y.x, y.y, y.z, zeta));
#else
    place.delay = 0.0;
#endif
#endif
    return place;
}

float place_speed(RayPlace place) { return sqrt(dot(place.velocity, place.velocity)); }
vec3 place_velocity(RayPlace place) { return place.velocity; }

// The part of a step that is `length` more along the ray, taken as straight.
float place_part(RayPlace place, float length) {
    float speed = max(place_speed(place), 1.0e-20);
    float outward = dot(place.velocity, place.outward) / speed;
    vec3 across = place.velocity - (outward * speed) * place.outward;
    float round = max(sqrt(dot(across, across)) / speed, 1.0e-7);
    return arc_tangent2(length * round, max(place.r + length * outward, 1.0e-6)) * place.r / (speed * round);
}

#ifdef NEEDS_PLACE_LATE
// The most that light needs for a length there: (r^2 + a^2)/Delta.
#define PLACE_SLOWEST 1.0e6
float place_slowness(RayPlace place) {
#ifdef EFFECT_DELAY
    float zeta = 1.0 / place.r;
    float delta = (1.0 - frame.spin_hole.z * zeta) * (1.0 - frame.spin_hole.w * zeta);
    return (1.0 + frame.spin_hole.y * zeta * zeta) / max(delta, 1.0 / PLACE_SLOWEST);
#else
    return 1.0;
#endif
}
#endif
