#include "spectrum/distant_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/nystrom.h"
#include "spacetime/axial_metric.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kStep = 0.12;       // of Mino's time, over the ray's quickest oscillation: 1e-10 of zeta
constexpr double kFar = 1e12;        // r_s
constexpr double kFlat = 1e-6;       // of -g_tt there
constexpr int kMostDoublings = 100;  // of Carlson's: each leaves a quarter of the differences

// R_F(x, y, 1) by Carlson's doubling (Numer. Algorithms 10, 13 (1995)), x >= 0, y > 0: 1e-15 relative.
double carlson_rf(double x, double y) {
    double z = 1.0, mean = (x + y + z) / 3.0;
    for (int i = 0; i < kMostDoublings; ++i) {
        if (std::max({std::fabs(mean - x), std::fabs(mean - y), std::fabs(mean - z)}) < 2e-3 * mean) break;
        const double root_x = std::sqrt(x), root_y = std::sqrt(y), root_z = std::sqrt(z),
                     shift = root_x * root_y + root_y * root_z + root_z * root_x;
        x = 0.25 * (x + shift), y = 0.25 * (y + shift), z = 0.25 * (z + shift), mean = 0.25 * (mean + shift);
    }
    const double dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = -dx - dy, e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
    return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / std::sqrt(mean);
}

// Of dpsi/sqrt(1 + n sin^2 psi) from 0 to an angle in [0, pi] by its sine and cosine.
double first_integral(double sine, double cosine, double n) {
    const auto quarter = [&](double c2) { return sine * carlson_rf(c2, 1.0 + n * sine * sine); };
    if (cosine >= 0.0) return quarter(cosine * cosine);
    return 2.0 * carlson_rf(0.0, 1.0 + n) - quarter(cosine * cosine);
}

// zeta'' as a cubic without a constant.
struct Cubic {
    double one, two, three;
    double operator()(double zeta) const { return zeta * (one + zeta * (two + zeta * three)); }
};

// From zeta = 0, zeta' = 1. Nothing: it grows beyond `most`.
template <class Force>
std::optional<DistantLight::Crossing> followed(double time, int steps, double most, const Force& force) {
    const double h = time / steps;
    double x = 0.0, slope = 1.0;
    std::array<double, Nystrom::kStages> f{};
    f[0] = force(x);
    for (int n = 0; n < steps; ++n) {
        const double from = x;
        double next = slope + h * Nystrom::b_slope[0] * f[0];
        for (int i = 1; i < Nystrom::kStages; ++i) {
            x = from + Nystrom::c[i] * h * slope;
            for (int j = 0; j < i; ++j) x += h * h * Nystrom::a[i][j] * f[j];
            f[i] = force(x);
            next += h * Nystrom::b_slope[i] * f[i];
        }
        slope = next, f[0] = f[Nystrom::kStages - 1];
        if (!(x < most)) return std::nullopt;
    }
    return DistantLight::Crossing{x, slope};
}

}  // namespace

Result<DistantLight> DistantLight::make(std::shared_ptr<const Spacetime> spacetime, double inclination) {
    const std::string name(spacetime->name());
    if (!spacetime->can_have_disc() || !spacetime->bends_light() || !spacetime->horizon_radius() ||
        !innermost_stable_orbit(*spacetime))
        return bad_input(name + ": no disc of stable circular orbits about a horizon", "a black hole's metric");
    if (!(std::fabs(spacetime->lapse_squared(kFar) - 1.0) < kFlat))
        return bad_input(name + ": its space is not flat far out, where the observer is", "a metric with A = 1 there");
    if (!(inclination >= 0.0 && inclination <= kMost_deg * M_PI / 180.0))
        return bad_input(fmt::format("an inclination of {:g} degrees: that close to the disc's plane it is not seen",
                                     inclination * 180.0 / M_PI),
                         fmt::format("0 to {0:g} degrees, or {1:g} to 180 from below", kMost_deg, 180.0 - kMost_deg));
    DistantLight light;
    light.horizon_ = *spacetime->horizon_radius();
    light.cosine_ = std::cos(inclination), light.sine_ = std::sin(inclination);
    if (const AxialMetric* rotating = spacetime->axial()) {
        light.a_ = rotating->a(), light.charge2_ = rotating->charge2();
    } else {
        light.orbit_ = spacetime->orbit_equation();
    }
    light.spacetime_ = std::move(spacetime);
    return light;
}

DistantLight::Constants DistantLight::constants(double alpha, double beta) const {
    return {-alpha * sine_, beta * beta + (alpha - a_) * (alpha + a_) * cosine_ * cosine_};
}

// To psi = pi; infinite where the ray stays on its side of the plane.
double DistantLight::mino_time(const Constants& of, double beta) const {
    const double w = of.eta + of.lambda * of.lambda - a_ * a_, root = std::hypot(w, 2.0 * a_ * std::sqrt(of.eta)),
                 p = w > 0.0 ? 0.5 * (w + root) : 2.0 * a_ * a_ * of.eta / (root - w);
    // psi at the observer: sine and cosine, both times sqrt(u_+).
    const double up = beta * sine_ / std::sqrt(p + a_ * a_ * cosine_ * cosine_), size = std::hypot(cosine_, up);
    return first_integral(cosine_ / size, -up / size, a_ * a_ * of.eta / (p * p)) / std::sqrt(p);
}

std::optional<DistantLight::Crossing> DistantLight::crossing(double alpha, double beta) const {
    const Constants of = constants(alpha, beta);
    if (!(of.eta > 0.0)) return std::nullopt;
    const double time = mino_time(of, beta), b2 = of.eta + of.lambda * of.lambda, most = 1.0 / horizon_,
                 k = of.eta + (of.lambda - a_) * (of.lambda - a_);
    const double steps = std::ceil(time * std::sqrt(std::max(b2, k) + 1.0) / kStep);
    constexpr double kMostSteps = 1e5;  // of rays that wait by the axis: they have long fallen in
    if (!(steps < kMostSteps)) return std::nullopt;
    const int count = std::max(static_cast<int>(steps), 1);
    if (orbit_ != nullptr)
        return followed(time, count, most, [&](double zeta) { return -b2 * orbit_->half_v_slope(zeta); });
    const double cross = a_ * (a_ - of.lambda);
    return followed(time, count, most, Cubic{a_ * a_ - b2, 1.5 * k, 2.0 * (cross * cross - k * (a_ * a_ + charge2_))});
}

}  // namespace nullscope
