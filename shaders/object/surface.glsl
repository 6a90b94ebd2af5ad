// A solid given by a formula, f(x, y, z) < 0, as far as a sphere about the centre. Marched along is f itself; its distance, close to the
// surface, is f over the length of its gradient. This text is written once for each of a scene's formulas, with BODY its name; BODY_MOVES:
// the formula asks for the time t. Its form: bound, step, the first of its cells in the clearance texture or -1, time.
#include "effect/expression.glsl"
#include "object/clearance.glsl"
#ifdef BODY_MOVES
#include "object/unseen.glsl"
#endif
#include "path/place"
#include "shared/objects.glsl"

#define BODY_DIFFERENCE 1.0e-3   // of the bound: gradients by differences keep half of a float's digits

float BODY_inside(int i, vec3 at, float t) {   // below 0 inside
    float x = at.x;
    float y = at.y;
    float z = at.z;
BODY_STATEMENTS
    return max(value, sqrt(dot(at, at)) - body_form(i).x);
}

vec3 BODY_gradient(int i, vec3 at, float t) {
    float h = BODY_DIFFERENCE * body_form(i).x;
    return vec3(BODY_inside(i, at + vec3(h, 0.0, 0.0), t) - BODY_inside(i, at - vec3(h, 0.0, 0.0), t),
                BODY_inside(i, at + vec3(0.0, h, 0.0), t) - BODY_inside(i, at - vec3(0.0, h, 0.0), t),
                BODY_inside(i, at + vec3(0.0, 0.0, h), t) - BODY_inside(i, at - vec3(0.0, 0.0, h), t)) * (0.5 / h);
}

float BODY_time(int i, RayPlace place) {
#ifdef BODY_MOVES
#ifdef NEEDS_PLACE_LATE
    return body_form(i).w - place.delay;
#else
    return body_form(i).w;
#endif
#else
    return 0.0;
#endif
}

vec3 BODY_slope(int i, RayPlace place) {
    return clamp(BODY_gradient(i, place.at, BODY_time(i, place)), vec3(-1.0e15), vec3(1.0e15));
}

float BODY_value(int i, RayPlace place) {
    float value = BODY_inside(i, place.at, BODY_time(i, place));
#ifdef BODY_MOVES
    value = max(value, solid_unseen(place.r));
#endif
    return value;
}

// By how much more it changes than the distance.
float BODY_steepness(int i, RayPlace place) {
    vec3 slope = BODY_slope(i, place);
    return max(sqrt(dot(slope, slope)), 1.0e-12);
}
float BODY_distance(int i, RayPlace place) { return BODY_value(i, place) / BODY_steepness(i, place); }

// How far it is at least: to the bounding sphere, and as far as the cells about the place are empty.
float BODY_clear(int i, RayPlace place) {
    vec4 form = body_form(i);
    return max(sqrt(dot(place.at, place.at)) - form.x, clearance(place.at, form.x, form.z));
}

// How far a step may go; close to the solid not by f, which need not be a distance.
float BODY_room(int i, RayPlace place) { return max(BODY_clear(i, place), body_form(i).y); }

float BODY_size(int i) { return body_form(i).x; }
vec3 BODY_middle(int i, RayPlace place) { return vec3(0.0); }
vec3 BODY_normal(int i, RayPlace place) {
    vec3 slope = BODY_slope(i, place);
    return slope / max(sqrt(dot(slope, slope)), 1.0e-12);
}

#ifdef EFFECT_GLOW
#ifdef BODY_MOVES
#define BODY_TICK 0.05   // r_s/c: over which its motion is taken
// dx/dt of its surface, along the normal, when the light left.
vec3 BODY_velocity(int i, RayPlace place) {
    float t = BODY_time(i, place);
    float rate = (BODY_inside(i, place.at, t + BODY_TICK) - BODY_inside(i, place.at, t - BODY_TICK)) * (0.5 / BODY_TICK);
    vec3 slope = BODY_slope(i, place);
    return slope * (-rate / max(dot(slope, slope), 1.0e-12));
}
#endif
#endif
