// g of a body's light, where rays stay in planes: by observers at rest along the ray. numbers: the second vector of object/glow.glsl.
//
// A photon has the energy 1/sqrt(A) to them, and goes in the direction (+-dr/sqrt(A), r dphi) of the ray or, of straight light, of the line; a
// body with the velocity w has sqrt(1 - w^2)/(1 - n . w) of its frequency, n where it goes to. A ball shines all over with energy and velocity of its middle.
#include "planar/place.glsl"
#include "planar/trace.glsl"

#define GLOW_LEAST 1.0e-7   // of A

float glow_lapse2(vec4 numbers, float r) {
    float zeta = 1.0 / r;
    return max(1.0 - zeta * (numbers.y - zeta * numbers.z), GLOW_LEAST);
}

float lapse_g(Trace trace, vec4 numbers, float lapse2) {
    bool gravity = numbers.w == 1.0 || numbers.w == 3.0;
    return g_of(trace) * (gravity ? sqrt(lapse2) : 1.0);
}

float rest_g(Trace trace, RayPlace place, vec4 numbers) { return lapse_g(trace, numbers, glow_lapse2(numbers, place.r)); }

// middle, velocity: where that is dx/dt.
float moving_g(Trace trace, RayPlace place, vec4 numbers, vec3 middle, vec3 velocity) {
    float r = max(sqrt(dot(middle, middle)), 1.0e-6);
    vec3 outward = middle / r;
    float lapse2 = glow_lapse2(numbers, r);
    float out_speed = dot(velocity, outward);
    vec3 w = (out_speed / lapse2) * outward + (velocity - out_speed * outward) * inversesqrt(lapse2);
    float steep = clamp(place.r_along / place.r, -1.0e15, 1.0e15);
#ifdef EFFECT_LENSING
    steep *= inversesqrt(glow_lapse2(numbers, place.r));
#endif
    vec3 back = (steep * place.outward + place.onward) * inversesqrt(steep * steep + 1.0);   // against the photon's
    float frequency = 1.0 + dot(back, w);
    float slow = max(1.0 - dot(w, w), 0.0);
    float doppler = frequency > 0.0 ? sqrt(slow) / max(frequency, 1.0e-12) : 0.0;
    return lapse_g(trace, numbers, lapse2) * (numbers.w >= 2.0 ? doppler : 1.0);
}
