// For methods that deliver phi itself: trigonometry, and the stretch from the neighbouring pixels.
Sweep sweep_by_angle(float phi, float theta, float s) {
    Sweep sweep;
    sweep.cos_phi = cos(phi);
    sweep.ratio = s > 1.0e-6 ? sin(phi) / s : phi / max(s, 1.0e-30);
#ifdef NEEDS_FOOTPRINT
    vec2 phi_step = vec2(dFdx(phi), dFdy(phi));
    vec2 theta_step = vec2(dFdx(theta), dFdy(theta));
    sweep.along = sqrt(dot(phi_step, phi_step) / max(dot(theta_step, theta_step), 1.0e-20));
#else
    sweep.along = 1.0;
#endif
    return sweep;
}

// 1 - k^2 of the ray, k = q/q_crit, as a product: exact next to the critical ray.
float one_minus_k2_of(StripRay ray, float s) {
    float signed_w = (ray.escapes ? ray.w : -ray.w) * frame.strip.z;   // theta - theta_c
    return sin(signed_w) * sin(ray.theta + frame.strip.x) / max(s * s, 1.0e-30);
}
