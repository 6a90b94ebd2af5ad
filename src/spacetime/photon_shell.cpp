#include "spacetime/photon_shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "spacetime/potential_survey.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kBeyondOrbits =
    2.0;  // r_s from the outer horizon: the outermost orbit, against the fastest spin, is at 4 M
constexpr double kInHorizon = 1e-300, kInExtremal = 10.0 * AxialMetric::kLeastApart;  // r_s from it
constexpr double kRounding = 1e-15;                                                   // of a radius

// The integral over a half orbit of what has the period pi in psi; f of sin^2(psi).
template <class F>
double half_orbit(const F& f) {
    constexpr int kPoints = 12;
    double sum = 0.0;
    for (int i = 0; i < kPoints / 2; ++i) {
        const double sine = std::sin((i + 0.5) * M_PI / kPoints);
        sum += f(sine * sine);
    }
    return 2.0 * M_PI / kPoints * sum;
}

struct Shell {
    const AxialMetric& metric;
    double a = metric.a(), gap = metric.outer_horizon() - metric.inner_horizon();
    double root_delta(double x) const { return std::sqrt(x) * std::sqrt(x + gap); }
    double slope(double x) const { return 2.0 * x + gap; }
};

// From x = r - r_+; sin and cos of theta, cos and sin^2 of psi.
PhotonOrbit orbit_of(const Shell& shell, double x, double sine, double cosine, double cos_psi, double sin2_psi) {
    const double a = shell.a, a2 = a * a, r = shell.metric.outer_horizon() + x, s = shell.slope(x);
    const double root_k = 4.0 * r * shell.root_delta(x) / s, around = root_k * cos_psi;
    // eta = K sin^2(psi) - a^2 cos^2(theta) + lambda^2 cot^2(theta): theta's potential at theta.
    const double lambda = sine * (a * sine + around),
                 eta = root_k * root_k * sin2_psi +
                       cosine * cosine * (around * (around + 2.0 * a * sine) - a2 * cosine * cosine);
    const double w = eta + lambda * lambda - a2, p = 0.5 * (w + std::sqrt(w * w + 4.0 * a2 * eta)), u = eta / p,
                 root_y = std::sqrt(p + a2);
    const auto rate = [&](double sin2) { return std::sqrt(p + a2 * u * sin2); };
    const double mino = half_orbit([&](double sin2) { return 1.0 / rate(sin2); });
    const double beside = half_orbit([&](double sin2) { return 1.0 / (rate(sin2) * (root_y + rate(sin2))); });
    const double latitude = half_orbit([&](double sin2) { return u * sin2 / rate(sin2); });
    PhotonOrbit orbit{r, lambda, eta, 0, 0, 0, 0};
    orbit.gamma = std::sqrt(2.0 * r * (s + shell.gap / s * (shell.gap / s))) * mino;
    orbit.drag = a * (2.0 * r + 1.0) / s * mino;
    orbit.azimuth = orbit.drag + (lambda < 0.0 ? -M_PI : M_PI) + lambda * a2 / root_y * beside;
    orbit.delay = r * (r + 4.0 * (r - shell.metric.charge2()) / s) * mino + a2 * latitude;
    return orbit;
}

// (r^2 + a^2 cos^2(theta)) Delta' - 4 r (Delta + a sin(theta) cos(psi) sqrt(Delta)) falls through 0 outside of the horizon.
Result<PhotonOrbit> rotating_metric(const AxialMetric& metric, double theta, double psi) {
    const Shell shell{metric};
    const double sine = std::sin(theta), cosine = std::cos(theta), cos_psi = std::cos(psi), sin_psi = std::sin(psi);
    const double polar2 = shell.a * shell.a * cosine * cosine, around = shell.a * sine * cos_psi;
    const double least = shell.gap > 1.5 * AxialMetric::kLeastApart ? kInHorizon : kInExtremal;
    double inside = least, outside = kBeyondOrbits;
    for (double x = 1.0; x > inside && x < outside; x = 0.5 * (inside + outside)) {
        const double r = metric.outer_horizon() + x, root = shell.root_delta(x);
        const bool falls_short = (r * r + polar2) * shell.slope(x) > 4.0 * r * root * (root + around);
        (falls_short ? inside : outside) = x;
    }
    if (!(inside > least))
        return bad_input(fmt::format("{}: this photon orbit lies in the horizon of an extremal hole", metric.name()));
    return orbit_of(shell, inside, sine, cosine, cos_psi, sin_psi * sin_psi);
}

struct Circle {
    double r, q_crit, a;  // phi = -a ln d + b
};

Result<Circle> circle_of(const SphericalMetric& metric) {
    if (const auto barrier = metric.barrier(); barrier && barrier->c[0] == 0.0)
        return Circle{1.0 / barrier->zeta, std::sqrt(barrier->v), 1.0 / std::sqrt(-barrier->c[1])};
    const auto sphere = metric.photon_sphere();
    if (const PotentialSurvey* world = metric.potential(); world != nullptr && sphere) {
        const RayPotential& p = world->potential;
        if (!(p.ridge().bend > 0.0))
            return bad_input(fmt::format("{}: light that passes r = {} ends there", metric.name(), sphere->radius));
        return Circle{sphere->radius, sphere->q_crit, p.density(p.ridge().x) / std::sqrt(p.ridge().bend)};
    }
    if (metric.potential() != nullptr && !metric.potential()->soft)
        return bad_input(fmt::format("{}: light that passes the photon sphere comes back through it", metric.name()));
    if (!sphere || metric.chi() == nullptr)
        return bad_input(fmt::format("{}: there is no photon sphere", metric.name()));
    if (const auto surface = metric.surface_radius(); surface && *surface >= sphere->radius)
        return bad_input(fmt::format("{}: the photon sphere, r = {}, is not outside of the surface, r = {}",
                                     metric.name(), sphere->radius, *surface));
    if (metric.tube_beyond(-kAnyRadius) > 0.0)
        return bad_input(fmt::format("{}: light circles anywhere in the tube, and rays leave it by a power of their "
                                     "distance from the critical one, not its logarithm",
                                     metric.name()),
                         "length = 0");
    return Circle{sphere->radius, sphere->q_crit, metric.chi()->bending_density(0.5 * M_PI)};
}

}  // namespace

Result<PhotonOrbit> photon_orbit(const Spacetime& spacetime, double theta, double psi) {
    if (const AxialMetric* axial = spacetime.axial()) return rotating_metric(*axial, theta, psi);
    TRY(circle, circle_of(*spacetime.spherical()));
    const double b = 1.0 / circle->q_crit, lambda = b * std::sin(theta) * std::cos(psi),
                 polar = b * std::hypot(std::sin(psi), std::cos(theta) * std::cos(psi));
    return PhotonOrbit{circle->r, lambda, polar * polar, M_PI / circle->a, 0.0, lambda < 0.0 ? -M_PI : M_PI, M_PI * b};
}

Result<PhotonOrbit> photon_orbit_at(const AxialMetric& metric, double r) {
    const Shell shell{metric};
    const double x = r - metric.outer_horizon(), root = shell.root_delta(x);
    // cos(psi) at the equator is twist/around.
    const double twist = r * shell.slope(x) - 4.0 * root * root, around = 4.0 * shell.a * root;
    if (!(x > 0.0 && std::fabs(twist) <= std::fabs(around) + 10.0 * kRounding * r)) {
        const auto end = [&](double psi) {
            const auto orbit = photon_orbit(metric, 0.5 * M_PI, psi);
            return orbit ? orbit->r : metric.outer_horizon();
        };
        const double east = end(0.0), west = end(M_PI);
        return bad_input(fmt::format("{}: no photon orbit at r = {}", metric.name(), r),
                         fmt::format("[{}, {}]", std::min(east, west), std::max(east, west)));
    }
    const double cos_psi = around != 0.0 ? std::clamp(twist / around, -1.0, 1.0) : 0.0;
    return orbit_of(shell, x, 1.0, 0.0, cos_psi, (1.0 - cos_psi) * (1.0 + cos_psi));
}

}  // namespace nullscope
