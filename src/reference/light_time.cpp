#include "reference/light_time.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "reference/root.h"

namespace nullscope::reference {
namespace {

constexpr double kRadial = 1e7;               // q beyond which light is as good as radial: b^2/r^2 = 1e-14
constexpr double kLongest = 0.3, kRatio = 2;  // of a panel, rad; of the radii in it: 15 nodes leave 1e-13
constexpr int kDeepestHalving = 12;
constexpr double kTimeTolerance = 1e-12;
using TimeRule = boost::math::quadrature::gauss_kronrod<double, 31>;

}  // namespace

// In x = 1/r: 1/A - 1 - x is O(x^2) and is divided by it.
double tortoise_excess(const OrbitMetric& metric, double r) {
    const auto rest = [&](double x) {
        if (!(x > 1e-5)) return 1.0;  // its limit is (1 - kappa) or 1: times 1e-5 of the range
        const double a = metric.lapse2(1 / x);
        return (1 / a - 1 - x) / (x * x);
    };
    if (metric.lapse(1e6) == 1) return 0;  // flat
    return std::log(r) - TimeRule::integrate(rest, 0.0, 1 / r, kDeepestHalving, kTimeTolerance);
}

LightClock::LightClock(const OrbitMetric& metric, const Orbit& orbit, double q, double camera_r, bool falls)
    : metric_(metric), orbit_(orbit), q_(q), r0_(camera_r) {
    const double horizon = metric.horizon_radius().value_or(0.0);
    by_v_ = camera_r <= horizon;
    start_ = falls && !by_v_ ? tortoise_excess(metric, camera_r) : 0.0;
    known_[0.0] = 0.0;
}

double LightClock::travel_time(double from, double to) const {
    const auto rate = [this](double angle) {
        const double zeta = orbit_.zeta_at(angle);
        if (!by_v_) return q_ / (zeta * zeta * metric_.lapse2(1 / zeta));
        // Outward without a turning point: 1/(q + sqrt(q^2 - V)); V = zeta^2 A < 0 inside.
        const double step = 1e-6,
                     slope = (orbit_.zeta_at(angle + step) - (angle > step ? orbit_.zeta_at(angle - step) : zeta)) /
                             (angle > step ? 2 * step : step);
        return 1 / (q_ - slope);
    };
    // Panels in which the radius changes little: far out, where it runs through orders of magnitude, they crowd.
    const std::function<double(double, double, double, double)> sum = [&](double a, double b, double zeta_a,
                                                                          double zeta_b) {
        const double middle = 0.5 * (a + b), zeta = orbit_.zeta_at(middle), most = std::max({zeta_a, zeta, zeta_b}),
                     least = std::min({zeta_a, zeta, zeta_b});
        if (middle > a && middle < b && (b - a > kLongest || !(most < kRatio * least)))
            return sum(a, middle, zeta_a, zeta) + sum(middle, b, zeta, zeta_b);
        return boost::math::quadrature::gauss<double, 15>::integrate(rate, a, b);
    };
    return sum(from, to, orbit_.zeta_at(from), orbit_.zeta_at(to));
}

double LightClock::delay(double angle) {
    const double r = 1 / orbit_.zeta_at(angle);
    if (!std::isfinite(r) || !(metric_.lapse2(r) > 0)) return kNotANumber;
    if (!(q_ < kRadial))
        return by_v_ ? r + tortoise_excess(metric_, r) - r0_
                     : start_ + std::fabs(r + tortoise_excess(metric_, r) - r0_ - tortoise_excess(metric_, r0_));
    auto next = known_.upper_bound(angle);
    const auto [from, so_far] = *--next;
    const double sum = angle > from ? so_far + travel_time(from, angle) : so_far;
    known_[angle] = sum;
    return by_v_ ? sum + r + tortoise_excess(metric_, r) - r0_ : start_ + sum;
}

namespace {

// t from the turning point r0 to r of Schwarzschild's metric, less s = sqrt(r^2 - r0^2), what it is without a mass. With A = 1 - 1/r,
// b^2 = r0^2/A(r0), and d = r - r0 = s^2/(r + r0)
//     dt/ds = 1/(A sqrt(U)),  U = (r/s)^2 (1 - b^2 A/r^2) = [r0^2 (2 r0 - 3) + (r0 - 1) d (3 r0 + d)] / [(r0 - 1) r (r + r0)],
//     dt/ds - 1 = (1 - A^2 U)/(A sqrt(U) (1 + A sqrt(U))),  1 - A^2 U = (2 - 1/r)/r + A^2 r0^2/[(r0 - 1) r (r + r0)]:
// every term is positive. Panels that double, from within the distance at which U leaves its least value: 15 nodes leave 1e-16.
double mass_part(double r0, double r) {
    const auto rate = [&](double s) {
        const double at = std::hypot(r0, s), d = s * s / (at + r0), a = (at - 1) / at,
                     below = (r0 - 1) * at * (at + r0);
        const double u = (r0 * r0 * (2 * r0 - 3) + (r0 - 1) * d * (3 * r0 + d)) / below, root = a * std::sqrt(u);
        return ((2 - 1 / at) / at + a * a * r0 * r0 / below) / (root * (1 + root));
    };
    const double end = std::sqrt((r - r0) * (r + r0)),
                 bend = r0 * std::sqrt(std::min(2 * (2 * r0 - 3) / (3 * (r0 - 1)), 1.0));
    double sum = 0;
    for (double from = 0, to = std::max(0.25 * bend, 1e-8); from < end; from = to, to *= 2)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(rate, from, std::min(to, end));
    return sum;
}

}  // namespace

std::optional<Passage> light_past(const OrbitMetric& metric, double from, double to, double impact) {
    const auto orbit = metric.from_reduced({1 / impact, 1 / from, 1});
    if (!orbit || !std::isfinite((*orbit)->turn())) return std::nullopt;
    const double turn = (*orbit)->turn_angle(), closest = 1 / (*orbit)->turn();
    if (!(to > closest)) return std::nullopt;
    const double straight = std::sqrt((from - closest) * (from + closest)) + std::sqrt((to - closest) * (to + closest));
    const double angle = to == from ? 2 * turn
                                    : root_of([&](double at) { return (*orbit)->zeta_at(at) - 1 / to; }, turn,
                                              (*orbit)->angle() * (1 - 1e-15), 52);
    return Passage{straight + (mass_part(closest, from) + mass_part(closest, to)), closest, angle};
}

}  // namespace nullscope::reference
