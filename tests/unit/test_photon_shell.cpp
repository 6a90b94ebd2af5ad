// Orbits of light: their exponents, drags and delays against figures of an independent computation, complete elliptic integrals and closed
// forms, to the ends of the photon shell and of the spin.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "spacetime/photon_shell.h"
#include "support/metrics.h"

namespace {

using namespace nullscope;

constexpr double kPhotonShellPi = M_PI, kPhotonShellRounding = 2e-14, kPrinted = 6e-12;

PhotonOrbit orbit_of(const Spacetime& spacetime, double theta, double psi) {
    const auto orbit = photon_orbit(spacetime, theta, psi);
    REQUIRE(orbit);
    return *orbit;
}
PhotonOrbit circle_of(const char* metric, const std::map<std::string, double>& parameters) {
    return orbit_of(**make_spacetime(metric, parameters), 0.5 * kPhotonShellPi, 0.0);
}
bool near(double value, double wanted, double part) { return std::fabs(value - wanted) <= part * std::fabs(wanted); }
std::string refusal(const char* metric, const std::map<std::string, double>& parameters) {
    const auto orbit = photon_orbit(**make_spacetime(metric, parameters), 1.0, 1.0);
    return orbit ? "" : orbit.error().message();
}

TEST_CASE("photon orbits of rotating holes: gamma, drag and delay of other computations") {
    struct Known {
        double spin, r_m, gamma, drag, delay_m;  // M = 1
        bool polar;
    };
    for (const Known& k : {Known{0.5, 3, 3.03579403816, 0.592526324658, 16.0695773296, false},
                           {0.5, 2.8832177419264, 3.02275789048, 0.634067707052, 16.0482088060, true},
                           {0.9, 3, 2.81894652031, 1.02366242833, 15.5605482451, false},
                           {0.9, 2.5599968693657, 2.63962283837, 1.32371419592, 15.3140369113, true}}) {
        CAPTURE(k.spin);
        CAPTURE(k.r_m);
        const auto metric = test::kerr(k.spin);
        const auto orbit = k.polar ? photon_orbit(*metric, 0.0, 1.0) : photon_orbit_at(*metric, 0.5 * k.r_m);
        REQUIRE(orbit);
        CHECK(near(2.0 * orbit->r, k.r_m, 1e-13));
        CHECK(near(orbit->gamma, k.gamma, kPrinted));
        CHECK(near(orbit->drag, k.drag, kPrinted));
        CHECK(near(2.0 * orbit->delay, k.delay_m, kPrinted));
        if (!k.polar) continue;
        CHECK(orbit->lambda == 0.0);
        CHECK(orbit->azimuth == orbit->drag + kPhotonShellPi);
        const auto same = photon_orbit_at(*metric, orbit->r);
        REQUIRE(same);
        CHECK(near(same->gamma, orbit->gamma, kPhotonShellRounding));
        CHECK(std::fabs(same->lambda) < 1e-14);
    }
}

// G, the integrals of cos^2(theta)/W and lambda/(W sin^2(theta)) by the standard library's complete integrals; the last not next to a pole.
TEST_CASE("photon orbits of rotating holes: they are critical, and their integrals complete elliptic ones") {
    for (const double spin : {1e-3, 0.3, 0.9, 0.999})
        for (const double charge : {0.0, 0.03, 0.4})
            for (const double theta : {0.5 * kPhotonShellPi, 1.2, 0.3})
                for (const double psi : {0.0, 0.1, 1.0, 1.9, 3.0, kPhotonShellPi}) {
                    if (spin * spin + charge * charge > 0.9998) continue;
                    CAPTURE(spin);
                    CAPTURE(charge);
                    CAPTURE(theta);
                    CAPTURE(psi);
                    const AxialMetric metric("kerr-newman", spin, charge);
                    const PhotonOrbit o = orbit_of(metric, theta, psi);
                    const double a = metric.a(), r = o.r, delta = metric.delta(r), x = r * r + a * a - a * o.lambda,
                                 k2 = o.eta + std::pow(o.lambda - a, 2);
                    CHECK(near(x * x, delta * k2, 1e-13));
                    CHECK(near(4 * r * x, (2 * r - 1) * k2, 1e-13));
                    // R'' = 8 r^2 + 4 X - 2 K, which cancels
                    const double curvature = 8 * r * r + 4 * x - 2 * k2;
                    const double w = o.eta + o.lambda * o.lambda - a * a,
                                 p = 0.5 * (w + std::sqrt(w * w + 4 * a * a * o.eta)), u = o.eta / p,
                                 whole = p + a * a * u, m = a * a * u / whole, scale = 2 / std::sqrt(whole);
                    const double first = std::comp_ellint_1(std::sqrt(m)), second = std::comp_ellint_2(std::sqrt(m)),
                                 mino = scale * first;
                    CHECK(near(o.gamma, std::sqrt(curvature / 2) * mino, 1e-12));
                    CHECK(near(o.drag, a * (x / delta - 1) * mino, 1e-12));
                    // a^2 u cos^2 = whole - W^2 of the integrand 1/W with the angle from the equator turned over
                    const double latitude = whole * mino - 2 * std::sqrt(whole) * second;
                    const double time = (r * r + a * a) * x / delta + a * (o.lambda - a);
                    CHECK(near(o.delay, time * mino + (a * a * u * mino - latitude), 1e-12));
                    const double third = std::comp_ellint_3(std::sqrt(m), -u / (1 - u));
                    if (u < 0.99) CHECK(near(o.azimuth - o.drag, o.lambda / (1 - u) * scale * third, 1e-12));
                }
}

TEST_CASE("photon orbits of rotating holes: the equatorial ones, the ends of the shell, without spin, extremal") {
    for (const double spin : {0.1, 0.9, 0.9999}) {
        const auto metric = test::kerr(spin);
        for (const double psi : {0.0, kPhotonShellPi}) {
            CAPTURE(spin);
            CAPTURE(psi);
            const PhotonOrbit o = orbit_of(*metric, 0.5 * kPhotonShellPi, psi);
            // Bardeen, Press and Teukolsky (1972): r = 2 M (1 + cos(2/3 acos(-+a/M))).
            CHECK(near(o.r, 1 + std::cos(2.0 / 3.0 * std::acos(psi == 0.0 ? -spin : spin)), 1e-13));
            CHECK(std::fabs(o.eta) < 1e-13);
            CHECK((psi == 0.0 ? o.lambda > 0 : o.lambda < 0));
            const auto same = photon_orbit_at(*metric, o.r);
            REQUIRE(same);
            CHECK(near(same->gamma, o.gamma, 1e-10));  // of the rounding of r, next to the horizon
            const auto beside = photon_orbit_at(*metric, o.r + (psi == 0.0 ? -1e-9 : 1e-9));
            REQUIRE(!beside);
            CHECK(beside.error().message().find("no photon orbit at r = ") != std::string::npos);
        }
    }
    const double b = 1.5 * std::sqrt(3.0);
    for (const double psi : {0.0, 1.0, 0.5 * kPhotonShellPi, kPhotonShellPi}) {  // to first order in the spin
        constexpr double kSpin = 1e-9;
        const PhotonOrbit o = orbit_of(AxialMetric("kerr", kSpin, 0.0), 0.5 * kPhotonShellPi, psi);
        CHECK(near(o.r, 1.5, kSpin));
        CHECK(near(o.gamma, kPhotonShellPi, kSpin));
        CHECK(near(o.delay, kPhotonShellPi * b, kSpin));
        CHECK(near(o.drag, 0.5 * kSpin * 2.0 * kPhotonShellPi / b, 10 * kSpin));
        CHECK(near(std::fabs(o.azimuth), kPhotonShellPi, kSpin));
        CHECK(std::fabs(o.lambda - b * std::cos(psi)) < 1e-8);
        CHECK(std::fabs(o.eta - std::pow(b * std::sin(psi), 2)) < 1e-8);
    }
    CHECK(photon_orbit_at(AxialMetric("kerr", 1e-300, 0.0), 1.5));
    // Extremal: s (r - s - 2 a cos(psi)) = 0, so that r = 1 - cos(psi)/2 outside of the horizon, and gamma = sqrt(2 r s) G.
    const AxialMetric extremal("kerr", 1.0, 0.0);
    for (const double psi : {kPhotonShellPi, 2.0, 1.2}) {
        const PhotonOrbit o = orbit_of(extremal, 0.5 * kPhotonShellPi, psi);
        const double cosine = std::cos(psi), at = 1.0 - cosine;
        CHECK(near(o.r, at, 1e-14));
        CHECK(std::isfinite(o.gamma));
    }
    CHECK(orbit_of(extremal, 0.5 * kPhotonShellPi, 1.0472).gamma < 0.01);
    const auto sunk = photon_orbit(extremal, 0.5 * kPhotonShellPi, 1.0);
    REQUIRE(!sunk);
    CHECK(sunk.error().message().find("in the horizon of an extremal hole") != std::string::npos);
}

TEST_CASE("photon orbits without spin: closed forms") {
    const double b = 1.5 * std::sqrt(3.0);
    for (const double psi : {0.0, 1.0, 2.0}) {
        const PhotonOrbit o = orbit_of(*test::spherical("schwarzschild"), 0.7, psi);
        CHECK(o.r == 1.5);
        CHECK(near(o.gamma, kPhotonShellPi, 1e-15));
        CHECK(o.drag == 0.0);
        CHECK(std::fabs(o.azimuth) == kPhotonShellPi);
        CHECK(near(2.0 * o.delay, 16.32419427810796, 1e-15));
        CHECK(near(o.lambda, b * std::sin(0.7) * std::cos(psi), kPhotonShellRounding));
        CHECK(near(o.lambda * o.lambda + o.eta, b * b, kPhotonShellRounding));
    }
    // Reissner and Nordstrom, M = 1: V = (1 - 2/r + Q^2/r^2)/r^2 and zeta = 1/r, with dV/dzeta = 0:
    //     gamma = pi sqrt(-V''/2) = pi sqrt(2 - 3/r_c),   r_c = (3 + sqrt(9 - 8 Q^2))/2,
    // above Q = 1, where there is no horizon, too.
    for (const double charge : {0.5, 0.9, 1.0, 1.05}) {
        CAPTURE(charge);
        const double r = 0.5 * (3.0 + std::sqrt(9.0 - 8.0 * charge * charge));
        const PhotonOrbit o = circle_of("reissner-nordstrom", {{"charge", charge}});
        CHECK(near(2.0 * o.r, r, kPhotonShellRounding));
        CHECK(near(o.gamma, kPhotonShellPi * std::sqrt(2.0 - 3.0 / r), 1e-13));
        CHECK(near(2.0 * o.delay, kPhotonShellPi * r / std::sqrt(1.0 - 2.0 / r + charge * charge / (r * r)), 1e-13));
    }
    const PhotonOrbit star = circle_of("neutron-star", {{"radius", 1.3}});
    CHECK(near(star.gamma, kPhotonShellPi, 1e-15));
    // A cosmological constant moves b_c and the delay, and not the exponent.
    MetricParameters kottler;
    kottler.formulas["A"] = "1 - 1/r - 0.005*r^2";
    const PhotonOrbit o = orbit_of(**make_spacetime("formula", kottler), 0.5 * kPhotonShellPi, 0.0);
    CHECK(near(o.gamma, kPhotonShellPi, 1e-12));
    CHECK(near(o.delay, kPhotonShellPi / std::sqrt(1.0 / (b * b) - 0.005), 1e-12));
    CHECK(near(circle_of("ellis", {{"throat", 2.0}}).gamma, kPhotonShellPi, 1e-15));
    CHECK(near(circle_of("ellis", {{"throat", 2.0}}).delay, 2.0 * kPhotonShellPi, 1e-15));
    // Janis, Newman and Winicour: of the product that forms h, pi for every g.
    for (const double g : {0.6, 0.75, 1.0})
        CHECK(near(circle_of("janis-newman-winicour", {{"gamma", g}}).gamma, kPhotonShellPi, 1e-13));
}

TEST_CASE("photon orbits: refused in one line where light has none") {
    CHECK(refusal("minkowski", {}) == "minkowski: there is no photon sphere");
    CHECK(refusal("reissner-nordstrom", {{"charge", 1.5}}) == "reissner-nordstrom: there is no photon sphere");
    CHECK(refusal("neutron-star", {{"radius", 2.5}}).find("is not outside of the surface, r = 2.5") !=
          std::string::npos);
    CHECK(refusal("dneg-wormhole", {{"length", 0.1}}).find("in the tube") != std::string::npos);
    CHECK(refusal("dneg-wormhole", {{"length", 0.0}}).empty());
    CHECK(refusal("schwarzschild", {}).empty());
}

}  // namespace
