// The disc's motion and heat, by the tables' way and by the reference's, against closed forms and published figures.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/isoradial.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "table/disc_light.h"

namespace {

using namespace nullscope;

// Luminet 1979, eq. 15: Page and Thorne's law in Schwarzschild; r in M, per unit accretion rate and M^2.
double luminet_flux(double r) {
    const double x = std::sqrt(r), x3 = std::sqrt(3.0), x6 = std::sqrt(6.0);
    const double bracket = x - x6 + x3 / 2 * std::log((x + x3) * (x6 - x3) / ((x - x3) * (x6 + x3)));
    return 3 / (8 * M_PI) / ((r - 3) * std::pow(r, 2.5)) * bracket;
}

struct Fixture {
    std::shared_ptr<const Spacetime> spacetime = *make_spacetime("schwarzschild", {});
    std::unique_ptr<reference::OrbitMetric> metric = std::move(*reference::make_orbit_metric({"schwarzschild", {}}));
    DiscSpec disc;
    reference::DiscLight light{*metric, disc, {}};
};

TEST_CASE_FIXTURE(Fixture, "disc light: the innermost stable orbit is at 6 M") {
    CHECK(*innermost_stable_orbit(*spacetime) == doctest::Approx(3.0).epsilon(1e-13));
    CHECK(light.innermost() == doctest::Approx(3.0).epsilon(1e-9));
}

TEST_CASE_FIXTURE(Fixture, "disc light: flux is Luminet's closed form, largest at 9.55092807794387 M with 1.36781108198e-5") {
    const double kMostRelative = 1e-8;   // of differences taken for derivatives
    for (const double m : {6.5, 7.0, 9.0, 12.0, 30.0, 200.0}) {
        CAPTURE(m);
        CHECK(std::fabs(disc_flux(*spacetime, {m / 2}).front() / 4 / luminet_flux(m) - 1) < kMostRelative);
        CHECK(std::fabs(light.flux(m / 2) / 4 / luminet_flux(m) - 1) < kMostRelative);
    }
    const FluxPeak peak = disc_flux_peak(*spacetime);
    CHECK(std::fabs(2 * peak.r - 9.55092807794387) < 1e-6);
    CHECK(std::fabs(peak.flux / 4 - 1.36781108198e-5) < 1e-15);
    CHECK(std::fabs(2 * light.hottest() - 9.55092807794387) < 1e-5);
    CHECK(std::fabs(light.flux(light.hottest()) / 4 - 1.36781108198e-5) < 1e-15);
    CHECK(disc_flux(*spacetime, {2.9, 3.0, 2.0}) == std::vector<double>{0, 0, 0});
}

TEST_CASE_FIXTURE(Fixture, "disc light: face on, g = sqrt(1 - 3M/r), by both") {
    for (const double r : {3.0, 5.0, 40.0}) {
        const double g = std::sqrt(1 - 1.5 / r);
        CHECK(light.g_infinity({r, 0, true, 1}) == doctest::Approx(g).epsilon(1e-11));
        CHECK(1 / disc_matter(*spacetime, r).u_t == doctest::Approx(g).epsilon(1e-14));
    }
}

TEST_CASE_FIXTURE(Fixture, "disc light: the fall inside the last stable orbit joins its circle, and both ways agree") {
    const MatterVelocity at = disc_matter(*spacetime, 3.0), in = disc_matter(*spacetime, 3.0 - 1e-6);
    CHECK(in.u_t == doctest::Approx(at.u_t).epsilon(1e-5));
    CHECK(in.u_phi == doctest::Approx(at.u_phi).epsilon(1e-5));
    for (const double r : {2.9, 2.0, 1.2, 1.01}) {
        const MatterVelocity u = disc_matter(*spacetime, r);
        const double a = 1 - 1 / r;
        CHECK(-a * u.u_t * u.u_t + u.u_r * u.u_r / a + r * r * u.u_phi * u.u_phi == doctest::Approx(-1).epsilon(1e-9));
        for (const bool outward : {true, false}) {
            const double l = 0.8, radial = std::sqrt(1 - a * l * l / (r * r)) * (outward ? 1 : -1);
            const double frequency = u.u_t - l * u.u_phi - radial * u.u_r / a;
            CHECK(light.g_infinity({r, l, outward, l * l}) == doctest::Approx(1 / frequency).epsilon(1e-9));
        }
    }
}

TEST_CASE("disc light: 1 + z on the ring of 6 M seen from 60 degrees at infinity is 0.8166661528 to 2.0117609719") {
    // The camera's distance stands for infinity: its inverse is what the extremes may be off.
    constexpr double kFar = 1e9, kTolerance = 1e-8;
    Scene scene;
    scene.camera.r = kFar;
    scene.camera.theta = M_PI / 3;
    scene.camera.focal_distance = 1;
    scene.camera.plane_width = 40 / kFar;
    scene.disc.emplace().inner = 2.9;
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const reference::DiscLight light(tracer->metric(), *scene.disc, scene.light);
    const auto curve = reference::isoradial(scene, 3.0, 1, 7200);
    REQUIRE(curve);
    REQUIRE(curve->size() == 7200);
    double least = 1e9, most = 0;
    for (const auto& [x, y] : *curve) {
        const auto ray = tracer->ray(x, y);
        const double z = 1 / light.g_infinity({3.0, ray.l_z, true, ray.l2});
        least = std::min(least, z);
        most = std::max(most, z);
    }
    constexpr double kBetween = 4e-7;   // extremes between two of the 7200 points: (pi/7200)^2 of the curvature
    CHECK(std::fabs(least - 0.8166661528) <= kBetween + kTolerance);
    CHECK(std::fabs(most - 2.0117609719) <= kBetween + kTolerance);
    fmt::print("1 + z on the ring of 6 M from 60 degrees: {:.10f} to {:.10f}\n", least, most);
}

}  // namespace
