// What every metric of the registry must satisfy, at its default parameters and at the ends of their ranges.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <numbers>
#include <set>

#include "spacetime/registry.h"
#include "support/metrics.h"

using namespace nullscope;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 2e-15;   // a few units in the last place of a product of a few factors
constexpr double kDifference = 1e-9;  // central differences with step 1e-6: step^2 and 2^-53 / step, of values about 1
constexpr double kStep = 1e-6;
constexpr double kWeakFieldQ = 1e-4;    // r_s / impact parameter
constexpr double kWeakFieldNext = 2.0;  // bending = 2 q (1 + c q + ...), |c| <= 15 pi / 32 = 1.47 for charge 0 ... 1

struct Case {
    std::string label;
    std::shared_ptr<const Spacetime> spacetime;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const MetricEntry& entry : metric_registry()) {
        const std::string key(entry.key);
        all.push_back({key, *make_spacetime(key, {})});
        for (const MetricParameter& parameter : entry.parameters) {
            for (const double value : {parameter.low, parameter.high}) {
                const std::string name(parameter.name);
                const std::string label = key + " " + name + " = " + std::to_string(value);
                if (auto made = make_spacetime(key, {{name, value}}))
                    all.push_back({label, *made});  // else: by its fault
            }
        }
    }
    const double divide = std::sqrt(1.125);  // above it V has no maximum
    for (const double charge :
         {1.0, std::nextafter(1.0, 2.0), 1.03, std::nextafter(divide, 1.0), std::nextafter(divide, 2.0), 1.2})
        all.push_back({"reissner-nordstrom charge = " + std::to_string(charge),
                       *make_spacetime("reissner-nordstrom", {{"charge", charge}})});
    return all;
}

void each_metric(const auto& check) {
    for (const Case& one : cases()) {
        CAPTURE(one.label);
        check(one.spacetime);
    }
}
void each_spherical_metric(const auto& check) {
    each_metric([&](const auto& spacetime) {
        if (const auto metric = test::spherical(spacetime)) check(metric);
    });
}

// Radii from just outside the horizon (or from 0.01) to 10^6.
std::vector<double> radii(const Spacetime& spacetime) {
    const double innermost = std::max(spacetime.camera_range().low, -2e6);
    std::vector<double> values;
    if (innermost < 0) values = {-1e6, -30.0, -1.0, -1e-3, 0.0};  // a wormhole's far side and throat
    for (double offset = innermost > 0 ? 1e-6 : 1e-2; offset < 2e6; offset *= 3.0)
        values.push_back(std::max(innermost, 0.0) + offset);
    return values;
}

double potential(const Spacetime& s, double zeta) { return s.lapse_squared(1.0 / zeta) * zeta * zeta; }

double chi_from_zeta(const SphericalMetric& s, double zeta) { return s.chi()->chi_from_radius(1.0 / zeta); }
double zeta_from_chi(const SphericalMetric& s, double chi) { return 1.0 / s.chi()->radius_from_chi(chi); }

double slope(const auto& f, double x) { return (f(x + kStep) - f(x - kStep)) / (2.0 * kStep); }

// Angle swept by a ray from infinity to infinity: the integral of h with sin(chi) = k sin(alpha), alpha in [0, pi/2],
// twice, by the tanh-sinh rule (Takahasi and Mori 1974); its error here is that of rounding.
double swept_angle(const SphericalMetric& spacetime, double k) {
    constexpr double kTanhSinhStep = 1.0 / 16.0;
    double sum = 0.0;
    for (int i = -56; i <= 56; ++i) {
        const double t = kTanhSinhStep * i;
        const double alpha = 0.25 * kPi * (1.0 + std::tanh(0.5 * kPi * std::sinh(t)));
        const double weight = 0.125 * kPi * kPi * std::cosh(t) / std::pow(std::cosh(0.5 * kPi * std::sinh(t)), 2);
        const double sine = k * std::sin(alpha);
        const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
        sum += weight * spacetime.chi()->bending_density(std::atan2(sine, cosine)) / cosine;
    }
    return 2.0 * kTanhSinhStep * sum;
}

// True if the call ends the process by abort().
template <class Call>
bool aborts(Call call) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(1);
        call();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}

}  // namespace

TEST_CASE("registry: keys are unique, each makes the metric of its name") {
    std::set<std::string_view> keys;
    for (const MetricEntry& entry : metric_registry()) {
        CHECK(keys.insert(entry.key).second);
        CHECK(find_metric(entry.key) == &entry);
        CHECK(entry.help.ends_with("."));
        const auto made = make_spacetime(std::string(entry.key), {});
        REQUIRE(made);
        CHECK((*made)->name() == entry.key);
        for (const MetricParameter& p : entry.parameters) {
            const std::string key(entry.key), name(p.name);
            CHECK((p.low <= p.fallback && p.fallback <= p.high));
            for (const double bad : {std::nextafter(p.low, -1e300), std::nextafter(p.high, 1e300), std::nan("")}) {
                const auto refused = make_spacetime(key, {{name, bad}});
                REQUIRE_FALSE(refused);
                CHECK(refused.error().message().find(name) != std::string::npos);
            }
        }
    }
    const auto typo = make_spacetime("schwarzshild", {});
    REQUIRE_FALSE(typo);
    CHECK(typo.error().kind == ErrorKind::kBadInput);
    CHECK(typo.error().message().find("nearest: schwarzschild") != std::string::npos);
    const auto parameter = make_spacetime("minkowski", {{"spin", 0.5}});
    REQUIRE_FALSE(parameter);
    CHECK(parameter.error().message() == "metric \"minkowski\" has no parameter \"spin\"; allowed: none");
    CHECK(find_metric("") == nullptr);
}

TEST_CASE("metric: signature (-,+,+,+) outside the horizon, and the inverse is the inverse") {
    each_metric([&](const auto& s) {
        for (const double r : radii(*s)) {
            for (const double theta : {0.1, 1.0, kPi / 2, 3.0}) {
                const Matrix4 g = s->metric(r, theta), inverse = s->inverse_metric(r, theta);
                // Of a rotating hole only the inverse holds Delta, here g_theta theta / g_rr, which is a difference of terms of size r^2.
                const double lost = s->axial() != nullptr ? std::max(1.0, r * r * g[1][1] / g[2][2]) : 1.0;
                for (int i = 0; i < 4; ++i) {
                    if (s->planar_rays())
                        CHECK((i == 0 ? g[i][i] < 0.0 : g[i][i] > 0.0));  // a rotating hole has an ergosphere
                    for (int j = 0; j < 4; ++j) {
                        double product = 0.0,
                               size = 0.0;  // of a rotating hole the terms next to the horizon are large and cancel
                        for (int k = 0; k < 4; ++k)
                            product += g[i][k] * inverse[k][j], size += std::fabs(g[i][k] * inverse[k][j]);
                        CHECK(std::fabs(product - (i == j)) < kRounding * std::max(1.0, size) * lost);
                        CHECK(g[i][j] == g[j][i]);
                    }
                }
                const SphericalMetric* planar = s->spherical();
                if (planar == nullptr) continue;  // not diagonal: tests/unit/test_kerr.cpp
                const double across = s->areal_radius(r);
                CHECK(g[0][0] == -s->lapse_squared(r));
                CHECK(g[1][1] == planar->radial_stretch2(r));
                CHECK(g[2][2] == across * across);
                CHECK(g[3][3] ==
                      doctest::Approx(across * across * std::sin(theta) * std::sin(theta)).epsilon(kRounding));
                CHECK(planar->root_v(r) == doctest::Approx(std::sqrt(s->lapse_squared(r)) / across).epsilon(kRounding));
            }
        }
    });
}

TEST_CASE("flat limit: A goes to 1 at infinity, and stays there where light is not bent") {
    each_metric([&](const auto& s) {
        CHECK(s->lapse_squared(INFINITY) == 1.0);
        for (double zeta = 1e-12; zeta < 1e-2; zeta *= 10.0) {
            CHECK(std::fabs(s->lapse_squared(1.0 / zeta) - 1.0) <= 2.0 * zeta);
        }
        if (s->bends_light()) return;
        CHECK_FALSE(s->photon_sphere());
        for (double zeta = 1e-3; zeta < 1e3; zeta *= 10.0) CHECK(s->lapse_squared(1.0 / zeta) == 1.0);
    });
}

TEST_CASE("horizon: A vanishes there and is positive outside") {
    each_metric([&](const auto& s) {
        if (const std::optional<double> horizon = s->horizon_radius()) {
            CHECK(std::fabs(s->lapse_squared(*horizon)) < kRounding);
        }
        for (const double r : radii(*s)) CHECK(s->lapse_squared(r) > 0.0);
    });
}

TEST_CASE("half_v_slope and half_v_curvature are the derivatives of V/2") {
    each_spherical_metric([&](const auto& s) {
        if (s->orbit_equation() == nullptr) return;
        for (double zeta = 0.01; zeta < 3.0; zeta += 0.01) {
            const double first = slope([&](double z) { return 0.5 * potential(*s, z); }, zeta);
            const double second = slope([&](double z) { return s->orbit_equation()->half_v_slope(z); }, zeta);
            // V of a large charge grows as zeta^4.
            const double size = 1.0 + zeta * zeta + std::fabs(potential(*s, zeta));
            CHECK(std::fabs(s->orbit_equation()->half_v_slope(zeta) - first) < kDifference * size);
            CHECK(std::fabs(s->orbit_equation()->half_v_curvature(zeta) - second) < kDifference * size);
        }
        CHECK(s->orbit_equation()->half_v_slope(0.0) == 0.0);
        CHECK(s->orbit_equation()->half_v_slope(1e-300) == doctest::Approx(1e-300).epsilon(kRounding));
    });
}

TEST_CASE("photon sphere: the maximum of V outside the horizon, with V = q_crit^2") {
    each_spherical_metric([&](const auto& s) {
        const std::optional<PhotonSphere> sphere = s->photon_sphere();
        if (!sphere) return;
        if (s->orbit_equation() != nullptr) {
            CHECK(std::fabs(s->orbit_equation()->half_v_slope(1.0 / sphere->radius)) < kRounding);
            CHECK(s->orbit_equation()->half_v_curvature(1.0 / sphere->radius) < 0.0);
        }
        CHECK(s->root_v(sphere->radius) == doctest::Approx(sphere->q_crit).epsilon(kRounding));
        for (const double r : radii(*s)) CHECK(s->root_v(r) <= sphere->q_crit * (1.0 + kRounding));
        CHECK(sphere->radius > s->horizon_radius().value_or(-1.0));
    });
}

TEST_CASE("chi: V = q_crit^2 sin^2 chi, both ways, to the last digits near infinity, photon sphere and horizon") {
    each_spherical_metric([&](const auto& s) {
        const std::optional<PhotonSphere> sphere = s->photon_sphere();
        if (!sphere || s->orbit_equation() == nullptr) return;  // wormholes: the test below
        const double last = s->horizon_radius() ? 1.0 / *s->horizon_radius() : (1.0 / sphere->radius);
        std::vector<double> zetas;
        for (double zeta = 1e-300; zeta < 1e-3; zeta *= 1e3) zetas.push_back(zeta);
        for (int i = 1; i < 1000; ++i) zetas.push_back(last * i / 1000.0);
        for (double offset = 1e-15; offset < 1e-2; offset *= 10.0) {
            zetas.insert(zetas.end(),
                         {(1.0 / sphere->radius) - offset, (1.0 / sphere->radius) + offset, last - offset});
        }
        std::sort(zetas.begin(), zetas.end());
        double before = 0.0;
        for (const double zeta : zetas) {
            CAPTURE(zeta);
            const double chi = chi_from_zeta(*s, zeta);
            CHECK((chi >= before && chi <= kPi));
            before = chi;
            // Back: relative, so that it says something near 0; near the horizon zeta is quadratic in pi - chi.
            CHECK(std::fabs(zeta_from_chi(*s, chi) / zeta - 1.0) < kRounding);
            const double root_v = zeta * std::sqrt(s->lapse_squared(1.0 / zeta));
            CHECK(std::fabs(sphere->q_crit * std::sin(chi) - root_v) < kRounding * std::min(zeta, 1.0));
        }
        CHECK(chi_from_zeta(*s, 0.0) == 0.0);
        CHECK(zeta_from_chi(*s, 0.0) == 0.0);
        CHECK(chi_from_zeta(*s, (1.0 / sphere->radius)) == doctest::Approx(kPi / 2).epsilon(kRounding));
        CHECK(zeta_from_chi(*s, kPi / 2) == doctest::Approx((1.0 / sphere->radius)).epsilon(kRounding));
        if (s->horizon_radius()) CHECK(zeta_from_chi(*s, kPi) == doctest::Approx(last).epsilon(kRounding));
        for (double chi = 1e-8; chi < kPi - 1e-7; chi += 1e-3) {
            // d chi/d zeta = 1/(h q_crit): flat rounding of zeta becomes large only where h goes to 0, at the horizon.
            CHECK(std::fabs(chi_from_zeta(*s, zeta_from_chi(*s, chi)) - chi) <
                  kRounding / s->chi()->bending_density(chi));
        }
    });
}

TEST_CASE("chi on both sides of a throat: V = q_crit^2 sin^2 chi, both ways, grows inward, mirrored") {
    each_spherical_metric([&](const auto& s) {
        if (s->inner_end() != InnerEnd::kOtherSky) return;
        const double q_crit = s->photon_sphere()->q_crit, mouth = 0.5 * s->tube_beyond(-1e300) / q_crit;
        CHECK(s->tube_beyond(1e300) == 0.0);
        CHECK(s->tube_beyond(0.0) * 2 == s->tube_beyond(-1e300));
        for (double l = -mouth; l < mouth; l += 0.1 * mouth) CHECK(s->chi()->chi_from_radius(l) == kPi / 2);
        double before = 0.0;
        // As near to a tube's mouth as l tells the distance from it to some digits.
        for (double off = 1e9; off > (mouth > 0.0 ? 1e-4 : 1e-12); off *= 0.7) {
            const double l = mouth + off, chi = s->chi()->chi_from_radius(l);
            CHECK((chi > before && chi <= kPi / 2));
            before = chi;
            CHECK(std::fabs(q_crit * std::sin(chi) / s->root_v(l) - 1.0) < kRounding);
            CHECK(std::fabs(s->chi()->chi_from_radius(-l) - (kPi - chi)) < kRounding);
            // d l/d chi = h V^-1 q_crit: flat rounding of chi, and relative rounding of l.
            const double rate = q_crit * s->chi()->bending_density(chi) / std::pow(s->root_v(l), 2);
            CHECK(std::fabs(s->chi()->radius_from_chi(chi) - l) < kRounding * (l + chi * rate));
        }
        CHECK(s->chi()->chi_from_radius(0.0) == doctest::Approx(kPi / 2).epsilon(kRounding));
        // h = (q_crit/V) V... : d chi/d l = -V/(q_crit h), by central differences.
        for (double l = -20.0; l <= 20.0; l += 0.37) {
            if (std::fabs(l) <= mouth + 10 * kStep) continue;
            const double rate = slope([&](double x) { return s->chi()->chi_from_radius(x); }, l),
                         v = std::pow(s->root_v(l), 2);
            CHECK(std::fabs(s->chi()->bending_density(s->chi()->chi_from_radius(l)) * rate * q_crit / v + 1.0) <
                  1e-6 * (1.0 + std::fabs(l)));
        }
    });
}

TEST_CASE("h: d zeta = q_crit h d chi, 1 at infinity") {
    each_spherical_metric([&](const auto& s) {
        const std::optional<PhotonSphere> sphere = s->photon_sphere();
        if (!sphere || s->orbit_equation() == nullptr) return;
        for (double chi = 0.01; chi < kPi - 0.01; chi += 0.01) {
            const double rate = slope([&](double c) { return zeta_from_chi(*s, c); }, chi);
            CHECK(std::fabs(s->chi()->bending_density(chi) - rate / sphere->q_crit) < kDifference);
        }
        CHECK(s->chi()->bending_density(0.0) == doctest::Approx(1.0).epsilon(kRounding));
    });
}

TEST_CASE("weak field: light that passes far away is bent by 2 r_s/b") {
    each_spherical_metric([&](const auto& s) {
        const std::optional<PhotonSphere> sphere = s->photon_sphere();
        if (!sphere || s->inner_end() == InnerEnd::kOtherSky) return;  // no mass at all, or none that falls off as 1/r
        const double bending = swept_angle(*s, kWeakFieldQ / sphere->q_crit) - kPi;
        CHECK(std::fabs(bending / (2.0 * kWeakFieldQ) - 1.0) < kWeakFieldNext * kWeakFieldQ);
    });
}

TEST_CASE("schwarzschild: horizon, photon sphere, closest approach and known deflections") {
    const auto s = test::spherical("schwarzschild");
    CHECK(*s->horizon_radius() == 1.0);
    CHECK(s->photon_sphere()->radius == doctest::Approx(1.5).epsilon(kRounding));
    CHECK(s->photon_sphere()->q_crit == doctest::Approx(2.0 / (3.0 * std::sqrt(3.0))).epsilon(kRounding));
    CHECK(s->chi()->bending_density(kPi / 2) == doctest::Approx(1.0).epsilon(kRounding));  // Bozza's coefficient a
    CHECK(s->chi()->bending_density(kPi) == 0.0);
    // Deflection at impact parameter b = 10 M, 100 M, 1000 M, from 50-digit arithmetic.
    const double q_crit = s->photon_sphere()->q_crit;
    const auto bending = [&](double b_over_m) { return swept_angle(*s, 2.0 / b_over_m / q_crit) - kPi; };
    constexpr double kQuadrature = 1e-14;  // rounding of a sum of 113 terms
    CHECK(std::fabs(bending(10) - 0.59039578760582732) < kQuadrature);
    CHECK(std::fabs(bending(100) - 0.041222539749273652) < kQuadrature);
    CHECK(std::fabs(bending(1000) - 0.0040118238099253647) < kQuadrature);
    CHECK(std::fabs(bending(6) - 1.7193883102301686) < kQuadrature);
    CHECK(aborts([&] { (void)s->chi()->chi_from_radius(0.9999999); }));
    CHECK(aborts([&] { (void)s->chi()->chi_from_radius(-1e9); }));
    CHECK(aborts([&] { (void)s->chi()->chi_from_radius(std::nan("")); }));
    CHECK_FALSE(aborts([&] { (void)s->chi()->chi_from_radius(1.0); }));
}

// Strong deflection (Bozza 2002): bending = -abar ln(b/b_crit - 1) + bbar. With V = q_crit^2 sin^2 chi the sweep at k -> 1 is
// twice abar asinh(k/k') plus the integral of (h - abar sin)/cos over a quarter turn: bbar = abar ln 2 + 2 integral - pi.
double strong_offset(const SphericalMetric& s) {
    constexpr double kTanhSinhStep = 1.0 / 16.0;
    const double abar = s.chi()->bending_density(kPi / 2);
    double sum = 0.0;
    for (int i = -50; i <= 50; ++i) {
        const double t = kTanhSinhStep * i, u = 0.5 * kPi * std::sinh(t);
        const double rest = 0.5 * kPi / (1.0 + std::exp(2.0 * u));  // pi/2 - chi
        const double weight = 0.125 * kPi * kPi * std::cosh(t) / std::pow(std::cosh(u), 2);
        sum += weight * (s.chi()->bending_density(0.5 * kPi - rest) - abar * std::cos(rest)) / std::sin(rest);
    }
    return abar * std::log(2.0) + 2.0 * kTanhSinhStep * sum - kPi;
}

TEST_CASE("reissner-nordstrom: photon sphere, critical impact parameter and strong deflection of three charges") {
    struct Known {
        double charge, photon_m, b_crit_m, outer_m, abar, bbar;  // M = 1
    };
    const double root2 = std::sqrt(2.0);
    for (const Known& k :
         {Known{0.5, 2.822875655532295, 4.967914329471482, 1.866025403784439, 1.0329311, -0.39626834},
          Known{0.8, 2.48488578017961, 4.545986272128442, 1.6, 0, 0}, Known{1.0, 2, 4, 1, root2, -0.7332029}}) {
        CAPTURE(k.charge);
        const auto s = test::spherical("reissner-nordstrom", {{"charge", k.charge}});
        constexpr double kPrinted = 1e-12;  // the digits of the literature's numbers
        CHECK(std::fabs(2 * s->photon_sphere()->radius - k.photon_m) < kPrinted);
        CHECK(std::fabs(2 / s->photon_sphere()->q_crit - k.b_crit_m) < kPrinted);
        CHECK(std::fabs(2 * *s->horizon_radius() - k.outer_m) < kPrinted);
        // abar = sqrt(2 A_c/(2 A_c - r^2 A'')) (Bozza 2002): with A'' of A = 1 - 2M/r + Q^2/r^2.
        const double r = k.photon_m, q2 = k.charge * k.charge, a = 1 - 2 / r + q2 / (r * r),
                     a2 = -4 / (r * r * r) + 6 * q2 / (r * r * r * r);
        CHECK(std::fabs(s->chi()->bending_density(kPi / 2) - std::sqrt(2 / (2 * a - r * r * a2))) < kPrinted);
        const double abar = s->chi()->bending_density(kPi / 2), bbar = strong_offset(*s);
        std::printf("charge %g: photon sphere %.15g M, b_crit %.15g M, abar %.13f, bbar %.13f\n", k.charge,
                    2 * s->photon_sphere()->radius, 2 / s->photon_sphere()->q_crit, abar, bbar);
        if (k.abar != 0) CHECK(std::fabs(abar - k.abar) < 1e-7);  // as printed
        if (k.bbar != 0) CHECK(std::fabs(bbar - k.bbar) < 1e-7);
        // The limit itself: what is left at b/b_crit - 1 = 1e-6 is of order 1e-6 ln 1e-6.
        CHECK(std::fabs(swept_angle(*s, 1.0 / (1.0 + 1e-6)) - kPi + abar * std::log(1e-6) - bbar) < 5e-5);
    }
    for (const auto& s : {test::spherical("schwarzschild"), test::spherical("reissner-nordstrom", {{"charge", 0.0}})}) {
        CHECK(std::fabs(s->chi()->bending_density(kPi / 2) - 1.0) < 1e-14);
        CHECK(std::fabs(strong_offset(*s) - (std::log(216 * (7 - 4 * std::sqrt(3.0))) - kPi)) < 1e-12);
    }
}

TEST_CASE("janis-newman-winicour: gamma = 1 is Schwarzschild; the photon sphere of others") {
    const auto flat_field = test::spherical("janis-newman-winicour", {{"gamma", 1.0}}),
               hole = test::spherical("schwarzschild");
    for (const double r : radii(*hole)) {
        const double above = 1.0 - 1.0 / r;  // Schwarzschild forms it so: a rounding, over this
        CHECK(std::fabs(flat_field->lapse_squared(r) / hole->lapse_squared(r) - 1.0) < kRounding / above);
        CHECK(std::fabs(flat_field->chi()->chi_from_radius(r) - hole->chi()->chi_from_radius(r)) <
              kRounding / std::sqrt(above));
    }
    for (double chi = 0.01; chi < kPi; chi += 0.01)
        CHECK(std::fabs(flat_field->chi()->bending_density(chi) - hole->chi()->bending_density(chi)) <
              4 * kRounding + kRounding / (kPi - chi));
    for (const double gamma : {0.6, 0.75, 0.9}) {
        const auto s = test::spherical("janis-newman-winicour", {{"gamma", gamma}});
        CHECK(s->photon_sphere()->radius == doctest::Approx((1.0 + 2.0 * gamma) / (2.0 * gamma)).epsilon(kRounding));
        // dphi = dr/(R^2 sqrt(q^2 - V)): d chi/dr = -1/(q_crit R^2 h), by central differences.
        for (double r = 1.1 * *s->horizon_radius(); r < 20.0; r *= 1.05) {
            const double rate = slope([&](double x) { return s->chi()->chi_from_radius(x); }, r);
            const double expected = -1.0 / (s->photon_sphere()->q_crit * std::pow(s->areal_radius(r), 2) *
                                            s->chi()->bending_density(s->chi()->chi_from_radius(r)));
            CHECK(std::fabs(rate / expected - 1.0) < 1e-7);
            CHECK(std::fabs(s->chi()->radius_from_chi(s->chi()->chi_from_radius(r)) / r - 1.0) < 1e-12);
        }
    }
}

TEST_CASE(
    "barrier: V about what divides is its polynomial, grows inward without bound, and has no slope there if there is a "
    "photon sphere") {
    int walls = 0;
    each_spherical_metric([&](const auto& s) {
        const auto barrier = s->barrier();
        CHECK(barrier.has_value() == (s->inner_end() == InnerEnd::kSameSky));
        if (!barrier) return;
        ++walls;
        for (double zeta = 1e-3; zeta < 1e3; zeta *= 1.1) {
            const double x = zeta - barrier->zeta,
                         v = barrier->v +
                             x * (barrier->c[0] + x * (barrier->c[1] + x * (barrier->c[2] + x * barrier->c[3])));
            CHECK(std::fabs(v - potential(*s, zeta)) <
                  4 * kRounding * (barrier->v + std::pow(x, 2) + std::pow(std::fabs(x), 4)));
        }
        CHECK(barrier->c[3] > 0.0);
        const bool photons = s->camera_range().low > 0.0;
        CHECK((barrier->c[0] == 0.0) == photons);
        if (photons) CHECK(std::fabs(s->orbit_equation()->half_v_slope(barrier->zeta)) < kRounding);
        if (!photons) CHECK(barrier->c[0] > 0.0);
        if (!photons) CHECK(std::fabs(barrier->c[1]) < 1.0);
        CHECK_FALSE(s->horizon_radius());
        CHECK_FALSE(s->can_have_disc());
    });
    CHECK(walls == 6);  // charge 3 from the registry's range, and five of the list
}

TEST_CASE("chi is there where there is a photon sphere, and nowhere else; every metric is of one kind") {
    each_metric([&](const auto& s) {
        CHECK((s->spherical() == nullptr) != (s->axial() == nullptr));
        if (s->spherical() != nullptr) CHECK((s->spherical()->chi() != nullptr) == s->photon_sphere().has_value());
    });
}

TEST_CASE("equator: slopes and curvatures are derivatives, its products those of the metric") {
    each_metric([&](const auto& s) {
        const double from = std::max(s->camera_range().low, 0.3);
        CHECK(s->equator(from + 1.0).has_value() == (s->orbit_equation() != nullptr || s->axial() != nullptr));
        if (!s->equator(from + 1.0)) return;
        for (double r = 1.01 * from; r < 100.0; r *= 1.1) {
            const Equator e = *s->equator(r);
            const Matrix4 g = s->metric(r, kPi / 2);
            const double size = 1.0 + r * r + std::fabs(e.g.tt) + std::fabs(e.slope.tt) + std::fabs(e.curvature.tt);
            CHECK(std::fabs(e.g.tt - g[0][0]) < kRounding * size);
            CHECK(std::fabs(e.g.tphi - g[0][3]) < kRounding * size);
            CHECK(std::fabs(e.g.phiphi - g[3][3]) < kRounding * size);
            CHECK(std::fabs(e.across2 - (e.g.tphi * e.g.tphi - e.g.tt * e.g.phiphi)) < kRounding * size * size);
            CHECK(e.radial / e.across2 == doctest::Approx(g[1][1]).epsilon(1e-10));
            for (const auto part :
                 {&Equator::Components::tt, &Equator::Components::tphi, &Equator::Components::phiphi}) {
                CHECK(std::fabs(e.slope.*part - slope([&](double x) { return s->equator(x)->g.*part; }, r)) <
                      kDifference * size);
                CHECK(std::fabs(e.curvature.*part - slope([&](double x) { return s->equator(x)->slope.*part; }, r)) <
                      kDifference * size);
            }
        }
    });
}
