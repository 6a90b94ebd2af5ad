// For methods that deliver phi itself: trigonometry, and the stretch from the neighbouring pixels.
#include "shared/frame.glsl"
#include "core/strip.glsl"
#include "core/sweep.glsl"
#ifdef NEEDS_FOOTPRINT
#include "core/trig.glsl"
#include "shared/quad_step.glsl"
#endif

Sweep sweep_by_angle(float phi, float s, float c) {
    Sweep sweep;
    sweep.cos_phi = cos(phi);
    sweep.ratio = s > 1.0e-6 ? sin(phi) / s : phi / max(s, 1.0e-30);
#ifdef NEEDS_FOOTPRINT
    float theta = arc_tangent2(s, c);
    QuadStep beside = quad_step(vec4(phi, theta, 0.0, 0.0));
    vec2 phi_step = vec2(beside.along.x, beside.across.x);
    vec2 theta_step = vec2(beside.along.y, beside.across.y);
    sweep.along = sqrt(dot(phi_step, phi_step) / max(dot(theta_step, theta_step), 1.0e-20));
#else
    sweep.along = 1.0;
#endif
    return sweep;
}

// 1 - k^2 of the ray, k = q/q_crit = sin(theta_c)/s, as a product: exact next to the critical ray.
float one_minus_k2_of(StripRay ray, float s, float c) {
    return ray.sine * (-frame.strip.x * s - frame.strip.y * c) / max(s * s, 1.0e-30);
}
