// Light about a spinning hole, step by step. Units r_s = 1 (M = 1/2); a: angular momentum over mass; zeta = 1/r.
//
// In Mino's time tau (d lambda = Sigma d tau) radius and polar angle part, and with a unit vector n on the sphere instead of polar
// angle and azimuth every right side is a polynomial: no turning point, no pole, no sign to choose. For the tangent of a ray traced
// backward, with energy E, L_z = L, Carter's K and Q, J^2 = Q + L^2 (E and L those of the photon, negated):
//     zeta'' = (a^2 E^2 - J^2) zeta + (3/2) K zeta^2 - 2 a^2 Q zeta^3
//     n''    = -(J^2 + 2 a^2 E^2 n_z^2) n + a^2 E^2 n_z e_z            (a Neumann oscillator: |n| = 1 stays)
//     psi'   = a zeta (E - a L zeta) / ((1 - r_+ zeta)(1 - r_- zeta))  (dragging; 0 far away)
// The azimuth of Boyer and Lindquist is that of n and psi added up. Without spin n turns at the rate J, as on every plane orbit.
//
// Where a camera falls, rays that are traced outward from it come through the horizon, where that azimuth winds without end. There psi
// belongs to the ingoing one, phi~ = phi + int a/Delta dr (spacetime/spin_frame.h): with X = a L zeta^2 - E (1 + a^2 zeta^2) > 0 and
// zeta'^2 = X^2 - Delta zeta^4 K
//     psi~' = -a (E + K zeta^2 / (X - zeta')),   zeta' < 0,
// until the horizon is some way behind, or the ray slows down to turn, where zeta' by a root would lose its digits.

// A ray that winds for long is one whose end moves fast with its direction: its errors weigh less, and its steps may grow.
#ifndef METHOD_MINO
#define SPIN_STEP 0.6          // of a step, times the fastest rate at work there: twice the error at 0.7, half at 0.55
#define SPIN_MOST_STEPS 64
#define SPIN_GROW_AFTER 20
#define SPIN_GROWTH 0.07
#else                          // SPIN_STEP and SPIN_MOST_STEPS by the method; all steps of a ray in the same proportion
#define SPIN_SHARE (SPIN_STEP / 0.6)
#define SPIN_GROW_AFTER int(20.0 / SPIN_SHARE + 0.5)
#define SPIN_GROWTH (0.07 * SPIN_SHARE)
#endif

struct SpinRay {
    float a;
    float a2e2;       // a^2 E^2
    float j2;         // J^2; below 0 for rays that stay about the axis
    float k;          // K >= 0
    float a2q;        // a^2 Q
    float energy;     // of the tangent: minus the photon's
    float momentum;   // L, the same
    float outer;      // radii of the horizons
    float inner;
};

// y = (n, zeta), v = y', f = y'' in Mino's time; drag = psi'.
struct SpinState {
    vec4 y;
    vec4 v;
    vec4 f;
    float psi;
    float drag;
#ifdef EFFECT_DELAY
    float lag;        // T: v at the camera less v here
#endif
#ifdef EFFECT_SPIN_FALL
    bool ingoing;     // psi belongs to phi~
#endif
};

vec4 spin_force(SpinRay ray, vec4 y) {
    float across = -(ray.j2 + 2.0 * ray.a2e2 * y.z * y.z);
    return vec4(across * y.x, across * y.y, (across + ray.a2e2) * y.z,
                y.w * (ray.a2e2 - ray.j2 + y.w * (1.5 * ray.k - 2.0 * ray.a2q * y.w)));
}

// Delta zeta^2, a product: exact next to the horizon.
float spin_delta(SpinRay ray, float zeta) { return (1.0 - ray.outer * zeta) * (1.0 - ray.inner * zeta); }

float spin_drag(SpinRay ray, float zeta) {
    return ray.a * zeta * (ray.energy - ray.a * ray.momentum * zeta) / spin_delta(ray, zeta);
}

// X of the photon: E (r^2 + a^2) - a L over r^2; above 0 on this side of the horizons.
float spin_x(SpinRay ray, float zeta) {
    return ray.a * ray.momentum * zeta * zeta - ray.energy * (1.0 + ray.a * ray.a * zeta * zeta);
}

// phi' less that of int a/Delta dr along the ray's own sense, inward or outward, with speed |zeta'| = sqrt(X^2 - Delta zeta^4 K): regular at
// the horizon that lies there.
float spin_regular_drag(SpinRay ray, float zeta, float speed) {
    return -ray.a * (ray.energy + ray.k * zeta * zeta / max(spin_x(ray, zeta) + speed, 1.0e-12));
}

// int a/Delta dr from zeta on to the sky.
float spin_winding(SpinRay ray, float zeta) {
    return frame.spin_turn.y * log(max(1.0 - ray.inner * zeta, 1.0e-12) / max(1.0 - ray.outer * zeta, 1.0e-12));
}

#ifdef EFFECT_SPIN_FALL
float ingoing_speed2(SpinRay ray, float zeta, float x) { return x * x - spin_delta(ray, zeta) * ray.k * zeta * zeta; }

// psi' at zeta inside a step.
float spin_turning(SpinRay ray, SpinState from, float zeta) {
    float speed = sqrt(max(ingoing_speed2(ray, zeta, spin_x(ray, zeta)), 0.0));
    return from.ingoing ? spin_regular_drag(ray, zeta, speed) : spin_drag(ray, zeta);
}

float spin_turning_at(SpinRay ray, SpinState at) {
    return at.ingoing ? spin_regular_drag(ray, at.y.w, -at.v.w) : spin_drag(ray, at.y.w);
}

#define INGOING_DELTA 0.1    // Delta zeta^2 from which on the horizon is behind
#define INGOING_DEEP 8.0    // of a step inside the horizon
#define INGOING_SLOW 0.5     // zeta'^2 over X^2: the next step ends before the turn
bool ingoing_stays(SpinRay ray, float zeta, float slope) {
    float x = spin_x(ray, zeta);
    return ray.outer * zeta >= 1.0 || (slope <= 0.0 && spin_delta(ray, zeta) <= INGOING_DELTA && slope * slope >= INGOING_SLOW * x * x);
}
#else
float spin_turning(SpinRay ray, SpinState from, float zeta) { return spin_drag(ray, zeta); }
float spin_turning_at(SpinRay ray, SpinState at) { return spin_drag(ray, at.y.w); }
#endif

#ifdef EFFECT_DELAY
// How long light takes. With X (spin_x) of the photon, delta = Delta zeta^2 and |zeta'|^2 = X^2 - delta zeta^2 K the time t from the camera
// has, along the ray inward or outward, t' = D' -+ r_*', and T = v_cam - v, v = t + r_*, grows by
//     D' = (1 + a^2 zeta^2) K/(X + |zeta'|) + a (L - a E (1 - n_z^2))
// outward, and inward by 2 (r_* - r_*') more: regular at the horizon and at the sky. Where the ray turns |zeta'| has a kink; there, with
// -zeta'/(E zeta) taken off, which is all of it for straight light,
//     t' = (-zeta'/(E zeta))' + X (X (1/zeta - a^2) + a L)/(E delta) + delta K/E + zeta''/(E zeta) + a (L - a E (1 - n_z^2)).
#define LAG_SLOW 0.1         // |zeta'|^2 over X^2 below which a ray may be about to turn
#define LAG_LEAST_ENERGY 1.0e-3

// r_*
float spin_tortoise(SpinRay ray, float zeta) {
    float split = frame.spin_turn.y / ray.a;   // 1/(r_+ - r_-)
    return 1.0 / zeta - log(zeta) + split * (ray.outer * log(max(1.0 - ray.outer * zeta, 1.0e-7)) - ray.inner * log(max(1.0 - ray.inner * zeta, 1.0e-7)));
}

bool lag_is_level(SpinRay ray, float zeta, float slope) {
    float x = spin_x(ray, zeta);
    return slope * slope > LAG_SLOW * x * x;
}

// Of a step between two states: does the ray keep on inward or outward, clear of a turn?
bool lag_keeps(SpinRay ray, SpinState from, vec4 to_y, float to_slope) {
    return from.v.w * to_slope > 0.0 && lag_is_level(ray, from.y.w, from.v.w) && lag_is_level(ray, to_y.w, to_slope);
}

float lag_rate(SpinRay ray, bool keeps, vec4 y) {
    float zeta = y.w;
    float x = spin_x(ray, zeta);
    float delta = spin_delta(ray, zeta);
    float round = ray.a * (ray.a * ray.energy * (1.0 - y.z * y.z) - ray.momentum);
    float speed = sqrt(max(x * x - delta * zeta * zeta * ray.k, 0.0));
    float level = (1.0 + ray.a * ray.a * zeta * zeta) * ray.k / max(x + speed, 1.0e-12);
    float energy = max(-ray.energy, LAG_LEAST_ENERGY);
    float inverse = 1.0 / max(zeta, 1.0e-12);
    float turning = x * (x * (inverse - ray.a * ray.a) - ray.a * ray.momentum) / (energy * max(delta, 1.0e-7)) + delta * ray.k / energy + spin_force(ray, y).w * inverse / energy;
    return round + (keeps ? level : turning);
}

// What T grows by beside the integral of lag_rate, from (zeta, zeta') to (zeta, zeta').
float lag_jump(SpinRay ray, bool keeps, vec2 from, vec2 to) {
    bool outward = from.y < 0.0;
    float low = max(from.x, 1.0e-12);
    float high = max(to.x, 1.0e-12);
    float radii = keeps && outward ? 0.0 : spin_tortoise(ray, low) - spin_tortoise(ray, high);
    float energy = max(-ray.energy, LAG_LEAST_ENERGY);
    return keeps ? 2.0 * radii : radii + (from.y / low - to.y / high) / energy;
}
#endif

#ifdef METHOD_MINO_4
SpinState spin_step(SpinRay ray, SpinState from, float h);   // method/mino_4.glsl
#else
// One step of RKN6(4)6FM (Dormand, El-Mikkawy and Prince 1987): five new forces, the sixth is the next step's first.
SpinState spin_step(SpinRay ray, SpinState from, float h) {
    float hh = h * h;
    vec4 v = h * from.v;
    vec4 f0 = hh * from.f;
    vec4 y1 = from.y + 0.1 * v + f0 * (1.0 / 200.0);
    vec4 f1 = hh * spin_force(ray, y1);
    vec4 y2 = from.y + 0.3 * v - f0 * (1.0 / 2200.0) + f1 * (1.0 / 22.0);
    vec4 f2 = hh * spin_force(ray, y2);
    vec4 y3 = from.y + 0.7 * v + f0 * (637.0 / 6600.0) - f1 * (7.0 / 110.0) + f2 * (7.0 / 33.0);
    vec4 f3 = hh * spin_force(ray, y3);
    vec4 y4 = from.y + 0.68 * v + f0 * (225437.0 / 1968750.0) - f1 * (30073.0 / 281250.0) + f2 * (65569.0 / 281250.0) -
              f3 * (9367.0 / 984375.0);
    vec4 f4 = hh * spin_force(ray, y4);
    SpinState to;
    to.y = from.y + v + f0 * (151.0 / 2142.0) + f1 * (5.0 / 116.0) + f2 * (385.0 / 1368.0) + f3 * (55.0 / 168.0) -
           f4 * (6250.0 / 28101.0);
    to.f = spin_force(ray, to.y);
    to.v = from.v + (f0 * (151.0 / 2142.0) + f1 * (25.0 / 522.0) + f2 * (275.0 / 684.0) + f3 * (275.0 / 252.0) -
                     f4 * (78125.0 / 112404.0) + (hh / 12.0) * to.f) / h;
#ifdef EFFECT_SPIN_FALL
    to.ingoing = from.ingoing;
    // Rounding of a large zeta' deep inside is much, relative to what is left of it where rays wind: by the root while that is exact.
    float x = spin_x(ray, to.y.w);
    float speed2 = ingoing_speed2(ray, to.y.w, x);
    to.v.w = from.ingoing && to.v.w < 0.0 && speed2 > INGOING_SLOW * x * x ? -sqrt(speed2) : to.v.w;
#endif
    to.drag = spin_turning_at(ray, to);
#ifdef EFFECT_DELAY
    bool keeps = lag_keeps(ray, from, to.y, to.v.w);
    to.lag = from.lag + lag_jump(ray, keeps, vec2(from.y.w, from.v.w), vec2(to.y.w, to.v.w)) +
             h * (lag_rate(ray, keeps, from.y) * (151.0 / 2142.0) + lag_rate(ray, keeps, y1) * (25.0 / 522.0) + lag_rate(ray, keeps, y2) * (275.0 / 684.0) +
                  lag_rate(ray, keeps, y3) * (275.0 / 252.0) - lag_rate(ray, keeps, y4) * (78125.0 / 112404.0) + lag_rate(ray, keeps, to.y) * (1.0 / 12.0));
#endif
    to.psi = from.psi + h * (from.drag * (151.0 / 2142.0) + spin_turning(ray, from, y1.w) * (25.0 / 522.0) +
                             spin_turning(ray, from, y2.w) * (275.0 / 684.0) + spin_turning(ray, from, y3.w) * (275.0 / 252.0) -
                             spin_turning(ray, from, y4.w) * (78125.0 / 112404.0) + to.drag * (1.0 / 12.0));
#ifdef EFFECT_SPIN_FALL
    to.ingoing = from.ingoing && ingoing_stays(ray, to.y.w, to.v.w);
    if (from.ingoing && !to.ingoing) {
        to.psi += spin_winding(ray, to.y.w);
        to.drag = spin_drag(ray, to.y.w);
    }
#endif
    return to;
}
#endif

// SPIN_STEP over the fastest rate: the sphere's, the radius' and how fast Delta changes next to the horizon (more on the way out, where
// the dragging is of use; on the way in a step must be able to pass the horizon). On its way out a ray ends its last step a little
// beyond the sky at zeta = 0.
float spin_stride(SpinRay ray, SpinState at, int left) {
    float zeta = at.y.w;
    float slope = at.v.w;
#ifdef EFFECT_SPIN_FALL
    float fall = at.ingoing ? 0.0 : slope * (0.5 - ray.a * ray.a * zeta) / spin_delta(ray, zeta);
#else
    float fall = slope * (0.5 - ray.a * ray.a * zeta) / spin_delta(ray, zeta);
#endif
    float rate2 = abs(ray.j2) + ray.a2e2 + 0.125 * ray.energy * ray.energy + 1.5 * ray.k * zeta + (slope < 0.0 ? 3.0 : 1.0 + 3.0 * min(2.0 * spin_delta(ray, zeta), 1.0)) * fall * fall;
#ifdef EFFECT_SPIN_FALL
    rate2 += INGOING_DEEP * ray.k * zeta * clamp(ray.outer * zeta - 1.0, 0.0, 1.0);   // inside, where zeta changes by its own size
#endif
#ifdef METHOD_MINO
    if (slope > 0.0 && SPIN_SHARE < 1.0) rate2 -= (1.0 - SPIN_SHARE * SPIN_SHARE) * fall * fall;   // short steps pass the horizon too
#endif
    float h = SPIN_STEP * (1.0 + SPIN_GROWTH * max(float(SPIN_MOST_STEPS - SPIN_GROW_AFTER - left), 0.0)) * inversesqrt(rate2);
    return slope < 0.0 ? min(h, -1.05 * zeta / slope) : h;
}

// What is left to zeta = 0 after the step that passed it: zeta is nearly a harmonic oscillator there. The time by three terms of its
// arctangent, one step back by that, and the rest by the second order.
SpinState spin_to_sky(SpinRay ray, SpinState beyond) {
    float x = beyond.y.w / min(beyond.v.w, -1.0e-20);
    float w = (ray.j2 - ray.a2e2) * x * x;
    SpinState at = spin_step(ray, beyond, -x * (1.0 - w * (1.0 / 3.0 - 0.2 * w)) - 1.0e-20);
    float rest = -at.y.w / min(at.v.w, -1.0e-20);
    at.y += rest * (at.v + 0.5 * rest * at.f);
    at.psi += rest * at.drag;
#ifdef EFFECT_DELAY
    at.lag += rest * lag_rate(ray, true, at.y);
#endif
    return at;
}
