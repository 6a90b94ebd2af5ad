#include "reference/light_time.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "reference/chebyshev.h"
#include "reference/root.h"

namespace nullscope::reference {
namespace {

constexpr double kRadial = 1e7;                         // q beyond which light is as good as radial: b^2/r^2 = 1e-14
constexpr double kLongest = 0.8, kRatio = 2.5;          // of a piece, rad; of the radii at its ends
constexpr double kTimeTolerance = 1e-13;                // of its mean rate: the last terms of its sum
constexpr double kRounding = 2e-15, kGrowth = 8;        // of a place; from piece to piece
constexpr int kMostHalvings = 60, kMostShorter = 3;     // for the radii, of light from far away; for the sum
constexpr double kLongestPanel = 0.3, kPanelRatio = 2;  // of v, rad; of the radii in it: 15 nodes leave 1e-13
constexpr int kDeepestHalving = 12;
constexpr double kExcess = 1e-12;
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
    return std::log(r) - TimeRule::integrate(rest, 0.0, 1 / r, kDeepestHalving, kExcess);
}

LightClock::LightClock(const OrbitMetric& metric, const Orbit& orbit, double q, double camera_r, bool falls)
    : metric_(metric), orbit_(orbit), q_(q), r0_(camera_r) {
    const double horizon = metric.horizon_radius().value_or(0.0);
    by_v_ = camera_r <= horizon;
    start_ = falls && !by_v_ ? tortoise_excess(metric, camera_r) : 0.0;
    known_[0.0] = 0.0;
}

double LightClock::rate(double angle) const {
    const double zeta = orbit_.zeta_at(angle);
    return q_ / (zeta * zeta * metric_.lapse2(1 / zeta));
}

double LightClock::Piece::at(double angle) const {
    return before + 0.5 * (to - from) * chebyshev_sum(time, (2 * angle - (from + to)) / (to - from));
}

// As long as the last terms of its sum are nothing: shorter where the radius changes much, far out and next to a horizon.
void LightClock::go_on() {
    const double from = pieces_.empty() ? 0 : pieces_.back().to, end = orbit_.angle(), zeta = orbit_.zeta_at(from);
    double width = kLongest;
    if (!pieces_.empty()) width = std::min(width, kGrowth * (from - pieces_.back().from));
    if (std::isfinite(end)) width = std::min(width, 0.5 * (end - from));
    for (int i = 0; i < kMostHalvings; ++i, width *= 0.5) {
        const double there = orbit_.zeta_at(from + width);
        if (std::max(zeta, there) < kRatio * std::min(zeta, there)) break;
    }
    for (int halvings = 0;; ++halvings, width *= 0.5) {
        std::array<double, kTerms> values{};
        for (std::size_t i = 0; i < kTerms; ++i)
            values[i] = rate(from + 0.5 * width * (1 + chebyshev_places<kTerms>()[i]));
        const auto terms = chebyshev_terms(values);
        const double left = std::abs(terms[kTerms - 1]) + std::abs(terms[kTerms - 2]);
        // Next to the way's end, or to a horizon, what is left is the rounding of places.
        const double to = from + width, lapse2 = metric_.lapse2(1 / orbit_.zeta_at(to)),
                     rounded = kRounding * (1 / lapse2 + (std::isfinite(end) ? to / (end - to) : 0));
        if (left > (kTimeTolerance + rounded) * std::abs(terms[0]) && halvings < kMostShorter) continue;
        const double before = pieces_.empty() ? 0 : pieces_.back().at(from);
        pieces_.push_back({from, from + width, before, chebyshev_integral(terms)});
        return;
    }
}

double LightClock::time_of_v(double from, double to) const {
    // Outward without a turning point: 1/(q + sqrt(q^2 - V)); V = zeta^2 A < 0 inside.
    const auto v_rate = [this](double angle) {
        const double step = 1e-6, zeta = orbit_.zeta_at(angle),
                     slope = (orbit_.zeta_at(angle + step) - (angle > step ? orbit_.zeta_at(angle - step) : zeta)) /
                             (angle > step ? 2 * step : step);
        return 1 / (q_ - slope);
    };
    // Panels in which the radius changes little: far out, where it runs through orders of magnitude, they crowd.
    const std::function<double(double, double, double, double)> sum = [&](double a, double b, double zeta_a,
                                                                          double zeta_b) {
        const double middle = 0.5 * (a + b), zeta = orbit_.zeta_at(middle), most = std::max({zeta_a, zeta, zeta_b}),
                     least = std::min({zeta_a, zeta, zeta_b});
        if (middle > a && middle < b && (b - a > kLongestPanel || !(most < kPanelRatio * least)))
            return sum(a, middle, zeta_a, zeta) + sum(middle, b, zeta, zeta_b);
        return boost::math::quadrature::gauss<double, 15>::integrate(v_rate, a, b);
    };
    return sum(from, to, orbit_.zeta_at(from), orbit_.zeta_at(to));
}

double LightClock::time_of(double angle) const {
    const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), angle,
                                       [](double at, const Piece& piece) { return at < piece.from; });
    return start_ + (next - 1)->at(angle);
}

double LightClock::delay(double angle) {
    if (!pieces_.empty() && angle >= 0 && angle <= pieces_.back().to) return time_of(angle);
    const double r = 1 / orbit_.zeta_at(angle);
    if (!std::isfinite(r) || !(metric_.lapse2(r) > 0)) return kNotANumber;
    if (!(q_ < kRadial))
        return by_v_ ? r + tortoise_excess(metric_, r) - r0_
                     : start_ + std::fabs(r + tortoise_excess(metric_, r) - r0_ - tortoise_excess(metric_, r0_));
    if (!by_v_) {
        for (double to = -1; pieces_.empty() || (angle > pieces_.back().to && pieces_.back().to > to);) {
            to = pieces_.empty() ? -1 : pieces_.back().to;
            go_on();
        }
        return time_of(angle);
    }
    auto next = known_.upper_bound(angle);
    const auto [from, so_far] = *--next;
    const double sum = angle > from ? so_far + time_of_v(from, angle) : so_far;
    known_[angle] = sum;
    return sum + r + tortoise_excess(metric_, r) - r0_;
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
