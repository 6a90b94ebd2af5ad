// How high a ray about a rotating hole is over the plane of a disc that leans from its equator (mino/leaning.glsl).
#include "core/trig.glsl"
#include "mino/kerr.glsl"
#include "shared/frame.glsl"

#define LEANING_ON 4.0e-7   // heights below are roundings: a camera or a ray in the plane

// The disc's normal along the axes that n has after psi.
vec3 leaning_normal(float psi) {
    vec2 turn = sine_cosine(psi);
    vec3 normal = vec3(frame.disc_normal.x, frame.disc_normal.y, frame.disc_normal.z);
    return vec3(turn.y * normal.x + turn.x * normal.y, turn.y * normal.y - turn.x * normal.x, normal.z);
}

// Of n over the plane, and its slope where psi has the slope `drag`.
vec2 leaning_height(vec4 y, vec4 v, float psi, float drag) {
    vec3 normal = leaning_normal(psi);
    return vec2(dot(normal, vec3(y.x, y.y, y.z)), dot(normal, vec3(v.x, v.y, v.z)) + drag * (normal.y * y.x - normal.x * y.y));
}

vec2 leaning_off(vec2 height) { return vec2(abs(height.x) < LEANING_ON ? 0.0 : height.x, height.y); }

// At the end of a step. Within the horizon Boyer and Lindquist's azimuth is none: light that comes out is over no plane there.
#ifdef EFFECT_SPIN_FALL
vec2 leaning_end(SpinRay ray, SpinState at) {
    float fine = spin_fine_of(at);
    float above = spin_above(ray, at.y.w, fine).x;
    bool wound = at.ingoing && above > 0.0;
    float psi = at.psi + (wound ? spin_winding(ray, at.y.w, fine) : 0.0);
    float drag = wound ? spin_drag(ray, at.y.w, fine) : at.drag;
    vec2 height = leaning_off(leaning_height(at.y, at.v, psi, drag));
    return at.ingoing && above <= 0.0 ? vec2(0.0) : height;
}
#else
vec2 leaning_end(SpinRay ray, SpinState at) { return leaning_off(leaning_height(at.y, at.v, at.psi, at.drag)); }
#endif
