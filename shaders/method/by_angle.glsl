// For methods that deliver phi itself: trigonometry, and the stretch from the neighbouring pixels.
#include "shared/frame.glsl"
#include "core/strip.glsl"
#include "core/sweep.glsl"
#ifdef NEEDS_FOOTPRINT
#include "core/trig.glsl"
#endif

Sweep sweep_by_angle(float phi, float s, float c) {
    Sweep sweep;
    sweep.cos_phi = cos(phi);
    sweep.ratio = s > 1.0e-6 ? sin(phi) / s : phi / max(s, 1.0e-30);
#ifdef NEEDS_FOOTPRINT
    float theta = arc_tangent2(s, c);
    vec2 phi_step = vec2(dFdx(phi), dFdy(phi));
    vec2 theta_step = vec2(dFdx(theta), dFdy(theta));
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
