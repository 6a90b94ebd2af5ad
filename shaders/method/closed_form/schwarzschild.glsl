// Method closed-form: Legendre's F by Bulirsch's el1 (Numer. Math. 7 (1965) 78), for P = q^2 - zeta^2 (1 - zeta).
//
// e1 < 0 the negative root, m = 2/3 - e1, S = (q^2 - q_crit^2)(3m + 1)/(4 m^2): the other two are (1 - e1)/2 +- sqrt(-S).
// The value of a difference is never formed from rounded roots: e2 - zeta0 = P(zeta0) / ((zeta0 - e1)(e3 - zeta0)).
#include "core/trig.glsl"
#include "method/by_angle.glsl"
#include "shared/frame.glsl"

#define LANDEN_STEPS 5   // kc from 1e-3 up: the mean has converged to float rounding

// F(phi) with tan(phi) = x > 0 (1/x given), complementary modulus kc > 0.
float el1(float one_over_x, float kc) {
    float y = one_over_x;
    float m = 1.0;
    float l = 0.0;
    for (int i = 0; i < LANDEN_STEPS; ++i) {
        float e = m * kc;
        m += kc;
        y -= e / (abs(y) > 1.0e-18 ? y : 1.0e-18);
        kc = 2.0 * sqrt(e);
        l = (i < LANDEN_STEPS - 1 ? 2.0 * l : l) + (y < 0.0 ? 1.0 : 0.0);
    }
    float angle = y < 0.0 ? -arc_tangent2(m, -y) : arc_tangent2(m, y);   // atan(m / y)
    return (angle + 3.14159265358979323846 * l) / m;
}

Sweep sweep_to_sky(StripRay ray, float s, float c) {
    float omk2 = one_minus_k2_of(ray, s, c);
    float q = frame.shift.x * frame.shift.y / max(s, 1.0e-30);
    float q2 = q * q;
    float zeta0 = frame.shift.y;
    // Negative root of zeta^3 - zeta^2 + q^2: e = -e1 solves e^2 (1 + e) = q^2.
    float e = q2 < 1.0 ? q / sqrt(1.0 + q) : pow(q2, 0.333333333) - 0.3333333;
    e -= (e * e * (1.0 + e) - q2) / (e * (2.0 + 3.0 * e));
    e -= (e * e * (1.0 + e) - q2) / (e * (2.0 + 3.0 * e));
    e -= (e * e * (1.0 + e) - q2) / (e * (2.0 + 3.0 * e));
    float m = 0.66666666666666666667 + e;
    float sigma = -0.14814814814814814815 * omk2 * (3.0 * m + 1.0) / (4.0 * m * m);
    bool turning = omk2 > 0.0;
    // Three real roots: tan^2 x = (zeta - e1)/(e2 - zeta).
    float split = sqrt(max(-sigma, 1.0e-14));
    float e3 = 0.5 * (1.0 + e) + split;
    float e2 = q2 / (e * e3);
    float width = e3 + e;
    float kc = sqrt(2.0 * split / width);
    float left = max(q2 * c * c / ((zeta0 + e) * max(e3 - zeta0, 1.0e-6)), 1.0e-20);    // e2 - zeta0
    float start = el1(sqrt(e2 / e), kc);
    float here = el1(sqrt(left / (zeta0 + e)), kc);
    float whole = el1(1.0e-9, kc);
    float phi_turning = 2.0 * inversesqrt(width) * (c > 0.0 ? here - start : 2.0 * whole - here - start);
    // One real root: tan(y/2) = sqrt((zeta - e1)/A).
    float half_sum = 0.5 * (3.0 * m - 1.0);
    float spread = max(sigma, 1.0e-14);
    float a = sqrt(half_sum * half_sum + spread);
    float kc2 = sqrt(spread / (2.0 * a * (a + half_sum)));
    float t0 = sqrt(e / a);
    float t1 = sqrt((zeta0 + e) / a);
    float f0 = el1(abs(0.5 * (1.0 / t0 - t0)), kc2);
    float f1 = el1(abs(0.5 * (1.0 / t1 - t1)), kc2);
    float twice = 2.0 * el1(1.0e-9, kc2);
    float phi_through = inversesqrt(a) * ((t1 > 1.0 ? twice - f1 : f1) - (t0 > 1.0 ? twice - f0 : f0));
    return sweep_by_angle(turning ? phi_turning : phi_through, s, c);
}
