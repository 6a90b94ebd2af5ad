// How fast the disc's matter goes round.
#include "path/trace"
#include "shared/frame.glsl"

#ifdef EFFECT_RING_RATES
// A polynomial and its slope, by Horner's rule: four more terms, the highest in w.
vec2 disc_rate_terms(vec2 sum, float x, vec4 terms) {
    sum = vec2(sum.x * x + terms.w, sum.y * x + sum.x);
    sum = vec2(sum.x * x + terms.z, sum.y * x + sum.x);
    sum = vec2(sum.x * x + terms.y, sum.y * x + sum.x);
    return vec2(sum.x * x + terms.x, sum.y * x + sum.x);
}

// P and zeta dP/dzeta: a polynomial in x, which grows with ln r from -1 at the disc's inner edge to 1 at its outer one (table/disc_rate.h).
vec2 disc_rate(float zeta) {
    float x = clamp(-(log(zeta) + frame.disc_rate_span.x) * frame.disc_rate_span.y, -1.0, 1.0);
    vec2 sum = disc_rate_terms(vec2(0.0), x, frame.disc_rate_2);
    sum = disc_rate_terms(disc_rate_terms(sum, x, frame.disc_rate_1), x, frame.disc_rate_0);
    return vec2(sum.x, -frame.disc_rate_span.y * sum.y);
}
#else
// P = z - w zeta of disc_winding, and zeta dP/dzeta.
vec2 disc_rate(float zeta) { return vec2(frame.disc_winding.z, 0.0) - frame.disc_winding.w * zeta; }
#endif

#ifdef EFFECT_DISC_LEAN
float disc_spin() { return path_spin() * frame.disc_normal.z; }   // spacetime/leaning_circle.h
#else
#define disc_spin() path_spin()
#endif

// Omega of circular orbits and its slope by zeta = 1/r. Omega = s w/(1 + s a w), w^2 = zeta^3 P, s = 1 or -1: towards growing phi or falling phi.
vec2 disc_orbit(float zeta) {
    vec2 p = disc_rate(zeta);
    float w = sqrt(max(zeta * zeta * zeta * p.x, 0.0));
    float w_slope = 0.5 * zeta * zeta * (3.0 * p.x + p.y) / max(w, 1.0e-20);
    float sense = frame.disc_copy.y;
    float dragged = 1.0 / (1.0 + sense * disc_spin() * w);
    return vec2(w, w_slope * dragged) * (sense * dragged);
}
