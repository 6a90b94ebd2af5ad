// Linear polarisation by the reference: against published and computed values, and its transport against Walker and Penrose's constant.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>

#include "observer/pose.h"
#include "observer/screen_form.h"
#include "reference/disc_polarisation.h"
#include "spacetime/registry.h"

using namespace nullscope;

namespace {

constexpr double kChiDegree = M_PI / 180;

// Of angles modulo pi.
double apart(double a, double b) { return std::abs(std::remainder(a - b, M_PI)); }

Scene polarised_scene(const char* metric, double spin, double charge = 0) {
    Scene scene;
    scene.spacetime.metric = metric;
    if (scene.spacetime.metric != "schwarzschild") scene.spacetime.parameters["spin"] = spin;
    if (scene.spacetime.metric == "kerr-newman") scene.spacetime.parameters["charge"] = charge;
    DiscSpec& disc = scene.disc.emplace();
    disc.inner = 1.2, disc.outer = 20, disc.emission = DiscEmission::kThermal;
    disc.polarisation.by = Polarisation::kSynchrotron;
    return scene;
}

}  // namespace

// Light of an observer at infinity at (alpha, beta) M; angles from +alpha towards +beta (two formulations agree to 0.006 degrees). From r = 1e6 r_s.
TEST_CASE("polarisation: synchrotron light of matter on circular orbits, first crossing") {
    struct Row {
        double spin, theta, alpha, beta, r, vertical, toroidal, radial;
    };
    constexpr Row kRows[] = {{0, 60, 5, 3, 4.269185926, 33.475414, 25.143158, 122.536405},
                             {0.9, 60, 5, 3, 3.629599984, 36.946388, 3.517027, 120.894317},
                             {0.5, 80, -8, 2, 8.056922297, 177.484818, 110.819307, 70.289373}};
    constexpr double kFar = 1e6;
    for (const Row& row : kRows)
        for (const auto& [field, angle] : {std::pair{DiscField::kVertical, row.vertical},
                                           {DiscField::kToroidal, row.toroidal},
                                           {DiscField::kRadial, row.radial}}) {
            Scene scene = polarised_scene(row.spin == 0 ? "schwarzschild" : "kerr", row.spin);
            scene.disc->polarisation.field = field;
            scene.camera.r = kFar, scene.camera.theta = row.theta * kChiDegree,
            scene.camera.observer = ObserverKind::kZamo;
            const auto polarisation = reference::DiscPolarisation::make(scene);
            REQUIRE(polarisation);
            const Vec3 seen{0.5 * row.alpha / kFar, 0.5 * row.beta / kFar, -1};
            const auto from = polarisation->axes_of(scene.camera);
            REQUIRE(from);
            const auto found = polarisation->at(*from, normalized(seen), 1, reference::DiscPolarisation::Flow::kCircle);
            REQUIRE(found);
            CHECK(std::abs(2 * found->r / row.r - 1) < 1e-5);
            CHECK(apart(found->angle, angle * kChiDegree) < 0.01 * kChiDegree);
        }
}

namespace {

// kappa of a vector along with a photon, both in ingoing coordinates (v, r, theta, phi~); (A - i B)(r - i a cos(theta)) has the same form as in
// Boyer and Lindquist's.
std::complex<double> walker_penrose(double a, double r, double theta, const std::array<double, 4>& k,
                                    const std::array<double, 4>& f) {
    const double sine = std::sin(theta), across = r * r + a * a;
    const auto minor = [&](std::size_t i, std::size_t j) { return k[i] * f[j] - k[j] * f[i]; };
    const double first = minor(0, 1) + a * sine * sine * minor(1, 3),
                 second = sine * (across * minor(3, 2) - a * minor(0, 2));
    return std::complex(first, -second) * std::complex(r, -a * std::cos(theta));
}

// Ingoing components of a vector of the chart in the equatorial plane.
std::array<double, 4> ingoing_of(double a, double r, const Vec3& x, const reference::FourVector& v) {
    const std::complex<double> turn = std::complex(v[1], v[2]) / std::complex(x.x, x.y);
    const double theta = -v[3] / r, radial = (turn.real() * (r * r + a * a) / r);
    return {v[0] + radial, radial, theta, turn.imag() + radial * a / (r * r + a * a)};
}

}  // namespace

// Both parts, formed from the vector that is carried by integration, at the camera and where the ray meets the plane.
TEST_CASE("polarisation: Walker and Penrose's constant keeps along integrated rays") {
    std::mt19937 engine(53);
    const auto uniform = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(engine);
    };
    double worst = 0, worst_form = 0;
    int rays = 0;
    for (int i = 0; i < 60; ++i) {
        const double spin = i % 3 == 0 ? 0.0 : uniform(-0.99, 0.99),
                     charge = i % 2 == 0 ? 0.0 : uniform(0, 0.98 * std::sqrt(1 - spin * spin));
        Scene scene = polarised_scene("kerr-newman", std::abs(spin), charge);
        CameraSpec& camera = scene.camera;
        camera.r = uniform(4, 40), camera.theta = uniform(0.1, 3.0),
        camera.velocity = {uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5)};
        camera.observer = ObserverKind::kZamo, camera.yaw = uniform(-0.3, 0.3), camera.roll = uniform(-3, 3);
        const auto polarisation = reference::DiscPolarisation::make(scene);
        CAPTURE(polarisation ? "" : polarisation.error().message());
        REQUIRE(polarisation);
        const double width = 8 / camera.r;
        const Vec3 n = normalized({uniform(-width, width), uniform(-width, width), -1});
        const auto from = polarisation->axes_of(camera);
        REQUIRE(from);
        const reference::CarryingMetric& metric = polarisation->carrying();
        const auto axes = reference::carried_axes(metric, camera, from->tetrad, n, 1);
        if (!axes) continue;
        ++rays;
        const double r = metric.radius(axes->place), by = 1 / (1 - n.z);
        const auto row = [&](const std::array<double, 4>& factors) {
            std::array<double, 4> v{};
            for (std::size_t m = 0; m < 4; ++m)
                for (std::size_t j = 0; j < 4; ++j) v[m] += factors[j] * static_cast<double>(from->tetrad[j][m]);
            v[3] /= std::sin(camera.theta);
            return v;
        };
        const auto k = row({1, -n.x, -n.y, -n.z});
        const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        const auto observer = observer_of(**spacetime, camera);
        REQUIRE(observer);
        const auto phase = screen_phase(screen_form(**spacetime, camera, *observer, true), {n.x, n.y, -n.z});
        const std::array<std::array<double, 4>, 2> begin = {
            row({0, 1 - n.x * n.x * by, -n.x * n.y * by, n.x * (1 - n.z) * by}),
            row({0, -n.x * n.y * by, 1 - n.y * n.y * by, n.y * (1 - n.z) * by})};
        const std::array<reference::FourVector, 2> end = {axes->right, axes->up};
        for (std::size_t j = 0; j < 2; ++j) {
            const auto at_camera = walker_penrose(metric.a(), camera.r, camera.theta, k, begin[j]);
            const auto at_disc =
                walker_penrose(metric.a(), r, M_PI / 2, ingoing_of(metric.a(), r, axes->place, axes->k),
                               ingoing_of(metric.a(), r, axes->place, end[j]));
            worst = std::max(worst, std::abs(at_disc - at_camera) / std::abs(at_camera));
            // kappa = w e^(-i chi) r G.(a + i b), chi = 0 or pi/2
            const std::complex<double> told =
                camera.r * phase * (j == 0 ? std::complex(1.0, 0.0) : std::complex(0.0, -1.0));
            worst_form = std::max(worst_form, std::abs(told - at_camera) / std::abs(at_camera));
        }
        CHECK(std::abs(metric.product(axes->place, axes->k, axes->right)) < 1e-10);
        CHECK(std::abs(metric.product(axes->place, axes->right, axes->right) - 1) < 1e-10);
        CHECK(std::abs(metric.product(axes->place, axes->right, axes->up)) < 1e-10);
    }
    MESSAGE(rays, " rays: ", worst, " of kappa, ", worst_form, " of the camera's form");
    CHECK(rays > 40);
    CHECK(worst < 1e-12);
    CHECK(worst_form < 1e-13);
}

// Chandrasekhar (1960), table XXIV, and between its rows by the H functions themselves.
TEST_CASE("polarisation: of an atmosphere of electrons") {
    constexpr double kRows[][2] = {{0, 0.11713},     {0.1, 0.07448},   {0.2, 0.05410},   {0.3, 0.04041},
                                   {0.5, 0.02252},   {0.7, 0.011123},  {0.9, 0.003155},  {1, 0},
                                   {0.02, 0.102948}, {0.05, 0.089855}, {0.15, 0.063118}, {0.4, 0.030326},
                                   {0.6, 0.016267},  {0.8, 0.006822}};
    for (const auto& [cosine, fraction] : kRows)
        CHECK(std::abs(reference::scattered_fraction(cosine) - fraction) < 1e-5);
}
