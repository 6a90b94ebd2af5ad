// Holes that turn towards falling phi, and what circles either way: closed forms, the mirror image, an own quadrature and an own line profile.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "observer/critical_light.h"
#include "observer/landmarks.h"
#include "observer/observer.h"
#include "reference/disc_light.h"
#include "reference/metric.h"
#include "reference/reference.h"
#include "scene/orbit_sense.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/photon_shell.h"
#include "spacetime/registry.h"
#include "spectrum/line_profile.h"
#include "table/disc_light.h"

namespace {

using namespace nullscope;

std::shared_ptr<const Spacetime> hole_of(double spin) {
    return *make_spacetime("kerr", MetricParameters{{"spin", spin}});
}

// Bardeen, Press and Teukolsky (1972), eq. 2.21 and 2.18, of orbits eastward about a hole of any sign; M.
double last_stable(double a) {
    const double z1 = 1 + std::cbrt(1 - a * a) * (std::cbrt(1 + a) + std::cbrt(1 - a)),
                 z2 = std::sqrt(3 * a * a + z1 * z1);
    return 3 + z2 - std::copysign(std::sqrt((3 - z1) * (3 + z1 + 2 * z2)), a);
}
double light_circle(double a) { return 2 * (1 + std::cos(2.0 / 3 * std::acos(-a))); }

// Theirs, eq. 2.12, 2.13 and 2.16: E, L and Omega, with a of either sign; M.
struct Circle {
    double energy, momentum, omega;
};
Circle circle(double a, double r) {
    const double root = std::sqrt(r), root3 = r * root, under = std::sqrt(1 - 3 / r + 2 * a / root3);
    return {(1 - 2 / r + a / root3) / under, (root - 2 * a / r + a * a / root3) / under, 1 / (root3 + a)};
}

// Page and Thorne's flux by trapezoids of (E - Omega L) dL, over 1/M^2.
double flux_by_sum(double a, double r) {
    constexpr int kSteps = 40000;
    double sum = 0, from = last_stable(a);
    const double ratio = std::pow(r / from, 1.0 / kSteps);
    const auto gain = [&](double at) {
        const Circle c = circle(a, at);
        return c.energy - c.omega * c.momentum;
    };
    for (int i = 0; i < kSteps; ++i, from *= ratio)
        sum += 0.5 * (gain(from) + gain(from * ratio)) * (circle(a, from * ratio).momentum - circle(a, from).momentum);
    const double slope = -1.5 * std::sqrt(r) * std::pow(circle(a, r).omega, 2);
    return -slope * sum / (4 * M_PI * r * gain(r) * gain(r));
}

TEST_CASE("spin sense: last stable orbits and circles of light of either sense, closed forms, by both") {
    for (const double spin : {-0.998, -0.9, -0.5, -0.1, 0.3, 0.9}) {
        CAPTURE(spin);
        const auto spacetime = hole_of(spin);
        CHECK(std::fabs(2 * *innermost_stable_orbit(*spacetime) / last_stable(spin) - 1) < 1e-12);
        CHECK(std::fabs(2 * *innermost_stable_orbit(*spacetime, Sense::kWestward) / last_stable(-spin) - 1) < 1e-12);
        CHECK(std::fabs(2 * light_orbit(*spacetime) / light_circle(spin) - 1) < 1e-9);
        CHECK(std::fabs(2 * innermost_light_orbit(*spacetime) / light_circle(std::fabs(spin)) - 1) < 1e-9);
        const auto metric = std::move(*reference::make_metric({"kerr", {{"spin", spin}}}));
        for (const OrbitSense sense : {OrbitSense::kEastward, OrbitSense::kWestward}) {
            DiscSpec disc;
            disc.sense = sense;
            const double signed_spin = sense == OrbitSense::kEastward ? spin : -spin;
            CHECK(std::fabs(2 * reference::DiscLight(*metric, disc, {}).innermost() / last_stable(signed_spin) - 1) <
                  1e-6);
        }
    }
    CHECK(std::fabs(2 * *landmarks_of(*hole_of(-0.5)).isco - 7.5546) < 5e-5);
}

TEST_CASE("spin sense: words of a scene are Bardeen, Press and Teukolsky's circles of that sense") {
    for (const double spin : {-0.7, 0.7}) {
        const auto spacetime = hole_of(spin);
        const auto metric = std::move(*reference::make_metric({"kerr", {{"spin", spin}}}));
        for (const auto& [sense, its_sign] :
             {std::pair{OrbitSense::kEastward, 1.0}, std::pair{OrbitSense::kWestward, -1.0},
              std::pair{OrbitSense::kPrograde, std::copysign(1.0, spin)},
              std::pair{OrbitSense::kRetrograde, -std::copysign(1.0, spin)}})
            for (const double m : {9.0, 20.0}) {
                const double sign = its_sign;
                CAPTURE(spin);
                CAPTURE(sign);
                const Circle known = circle(sign * spin, m);
                const auto orbit = circular_orbit(*spacetime, m / 2, sense_about(*spacetime, sense));
                REQUIRE(orbit);
                CHECK(std::fabs(orbit->omega / (2 * sign * known.omega) - 1) < 1e-13);
                CHECK(std::fabs(orbit->energy / known.energy - 1) < 1e-13);
                CHECK(std::fabs(2 * orbit->momentum / (sign * known.momentum) - 1) < 1e-13);
                CHECK(std::fabs(metric->kepler_rate(m / 2, metric->sense(sense)) / orbit->omega - 1) < 1e-9);
            }
    }
}

TEST_CASE("spin sense: the flux of a retrograde disc is Page and Thorne's integral, by both") {
    for (const double spin : {-0.998, -0.5}) {
        const auto spacetime = hole_of(spin);
        const auto metric = std::move(*reference::make_metric({"kerr", {{"spin", spin}}}));
        const reference::DiscLight light(*metric, {}, {});
        for (const double m : {10.0, 15.0, 60.0}) {
            CAPTURE(spin);
            CAPTURE(m);
            const double exact = flux_by_sum(spin, m);
            CHECK(std::fabs(disc_flux(*spacetime, {m / 2}).front() / 4 / exact - 1) < 1e-6);
            CHECK(std::fabs(disc_flux(*hole_of(-spin), {m / 2}, Sense::kWestward).front() / 4 / exact - 1) < 1e-6);
            CHECK(std::fabs(light.flux(m / 2) / 4 / exact - 1) < 1e-6);
        }
    }
}

TEST_CASE("spin sense: all turned about the x axis by half a turn is the other spin") {
    constexpr double kTheta = 1.1;
    for (const double spin : {0.3, 0.9, 0.9999}) {
        CAPTURE(spin);
        const auto one = hole_of(spin), other = hole_of(-spin);
        for (const double psi : {0.0, 0.7, 1.9, M_PI}) {
            const PhotonOrbit a = *photon_orbit(*one, kTheta, psi),
                              b = *photon_orbit(*other, M_PI - kTheta, M_PI - psi);
            CHECK(std::fabs(a.r / b.r - 1) < 1e-13);
            CHECK(std::fabs(a.lambda + b.lambda) < 1e-12);
            CHECK(std::fabs(a.drag + b.drag) < 1e-11);
            CHECK(std::fabs(a.gamma / b.gamma - 1) < 1e-12);
        }
        for (const ObserverKind observer : {ObserverKind::kZamo, ObserverKind::kStatic, ObserverKind::kCarter}) {
            CameraSpec camera;
            camera.r = 7, camera.theta = kTheta, camera.observer = observer;
            CameraSpec turned = camera;
            turned.theta = M_PI - kTheta;
            const auto a = CriticalLight::make(*one, camera, {}), b = CriticalLight::make(*other, turned, {});
            REQUIRE(a);
            REQUIRE(b);
            for (double psi = 0; psi < 6.28; psi += 0.37) {
                const Vec3 seen = a->direction(psi), there = b->direction(psi + M_PI);
                CHECK(std::hypot(seen.x + there.x, seen.y + there.y, seen.z - there.z) < 1e-9);
            }
        }
    }
}

TEST_CASE("spin sense: orbit and counter-orbit go east and west, about holes of either sign") {
    for (const double spin : {-0.8, 0.8}) {
        CameraSpec camera;
        camera.r = 6, camera.theta = M_PI / 2, camera.observer = ObserverKind::kOrbit;
        CHECK(observer_of(*hole_of(spin), camera)->azimuthal_velocity > 0);
        camera.observer = ObserverKind::kCounterOrbit;
        CHECK(observer_of(*hole_of(spin), camera)->azimuthal_velocity < 0);
        camera.observer = ObserverKind::kStatic;  // against the dragging, as Carter's frame has it
        CHECK(observer_of(*hole_of(spin), camera)->azimuthal_velocity * spin < 0);
    }
}

// An own transfer integral: the reference's rays on a grid of the picture, g on circles by closed form, and between them both by their places.
TEST_CASE("spin sense: line profile of a = -0.5, bins to 0.5 % of the largest") {
    constexpr double kSpin = -0.5, kInclination = 40 * M_PI / 180, kFar = 1e6, kInner = 3.8, kOuter = 9;
    constexpr double kFrom = 0.4, kTo = 1.15, kLeast = 2.5, kMost = kOuter + 1;
    constexpr int kRadii = 45, kAngles = 60, kWithin = 12, kBins = 12;
    const auto emissivity = [](double r) {
        const double at = std::log(r / kInner) / std::log(kOuter / kInner);
        return at > 0 && at < 1 ? std::pow(std::sin(M_PI * at), 2) / (r * r) : 0.0;
    };
    const DistantLight light = *DistantLight::make(hole_of(kSpin), kInclination);
    const DiscLine line{kInner, kOuter, [&](const std::vector<double>& radii) {
                            std::vector<double> values;
                            for (const double r : radii) values.push_back(emissivity(r));
                            return values;
                        }};
    const LineProfile profile = line_profile(light, line, {kBins, kFrom, kTo}, LineCells(1));
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", kSpin}}};
    std::vector<double> met;  // r of the first crossing, 0: none
    const double step = (kMost - kLeast) / kRadii, turn = 2 * M_PI / kAngles;
    for (int i = 0; i <= kRadii; ++i)
        for (int j = 0; j <= kAngles; ++j) {
            const double rho = kLeast + i * step;
            RayQuery query;
            query.r = kFar, query.theta = kInclination;
            query.n = {-1, -rho * std::sin(j * turn) / kFar, rho * std::cos(j * turn) / kFar};
            const auto ray = reference::trace_ray(scene, query, 1, nullptr);
            REQUIRE(ray);
            met.push_back(ray->crossings.empty() ? 0.0 : ray->crossings[0].r);
        }
    std::array<double, kBins> sums{};
    double all = 0;
    for (int i = 0; i < kRadii * kWithin; ++i)
        for (int j = 0; j < kAngles * kWithin; ++j) {
            const double x = (i + 0.5) / kWithin, y = (j + 0.5) / kWithin, u = x - std::floor(x), v = y - std::floor(y);
            const double* at = &met[static_cast<std::size_t>(x) * (kAngles + 1) + static_cast<std::size_t>(y)];
            if (!(std::min({at[0], at[1], at[kAngles + 1], at[kAngles + 2]}) > 0)) continue;
            const double r =
                (1 - u) * ((1 - v) * at[0] + v * at[1]) + u * ((1 - v) * at[kAngles + 1] + v * at[kAngles + 2]);
            if (!(emissivity(r) > 0)) continue;
            const double rho = kLeast + x * step, lambda = -2 * rho * std::cos(y * turn) * std::sin(kInclination),
                         m = 2 * r, root3 = m * std::sqrt(m);
            const double u_t = (1 + kSpin / root3) / std::sqrt(1 - 3 / m + 2 * kSpin / root3),
                         g = 1 / (u_t * (1 - circle(kSpin, m).omega * lambda)),
                         photons = g * g * g * emissivity(r) * rho;
            const int bin = static_cast<int>((g - kFrom) / (kTo - kFrom) * kBins);
            REQUIRE(bin >= 0);
            REQUIRE(bin < kBins);
            all += photons, sums[static_cast<std::size_t>(bin)] += photons;
        }
    const double most = *std::ranges::max_element(sums) / all;
    double off = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) off = std::max(off, std::fabs(profile.share(bin) - sums[bin] / all));
    fmt::print("line profile of a = -0.5: bins off by {:.2e} of the largest at most\n", off / most);
    CHECK(off < 0.005 * most);
}

TEST_CASE("spin sense: up to extremal holes, and not beyond") {
    for (const double spin : {1.0, -1.0, 1 - 1e-9}) {
        CAPTURE(spin);
        const auto spacetime = hole_of(spin);
        CHECK(std::fabs(*spacetime->horizon_radius() - 0.5) < 3e-5);
        CHECK(std::fabs(2 * *innermost_stable_orbit(*spacetime, Sense::kWestward) / last_stable(-spin) - 1) < 2e-5);
        CHECK(std::fabs(2 * *innermost_stable_orbit(*spacetime) / last_stable(spin) - 1) < 2e-5);
        const auto metric = std::move(*reference::make_metric({"kerr", {{"spin", spin}}}));
        const reference::DiscLight light(*metric, {}, {});
        for (const double r : {0.6, 1.0, 5.0, 50.0}) {
            if (2 * r < 1.01 * last_stable(spin)) continue;
            CAPTURE(r);
            const double flux = disc_flux(*spacetime, {r}).front();
            CHECK(std::fabs(light.flux(r) / flux - 1) < 1e-3);
        }
    }
    CHECK(make_spacetime("kerr-newman", MetricParameters{{"spin", 0.6}, {"charge", 0.8}}));
    CHECK(make_spacetime("kerr-newman", MetricParameters{{"spin", -0.8}, {"charge", 0.6}}));
    const auto beyond = make_spacetime("kerr-newman", MetricParameters{{"spin", 0.6}, {"charge", 0.8001}});
    REQUIRE_FALSE(beyond);
    CHECK(beyond.error().message().find("there is no horizon") != std::string::npos);
    CHECK_FALSE(make_spacetime("kerr", MetricParameters{{"spin", -1.0001}}));
}

}  // namespace
