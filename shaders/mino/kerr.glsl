// Light about a rotating hole, step by step. Units r_s = 1 (M = 1/2); a: angular momentum over mass; zeta = 1/r.
//
// In Mino's time tau (d lambda = Sigma d tau) radius and polar angle part, and with a unit vector n on the sphere instead of polar
// angle and azimuth every right side is a polynomial: no turning point, no pole, no sign to choose. For the tangent of a ray traced
// backward, with energy E, L_z = L, Carter's K and Q, J^2 = Q + L^2 (E and L those of the photon, negated):
//     zeta'' = (a^2 E^2 - J^2) zeta + (3/2) K zeta^2 - 2 (a^2 Q + c K) zeta^3
//     n''    = -(J^2 + 2 a^2 E^2 n_z^2) n + a^2 E^2 n_z e_z            (a Neumann oscillator: |n| = 1 stays)
//     psi'   = a zeta (E - (a L + c E) zeta) / ((1 - r_+ zeta)(1 - r_- zeta))  (frame dragging; 0 far away)
// with c = (charge/2M)^2, 0 for Kerr: 2 m(r) = 1 - c zeta, and r_+ r_- = a^2 + c.
// The azimuth of Boyer and Lindquist is that of n and psi added up. Without spin n turns at the rate J, as on every plane orbit.
//
// Where a camera falls, rays that are traced outward from it come through the horizon, where that azimuth winds without end. There psi
// belongs to the ingoing one, phi~ = phi + int a/Delta dr (observer/spin_frame.h): with X = a L zeta^2 - E (1 + a^2 zeta^2) > 0 and
// zeta'^2 = X^2 - Delta zeta^4 K
//     psi~' = -a (E + K zeta^2 / (X - zeta')),   zeta' < 0,
// until the horizon is some way behind, or the ray slows down to turn, where zeta' by a root would lose its digits.
#ifdef EFFECT_SPIN_RING
#include "mino/ring.glsl"
#define NEEDS_FINE_ZETA      // zeta + fine, more digits than a float's
#endif
#ifdef EFFECT_SPIN_NEAR
#include "mino/near.glsl"
#define NEEDS_FINE_ZETA
#define NEEDS_FINE_AZIMUTH
#endif
#include "shared/frame.glsl"

struct SpinRay {
    float a;
    float a2e2;       // a^2 E^2
    float j2;         // J^2; below 0 for rays that stay about the axis
    float k;          // K >= 0
    float cubic;      // a^2 Q + c K
    float pull;       // a L + c E
    float a2c;        // a^2 + c
    float energy;     // of the tangent: minus the photon's
    float momentum;   // L, the same
    float outer;      // radii of the horizons
    float inner;
#ifdef EFFECT_SPIN_RING
    RingBarrier barrier;
#endif
#ifdef EFFECT_SPIN_NEAR
    NearHorizon near;
#endif
};

// y = (n, zeta), v = y', f = y'' in Mino's time; drag = psi'.
struct SpinState {
    vec4 y;
    vec4 v;
    vec4 f;
#ifdef NEEDS_FINE_ZETA
    float fine;       // of zeta
#endif
    float psi;
    float drag;
#ifdef NEEDS_LIGHT_TIMES
    float travel_time;        // T: v at the camera less v here, but for what `afar` says
    int afar;                 // AFAR_NOT ...
#endif
#ifdef EFFECT_SPIN_FALL
    bool ingoing;     // psi belongs to phi~
#endif
#ifdef EFFECT_DISC_LEAN
    vec2 height;      // of n over the disc's plane, and its slope: where the walk of the ray needs it
#endif
};

#ifdef NEEDS_FINE_ZETA
// A float sum is rounded, whatever a compiler that takes (a + b) - a for b may think: what the host gives is far below every zeta.
#ifdef EFFECT_SPIN_RING
float rounded_sum(float zeta, float more) { return max(zeta + more, frame.ring_peak_3.w); }
#else
float rounded_sum(float zeta, float more) { return max(zeta + more, frame.spin_near_2.w); }
#endif

float spin_fine_of(SpinState at) { return at.fine; }
#else
float spin_fine_of(SpinState at) { return 0.0; }
#endif

// fine: of zeta, here and below; 0 but next to the critical curve and the horizon.
vec4 spin_force(SpinRay ray, vec4 y, float fine) {
    float across = -(ray.j2 + 2.0 * ray.a2e2 * y.z * y.z);
#ifdef EFFECT_SPIN_NEAR
    float outward = near_force(ray.near, ray.k, y.w, fine);
#else
    float outward = y.w * (ray.a2e2 - ray.j2 + y.w * (1.5 * ray.k - 2.0 * ray.cubic * y.w));
#endif
#ifdef EFFECT_SPIN_RING
    float w = ring_offset(ray.barrier, y.w, fine);
    outward = abs(w) < ray.barrier.beside ? ring_force(ray.barrier, w) : outward;
#endif
    return vec4(across * y.x, across * y.y, (across + ray.a2e2) * y.z, outward);
}

// 1 - r_+ zeta and 1 - r_- zeta.
vec2 spin_above(SpinRay ray, float zeta, float fine) {
#ifdef EFFECT_SPIN_NEAR
    float above = near_above(ray.near, zeta, fine);
    return vec2(above, near_below(ray.near, above));
#else
    return vec2(1.0 - ray.outer * zeta, 1.0 - ray.inner * zeta);
#endif
}

// Delta zeta^2, a product: exact next to the horizon.
float spin_delta(SpinRay ray, float zeta, float fine) {
    vec2 above = spin_above(ray, zeta, fine);
    return above.x * above.y;
}

// X of the photon: E (r^2 + a^2) - a L over r^2; above 0 on this side of the horizons.
float spin_x(SpinRay ray, float zeta, float fine) {
#ifdef EFFECT_SPIN_NEAR
    return near_x(ray.near, zeta, near_above(ray.near, zeta, fine));
#else
    return ray.a * ray.momentum * zeta * zeta - ray.energy * (1.0 + ray.a * ray.a * zeta * zeta);
#endif
}

float spin_drag(SpinRay ray, float zeta, float fine) {
#ifdef EFFECT_SPIN_NEAR
    return -ray.a * (ray.energy + spin_x(ray, zeta, fine) / spin_delta(ray, zeta, fine));
#else
    return ray.a * zeta * (ray.energy - ray.pull * zeta) / spin_delta(ray, zeta, fine);
#endif
}

// phi' less that of int a/Delta dr along the ray's own sense, inward or outward, with speed |zeta'| = sqrt(X^2 - Delta zeta^4 K): regular at
// the horizon that lies there.
float spin_regular_drag(SpinRay ray, float zeta, float fine, float speed) {
    return -ray.a * (ray.energy + ray.k * zeta * zeta / max(spin_x(ray, zeta, fine) + speed, 1.0e-12));
}

// int a/Delta dr from zeta on to the sky: a/(r_+ - r_-) log(above.y/above.x), by a series where the logarithm is small. Of nearly
// extremal holes the factor is large.
float spin_winding(SpinRay ray, float zeta, float fine) {
    vec2 above = spin_above(ray, zeta, fine);
    float open = zeta / max(above.x, 1.0e-12);
    float more = frame.spin_turn.w * open;
    float s = more / (2.0 + more);
    float z = s * s;
    float by_series = ray.a * open * (2.0 / (2.0 + more)) * (1.0 + z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * (1.0 / 11.0))))));
    float by_log = frame.spin_turn.y * log(max(above.y, 1.0e-12) / max(above.x, 1.0e-12));
    return more < 0.5 ? by_series : by_log;
}

#ifdef NEEDS_FINE_AZIMUTH
// By how much it is more from zeta on than from to_zeta on.
float spin_wound(SpinRay ray, float zeta, float fine, float to_zeta, float to_fine) {
#ifdef EFFECT_SPIN_NEAR
    return frame.spin_turn.y * near_log(ray.near, near_above(ray.near, zeta, fine), near_above(ray.near, to_zeta, to_fine));
#else
    return spin_winding(ray, zeta, fine) - spin_winding(ray, to_zeta, to_fine);
#endif
}

// spin_regular_drag at zeta inside a step that keeps on inward or outward.
float spin_level_turning(SpinRay ray, float zeta, float fine) {
    float x = spin_x(ray, zeta, fine);
    return spin_regular_drag(ray, zeta, fine, sqrt(max(x * x - spin_delta(ray, zeta, fine) * ray.k * zeta * zeta, 0.0)));
}
#endif

#ifdef EFFECT_SPIN_FALL
float ingoing_speed2(SpinRay ray, float zeta, float fine, float x) { return x * x - spin_delta(ray, zeta, fine) * ray.k * zeta * zeta; }

// psi' at zeta inside a step.
float spin_turning(SpinRay ray, SpinState from, float zeta, float fine) {
    float speed = sqrt(max(ingoing_speed2(ray, zeta, fine, spin_x(ray, zeta, fine)), 0.0));
    return from.ingoing ? spin_regular_drag(ray, zeta, fine, speed) : spin_drag(ray, zeta, fine);
}

float spin_turning_at(SpinRay ray, SpinState at) {
    float fine = spin_fine_of(at);
    return at.ingoing ? spin_regular_drag(ray, at.y.w, fine, -at.v.w) : spin_drag(ray, at.y.w, fine);
}

#define INGOING_DELTA 0.1    // Delta zeta^2 from which on the horizon is behind
#define INGOING_DEEP 8.0    // of a step inside the horizon
#define INGOING_SLOW 0.5     // zeta'^2 over X^2: the next step ends before the turn
bool ingoing_stays(SpinRay ray, SpinState at) {
    float fine = spin_fine_of(at);
    float slope = at.v.w;
    float x = spin_x(ray, at.y.w, fine);
    return spin_above(ray, at.y.w, fine).x <= 0.0 || (slope <= 0.0 && spin_delta(ray, at.y.w, fine) <= INGOING_DELTA && slope * slope >= INGOING_SLOW * x * x);
}
#else
float spin_turning(SpinRay ray, SpinState from, float zeta, float fine) { return spin_drag(ray, zeta, fine); }
float spin_turning_at(SpinRay ray, SpinState at) { return spin_drag(ray, at.y.w, spin_fine_of(at)); }
#endif

#ifdef NEEDS_LIGHT_TIMES
// How long light takes. With X (spin_x) of the photon, delta = Delta zeta^2 and |zeta'|^2 = X^2 - delta zeta^2 K the time t from the camera
// has, along the ray inward or outward, t' = D' -+ r_*', and T = v_cam - v, v = t + r_*, grows by
//     D' = (1 + a^2 zeta^2) K/(X + |zeta'|) + a (L - a E (1 - n_z^2))
// outward, and inward by 2 (r_* - r_*') more: regular at the horizon and at the sky. Where the ray turns |zeta'| has a kink; there, with
// -zeta'/(E zeta) taken off, which is all of it for straight light,
//     t' = (-zeta'/(E zeta))' + X (X (1/zeta - a^2 - c) + a L)/(E delta) + delta K/E + zeta''/(E zeta) + a (L - a E (1 - n_z^2)).
// Of rays that come in from afar T is some 2 r: floats have no digits left for what it is next to the hole. They hold T + 2 r_* on their way in,
// and T from where they may turn, both less 2 r_* of the camera (frame.delay.w).
#define AFAR_NOT 0
#define AFAR_TURNED 1
#define AFAR_INWARD 2
#define LAG_SLOW 0.1         // |zeta'|^2 over X^2 below which a ray may be about to turn
#define LAG_LEAST_ENERGY 1.0e-3

// r_*
float spin_tortoise(SpinRay ray, float zeta, float fine) {
    float above = max(spin_above(ray, zeta, fine).x, 1.0e-7);
    return 1.0 / zeta - log(zeta) + log(above) - (ray.inner - frame.spin_turn.z) * (spin_winding(ray, zeta, fine) / ray.a);
}

bool travel_time_is_level(SpinRay ray, float zeta, float fine, float slope) {
    float x = spin_x(ray, zeta, fine);
    return slope * slope > LAG_SLOW * x * x;
}

// Of a step between two states: does the ray keep on inward or outward, clear of a turn?
bool travel_time_keeps(SpinRay ray, SpinState from, SpinState to) {
    return from.v.w * to.v.w > 0.0 && travel_time_is_level(ray, from.y.w, spin_fine_of(from), from.v.w) && travel_time_is_level(ray, to.y.w, spin_fine_of(to), to.v.w);
}

float travel_time_rate(SpinRay ray, bool keeps, vec4 y, float fine) {
    float zeta = y.w;
    float x = spin_x(ray, zeta, fine);
    float delta = spin_delta(ray, zeta, fine);
    float round = ray.a * (ray.a * ray.energy * (1.0 - y.z * y.z) - ray.momentum);
    float speed = sqrt(max(x * x - delta * zeta * zeta * ray.k, 0.0));
    float level = (1.0 + ray.a * ray.a * zeta * zeta) * ray.k / max(x + speed, 1.0e-12);
    float energy = max(-ray.energy, LAG_LEAST_ENERGY);
    float inverse = 1.0 / max(zeta, 1.0e-12);
    float turning = x * (x * (inverse - ray.a2c) - ray.a * ray.momentum) / (energy * max(delta, 1.0e-7)) + delta * ray.k / energy + spin_force(ray, y, fine).w * inverse / energy;
    return round + (keeps ? level : turning);
}

// What T grows by beside the integral of travel_time_rate, from (zeta, zeta', fine) to (zeta, zeta', fine).
float travel_time_jump(SpinRay ray, bool keeps, int afar, vec3 from, vec3 to) {
    bool outward = from.y < 0.0;
    float low = max(from.x, 1.0e-12);
    float high = max(to.x, 1.0e-12);
    float radii = spin_tortoise(ray, low, from.z) - spin_tortoise(ray, high, to.z);
    float twice = 2.0 * radii;
    bool comes_in = afar == AFAR_INWARD;
    float level = outward || comes_in ? 0.0 : twice;
    float energy = max(-ray.energy, LAG_LEAST_ENERGY);
    float before = comes_in ? 2.0 * spin_tortoise(ray, low, from.z) : 0.0;
    float turning = radii + (from.y / low - to.y / high) / energy - before;
    return keeps ? level : turning;
}
#endif
