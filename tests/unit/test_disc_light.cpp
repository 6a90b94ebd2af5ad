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
    std::unique_ptr<reference::Metric> metric = std::move(*reference::make_metric({"schwarzschild", {}}));
    DiscSpec disc;
    reference::DiscLight light{*metric, disc, {}};
};

TEST_CASE_FIXTURE(Fixture, "disc light: the innermost stable orbit is at 6 M") {
    CHECK(*innermost_stable_orbit(*spacetime) == doctest::Approx(3.0).epsilon(1e-13));
    CHECK(light.innermost() == doctest::Approx(3.0).epsilon(1e-9));
}

TEST_CASE_FIXTURE(Fixture,
                  "disc light: flux is Luminet's closed form, largest at 9.55092807794387 M with 1.36781108198e-5") {
    const double kMostRelative = 1e-8;  // of differences taken for derivatives
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

TEST_CASE(
    "disc light: where a cosmological constant leaves few stable circles, the peak of the flux is the reference's") {
    MetricParameters kottler;
    kottler.formulas = {{"A", "1 - 1/r - 0.0028*r^2/3"}};
    const auto metric = std::move(*reference::make_metric({"formula", kottler}));
    const reference::DiscLight ring(*metric, {}, {});
    const FluxPeak peak = disc_flux_peak(**make_spacetime("formula", kottler));
    CHECK(std::fabs(peak.flux / ring.flux(ring.hottest()) - 1) < 1e-6);
}

// Bolometric light is T^4, and that the flux. The table adds rings up, the flux is quadrature from the innermost circle anew.
TEST_CASE("disc light: the heat of every ring is the flux there over the largest, to 1e-8 of that") {
    const SpacetimeSpec spaces[] = {{"schwarzschild", {}}, {"kerr", {{"spin", 0.98}}}};
    for (const SpacetimeSpec& space : spaces) {
        CAPTURE(space.metric);
        const auto metric = std::move(*reference::make_metric(space));
        DiscSpec disc;
        disc.outer = 60.0;
        LightSpec light;
        light.bolometric = true;
        const reference::DiscLight ring(*metric, disc, light);
        const double peak = ring.flux(ring.hottest());
        for (const double r : {1.0, 1.0003, 1.1, 1.6, 5.0, 17.0})  // innermost circles
            if (const double at = r * ring.innermost(); at < disc.outer) {
                CAPTURE(at);
                const Vec3 seen = ring.colour({at, 0, 1}, 1.0);
                const double heat = 0.2126390059 * seen.x + 0.7151686788 * seen.y + 0.0721923154 * seen.z;
                CHECK(std::fabs(heat - ring.flux(at) / peak) <
                      1e-8);  // next to the innermost circle of a fast hole: the cubic's
            }
    }
}

TEST_CASE_FIXTURE(Fixture, "disc light: face on, g = sqrt(1 - 3M/r), by both") {
    for (const double r : {3.0, 5.0, 40.0}) {
        const double g = std::sqrt(1 - 1.5 / r);
        CHECK(light.g_infinity({r, 0, 1}) == doctest::Approx(g).epsilon(1e-11));
        CHECK(1 / disc_matter(*spacetime, r).u_t == doctest::Approx(g).epsilon(1e-14));
    }
}

// v^2 = M/(r - 2M) in the static frame; across the line of sight what is left of it is 1/gamma.
TEST_CASE_FIXTURE(Fixture,
                  "disc light: gravity's part of g is that of matter at rest, Doppler's that of its motion there") {
    for (const double r : {3.0, 5.0, 40.0}) {
        const double rest = std::sqrt(1 - 1 / r), v2 = 0.5 / (r - 1);
        const reference::Shift shift = light.shift({r, 0, 1});
        CHECK(shift.gravity == doctest::Approx(rest).epsilon(1e-13));
        CHECK(shift.doppler == doctest::Approx(std::sqrt(1 - v2)).epsilon(1e-10));
        LightSpec part;
        part.gravity = false;
        CHECK(shift.seen(part) == shift.doppler);
        part.doppler = false;
        CHECK(shift.seen(part) == 1.0);
    }
    // The renderer's rows: without one part the frequency of a photon of L_z = 0.8 r_s E is the other's inverse.
    const double r = 5.0, l = 0.8;
    const reference::Shift shift = light.shift({r, l, 1});
    const auto inverse = [&](ShiftParts parts) {
        const TexelGrid row = disc_flow_row(*spacetime, r, 2 * r, parts);
        return row.texels[1] - l * row.texels[2];
    };
    CHECK(inverse({}) == doctest::Approx(1 / shift.seen({})).epsilon(1e-6));
    CHECK(inverse({true, false}) == doctest::Approx(1 / shift.doppler).epsilon(1e-6));
    CHECK(inverse({false, true}) == doctest::Approx(1 / shift.gravity).epsilon(1e-6));
    CHECK(inverse({false, false}) == doctest::Approx(1.0).epsilon(1e-6));
    // A straight ray of L_z = 0.8 r_s E across the orbit's plane: Doppler's factor of special relativity for the sine L/r.
    LightSpec straight;
    straight.lensing = false;
    const reference::Shift seen = reference::DiscLight(*metric, disc, straight).shift({r, l, 1});
    const double v = std::sqrt(0.5 / (r - 1));
    CHECK(seen.doppler == doctest::Approx(std::sqrt(1 - v * v) / (1 - v * l / r)).epsilon(1e-9));
    CHECK(inverse({true, true, true}) == doctest::Approx(1 / seen.seen(straight)).epsilon(1e-6));
}

// Frank, King and Raine, Accretion Power in Astrophysics (2002), eq. 5.43: sigma T*^4 = 3 G M Mdot/(8 pi R^3), T* = 1.3e7 K for
// 1e17 g/s onto a solar mass at 1e6 cm. Far out the relativistic flux is that, but for what the inner rim takes.
TEST_CASE_FIXTURE(Fixture, "disc light: accretion in physical units gives the textbook's temperature") {
    constexpr double kSun_cm = 2.953250077e5, kPrinted = 0.05;  // r_s; the book's figure has two digits
    constexpr double kEddington_g_s = 1.25707e38 / 0.1 / (2.99792458e10 * 2.99792458e10);
    const double r = 1e4, flux = disc_flux(*spacetime, {r}).front(), rate = 1e17 / kEddington_g_s;
    const double star = 1.3e7 * std::pow(r * kSun_cm / 1e6, -0.75);
    const double rim = std::pow(luminet_flux(2 * r) * 8 * M_PI * std::pow(2 * r, 3) / 3, 0.25);
    CHECK(disc_temperature_K(flux, 1, rate) == doctest::Approx(star * rim).epsilon(kPrinted));
    const double exact =
        std::pow(3 * 1.32712440018e26 * 1e17 / (8 * M_PI * std::pow(r * kSun_cm, 3) * 5.670374419e-5), 0.25);
    CHECK(disc_temperature_K(flux, 1, rate) == doctest::Approx(exact * rim).epsilon(1e-3));
    // T ~ (rate/mass)^(1/4); the reference has the same hottest ring.
    const double peak = disc_flux_peak(*spacetime).flux;
    CHECK(disc_temperature_K(peak, 1.6e9, 0.1) ==
          doctest::Approx(0.5 * disc_temperature_K(peak, 1e8, 0.1)).epsilon(1e-12));
    DiscSpec heated = disc;
    heated.accretion = AccretionSpec{1e8, 0.1};
    const reference::DiscLight other{*metric, heated, {}};
    CHECK(other.hottest_K() == doctest::Approx(disc_temperature_K(peak, 1e8, 0.1)).epsilon(1e-5));
    fmt::print("hottest ring about 1e8 suns at a tenth of Eddington's rate: {:.1f} K\n", other.hottest_K());
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
            CHECK(light.g_infinity({r, l, radial}) == doctest::Approx(1 / frequency).epsilon(1e-9));
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
    const reference::DiscLight light(tracer->matter(), *scene.disc, scene.light);
    const auto curve = reference::isoradial(scene, 3.0, 1, 7200);
    REQUIRE(curve);
    REQUIRE(curve->size() == 7200);
    double least = 1e9, most = 0;
    for (const auto& [x, y] : *curve) {
        const auto ray = tracer->ray(x, y);
        const double z = 1 / light.g_infinity({3.0, ray->l_z, 1});
        least = std::min(least, z);
        most = std::max(most, z);
    }
    constexpr double kBetween = 4e-7;  // extremes between two of the 7200 points: (pi/7200)^2 of the curvature
    CHECK(std::fabs(least - 0.8166661528) <= kBetween + kTolerance);
    CHECK(std::fabs(most - 2.0117609719) <= kBetween + kTolerance);
    fmt::print("1 + z on the ring of 6 M from 60 degrees: {:.10f} to {:.10f}\n", least, most);
}

}  // namespace
