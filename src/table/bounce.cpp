#include "table/bounce.h"

#include <algorithm>
#include <cmath>

#include "numeric/gauss.h"

namespace nullscope {
namespace {

constexpr double kTolerance = 1e-11;  // rad, of a panel
constexpr int kDeepest = 40;

struct BounceRate {
    double e, q0, q1, q2, q3;
    double operator()(double s) const {
        const double x = e - s * s;
        return 2.0 / std::sqrt(std::max(q0 + x * (q1 + x * (q2 + x * q3)), 1e-300));
    }
    double panel(double low, double high) const { return gauss_rule(kTenNode, kTenWeight, low, high, *this); }
    double integral(double low, double high, double whole, int depth) const {
        const double middle = 0.5 * (low + high), left = panel(low, middle), right = panel(middle, high);
        if (std::fabs(left + right - whole) <= kTolerance || depth >= kDeepest) return left + right;
        return integral(low, middle, left, depth + 1) + integral(middle, high, right, depth + 1);
    }
    double integral(double low, double high) const {
        return high > low ? integral(low, high, panel(low, high), 0) : 0.0;
    }
};

// The same V about zeta = 0: zeta^2 A, A = 1 at the sky.
Barrier about_sky(const Barrier& barrier) {
    const double z = barrier.zeta, c4 = barrier.c[3];
    return {0.0, 0.0, {0.0, 1.0, barrier.c[2] - 4.0 * c4 * z, c4}};
}

double swept(const Barrier& barrier, double zeta0, double d, double inward, double farthest) {
    const auto [c1, c2, c3, c4] = barrier.c;
    const auto p = [&, c1 = c1, c2 = c2, c3 = c3, c4 = c4](double x) {
        return d - x * (c1 + x * (c2 + x * (c3 + x * c4)));
    };
    // The turning point: below zeta_d where d < 0, above it elsewhere; |x| bracketed, at first to `farthest`.
    const double side = d < 0.0 ? -1.0 : 1.0;
    double low = 0.0, high = farthest;
    if (side > 0.0)
        while (p(high) > 0.0) low = high, high *= 2.0;
    double y = 0.5 * (low + high);
    for (int i = 0; i < 100; ++i) {
        const double x = side * y, value = p(x), slope = -(c1 + x * (2.0 * c2 + x * (3.0 * c3 + x * 4.0 * c4)));
        ((value > 0.0) == (side > 0.0) ? low : high) = y;
        double next = y - side * value / slope;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const bool done = std::fabs(next - y) <= 2e-16 * y;
        y = next;
        if (done) break;
    }
    BounceRate rate{side * std::max(y, 1e-150), 0.0, 0.0, 0.0, c4};
    rate.q2 = c3 + c4 * rate.e;
    rate.q0 = d / rate.e;
    rate.q1 = std::fabs(rate.e) < 0.1 ? c2 + rate.q2 * rate.e : (rate.q0 - c1) / rate.e;
    // The camera: s^2 = e - x0 = P/Q, which keeps its digits next to the turning point.
    const double root = inward * inward;
    double s2 = std::max(rate.e - (zeta0 - barrier.zeta), 0.0);
    if (s2 < 1e-3)
        for (int i = 0; i < 8; ++i) s2 = root * 0.25 * std::pow(rate(std::sqrt(s2)), 2);
    const double camera = std::sqrt(s2), sky = std::sqrt(rate.e + barrier.zeta);
    const double out = rate.integral(camera, std::max(sky, camera));
    return inward > 0.0 ? out + 2.0 * rate.integral(0.0, camera) : out;
}

}  // namespace

double bounce_to_sky(const Barrier& barrier, double zeta0, double q, double d, double inward) {
    constexpr double kFarOutside = 0.25;  // of V(zeta_d)
    if (zeta0 < barrier.zeta && q * q < kFarOutside * barrier.v)
        return swept(about_sky(barrier), zeta0, q * q, inward, barrier.zeta);
    return swept(barrier, zeta0, d, inward, d < 0.0 ? barrier.zeta : 1.0);
}

}  // namespace nullscope
