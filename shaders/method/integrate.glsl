// Method integrate: the orbit equation zeta'' = -V'(zeta)/2 step by step in phi, until zeta falls to 0. STEP_ORDER 1 (Euler, the
// baseline: what most viewers do), 4 (Runge and Kutta) or 6 (RKN6(4)6FM of Dormand, El-Mikkawy and Prince 1987).
// Step: STEP_ANGLE / sqrt(1 + 3 zeta), at most STEP_MOST of them. The verdict escaped or captured is the critical angle's.
#include "generated/metric"
#include "method/by_angle.glsl"
#include "shared/frame.glsl"

vec2 orbit_slope(vec2 y) { return vec2(y.y, -half_v_slope(y.x)); }

vec2 orbit_step(vec2 y, float h) {
#ifdef STEP_ORDER_1
    return y + h * orbit_slope(y);
#endif
#ifdef STEP_ORDER_4
    vec2 k1 = orbit_slope(y);
    vec2 k2 = orbit_slope(y + 0.5 * h * k1);
    vec2 k3 = orbit_slope(y + 0.5 * h * k2);
    vec2 k4 = orbit_slope(y + h * k3);
    return y + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
#endif
#ifdef STEP_ORDER_6
    float z = y.x;
    float v = h * y.y;
    float hh = h * h;
    float f0 = -hh * half_v_slope(z);
    float f1 = -hh * half_v_slope(z + 0.1 * v + f0 / 200.0);
    float f2 = -hh * half_v_slope(z + 0.3 * v - f0 / 2200.0 + f1 / 22.0);
    float f3 = -hh * half_v_slope(z + 0.7 * v + f0 * (637.0 / 6600.0) - f1 * (7.0 / 110.0) + f2 * (7.0 / 33.0));
    float f4 = -hh * half_v_slope(z + 0.68 * v + f0 * (225437.0 / 1968750.0) - f1 * (30073.0 / 281250.0) +
                                  f2 * (65569.0 / 281250.0) - f3 * (9367.0 / 984375.0));
    float b = f0 * (151.0 / 2142.0) + f1 * (5.0 / 116.0) + f2 * (385.0 / 1368.0) + f3 * (55.0 / 168.0) - f4 * (6250.0 / 28101.0);
    float f5 = -hh * half_v_slope(z + v + b);
    float slope = f0 * (151.0 / 2142.0) + f1 * (25.0 / 522.0) + f2 * (275.0 / 684.0) + f3 * (275.0 / 252.0) -
                  f4 * (78125.0 / 112404.0) + f5 / 12.0;
    return vec2(z + v + b, y.y + slope / h);
#endif
}

Sweep sweep_to_sky(StripRay ray, float s, float c) {
    float q = frame.shift.x * frame.shift.y / max(s, 1.0e-6);
    vec2 y = vec2(frame.shift.y, -q * c);
    vec2 before = y;
    float phi = 0.0;
    float h = 0.0;
    int count = 0;
    do {
        // |zeta'| <= q, and = q at zeta = 0: a steep ray is at the sky or at the centre before a whole step is over.
        h = min(STEP_ANGLE * inversesqrt(1.0 + 3.0 * abs(y.x)), (y.y < 0.0 ? 1.05 * y.x : 1.0) / q);
        before = y;
        y = orbit_step(y, h);
        phi += h;
        ++count;
    } while (y.x > 0.0 && y.x < 1.5 && count < STEP_MOST);
    // zeta = 0 within the last step, on the cubic through both ends: three Newton steps.
    float drop = before.x - y.x;
    float f = clamp(before.x / max(drop, 1.0e-30), 0.0, 1.0);
#ifndef STEP_ORDER_1
    for (int i = 0; i < 3; ++i) {
        float g = 1.0 - f;
        float value = g * g * (1.0 + 2.0 * f) * before.x + f * g * g * h * before.y + f * f * (3.0 - 2.0 * f) * y.x - f * f * g * h * y.y;
        float slope = 6.0 * f * g * (y.x - before.x) + g * (1.0 - 3.0 * f) * h * before.y + f * (3.0 * f - 2.0) * h * y.y;
        f = clamp(f - value / min(slope, -1.0e-20), 0.0, 1.0);
    }
#endif
    return sweep_by_angle(phi - (1.0 - f) * h, s, c);
}
