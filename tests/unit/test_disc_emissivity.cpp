// What discs shine by beside accretion: powers, tables and lamps, against closed forms and the reference's rays; lines of discs that a lamp lights.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numeric>

#include "reference/disc_emissivity.h"
#include "reference/disc_light.h"
#include "reference/metric.h"
#include "reference/reference.h"
#include "scene/disc_emissivity.h"
#include "spacetime/registry.h"
#include "spectrum/line_profile.h"

namespace {

using namespace nullscope;

std::vector<double> radii_between(double inner, double outer, int count) {
    std::vector<double> radii;
    for (int i = 0; i < count; ++i) radii.push_back(inner * std::pow(outer / inner, (i + 0.5) / count));
    return radii;
}

// Schwarzschild's, by quadrature: the ray of 1/b^2 = (1 - u0)(u0/sin delta)^2 sweeps du/sqrt(1/b^2 - u^2 + u^3) from the lamp to where that is a right
// angle. Of rays that do not turn.
double radius_met(double height, double delta) {
    const double u0 = 1 / height, over_b2 = u0 * u0 * (1 - u0) / (std::sin(delta) * std::sin(delta));
    boost::math::quadrature::tanh_sinh<double> rule;
    const auto swept = [&](double u) {
        return std::fabs(rule.integrate([&](double x) { return 1 / std::sqrt(over_b2 - x * x + x * x * x); },
                                        std::min(u0, u), std::max(u0, u)));
    };
    double low = delta < M_PI / 2 ? u0 : 0, high = delta < M_PI / 2 ? 1 : u0;
    for (int i = 0; i < 55; ++i) {
        const double middle = 0.5 * (low + high);
        ((delta < M_PI / 2) == (swept(middle) < M_PI / 2) ? low : high) = middle;
    }
    return 1 / (0.5 * (low + high));
}

TEST_CASE("disc emissivity: a lamp about a hole that does not rotate is the closed form's integral") {
    constexpr double kApart = 1e-4, kRelative = 1e-6;
    const auto hole = *make_spacetime("schwarzschild", {});
    int met = 0;
    for (const double height : {1.8, 2.5, 6.0, 40.0})
        for (const double delta : {1.575, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1}) {
            const double r = radius_met(height, delta);
            if (!(r > 3.001 && r < 1e4)) continue;
            ++met;
            CAPTURE(height);
            CAPTURE(delta);
            const double u_slope =
                (1 / radius_met(height, delta - kApart) - 1 / radius_met(height, delta + kApart)) / (2 * kApart);
            const double slope = r * r * u_slope, lapse = std::sqrt(1 - 1 / height);
            for (const double index : {1.0, 2.0, 2.7}) {
                const double energy = lapse / std::sqrt(1 - 1.5 / r);
                const double exact = std::sin(delta) / slope / r * lapse * std::pow(energy, index - 1);
                CHECK(std::fabs(lamp_light(*hole, {r}, {height, index})[0] / exact - 1) < kRelative);
            }
        }
    CHECK(met > 8);
}

TEST_CASE(
    "disc emissivity: a lamp in flat space lights by h/(h^2 + r^2)^(3/2), far from a hole too, where r^-3 is left") {
    const auto flat = [](double h, double r) { return h / std::pow(h * h + r * r, 1.5); };
    const auto space = *make_spacetime("minkowski", {});
    for (const double r : {0.1, 1.0, 7.0, 1e3})
        CHECK(std::fabs(lamp_light(*space, {r}, {4, 2})[0] / flat(4, r) - 1) < 1e-10);
    const auto hole = *make_spacetime("kerr", MetricParameters{{"spin", 0.9}});
    for (const double h : {1e5, 1e6})
        for (const double of : {0.1, 1.0, 10.0})
            CHECK(std::fabs(lamp_light(*hole, {of * h}, {h, 2})[0] / flat(h, of * h) - 1) < 40 / h);
    for (const double h : {2.0, 5.0, 20.0}) {  // the slope of its logarithm
        const std::vector<double> light = lamp_light(*hole, {1e5, 1.1e5}, {h, 2});
        CHECK(std::fabs(std::log(light[1] / light[0]) / std::log(1.1) + 3) < 1e-4);
    }
}

TEST_CASE("disc emissivity: lamps about rotating and charged holes are the reference's rays") {
    struct Case {
        SpacetimeSpec spec;
        double height, index, inner, outer;
    };
    double worst = 0;
    for (const Case& one :
         {Case{{"kerr", MetricParameters{{"spin", 0.9}}}, 2, 2, 0.8, 40},  // across the innermost stable orbit
          Case{{"kerr", MetricParameters{{"spin", -0.998}}}, 0.9, 2.5, 0.7, 20},
          Case{{"kerr-newman", MetricParameters{{"spin", 0.5}, {"charge", 0.6}}}, 5, 1.5, 1.2, 100},
          Case{{"reissner-nordstrom", MetricParameters{{"charge", 0.8}}}, 3, 2, 1, 30}}) {
        CAPTURE(one.spec.metric);
        CAPTURE(one.height);
        const auto metric = std::move(*reference::make_metric(one.spec));
        DiscSpec disc;
        disc.inner = one.inner, disc.outer = one.outer;
        const reference::DiscLight matter(*metric, disc, {});
        EmissivitySpec lamp;
        lamp.by = Emissivity::kLamp, lamp.lamp = {one.height, one.index};
        std::vector<double> radii = radii_between(one.inner, one.outer, 60);
        const std::vector<double> exact = reference::emissivity_of(*metric, matter, lamp, radii),
                                  ours = disc_emissivity(**make_spacetime(one.spec.metric, one.spec.parameters), radii,
                                                         lamp, Sense::kEastward);
        for (std::size_t i = 1; i + 1 < radii.size(); ++i) {
            CAPTURE(radii[i]);
            CHECK(std::fabs(ours[i] / exact[i] - 1) < 1e-5);
            worst = std::max(worst, std::fabs(ours[i] / exact[i] - 1));
        }
    }
    MESSAGE(fmt::format("lamps: at most {:.1e} from the reference", worst));
}

TEST_CASE("disc emissivity: powers join at their breaks, tables have powers between their rows") {
    const auto space = *make_spacetime("schwarzschild", {});
    EmissivitySpec spec;
    spec.by = Emissivity::kPowerLaw, spec.powers = {7, 1, 3}, spec.breaks = {4, 10};
    const auto at = [&](double r) { return disc_emissivity(*space, {r}, spec, Sense::kEastward)[0]; };
    CHECK(at(2) == doctest::Approx(std::pow(2.0, -7)).epsilon(1e-13));
    CHECK(at(8) == doctest::Approx(std::pow(4.0, -7) / 2).epsilon(1e-13));
    CHECK(at(20) == doctest::Approx(std::pow(4.0, -7) / 2.5 / 8).epsilon(1e-13));
    for (const double r : spec.breaks) CHECK(std::fabs(at(r * (1 + 1e-9)) / at(r * (1 - 1e-9)) - 1) < 1e-7);
    CHECK(emissivity_words(spec) == "r^-7 to 4 r_s, r^-1 to 10 r_s, r^-3");
    const auto rows = read_emissivity("# of a fit\nr,epsilon\n2, 8\n4, 1\r\n\n16, 0.5\n");
    REQUIRE(rows);
    REQUIRE(rows->size() == 3);
    CHECK((*rows)[2].value == 0.5);
    struct Wrong {
        const char* text;
        int line;
        const char* says;
    };
    for (const Wrong& wrong : {Wrong{"2,8\n2,1\n", 2, "not above"}, Wrong{"2,8\n4,-1\n", 2, "no emissivity"},
                               Wrong{"r,e\nr,e\n", 2, "no radius"}, Wrong{"2,8\nnan,1\n", 2, "no radius"},
                               Wrong{"2,8\n4,inf\n", 2, "no emissivity"}, Wrong{"2,8,1\n", 1, "not a radius and"},
                               Wrong{"2\n", 1, "not a radius and"}, Wrong{"2,\"8\n", 1, "not a radius and"},
                               Wrong{"2,8\n", 0, "two rows"}, Wrong{"", 0, "two rows"}}) {
        CAPTURE(std::string(wrong.text));
        const auto read = read_emissivity(wrong.text);
        REQUIRE(!read);
        CHECK(read.error().line == wrong.line);
        CHECK(read.error().what.find(wrong.says) != std::string::npos);
    }
}

// The transfer integral over the observer's image by the reference's rays, of light that fades towards both rims.
struct LampImage {
    SpacetimeSpec spec;
    double inclination_deg, inner, outer, height;
    int radii, angles;
};
constexpr std::size_t kLampParts = 10;
constexpr double kLeastLampG = 0.05, kMostLampG = 1.55;

double lamp_fade(const LampImage& of, double r) {
    const double at = std::log(r / of.inner) / std::log(of.outer / of.inner);
    return at > 0 && at < 1 ? std::pow(std::sin(M_PI * at), 4) : 0.0;
}

std::array<double, kLampParts + 1> transfer_integral(const LampImage& of) {
    constexpr double kFar = 1e6;  // r_s
    const auto metric = std::move(*reference::make_metric(of.spec));
    DiscSpec disc;
    disc.inner = of.inner, disc.outer = of.outer, disc.emission = DiscEmission::kThermal;
    disc.emissivity.by = Emissivity::kLamp, disc.emissivity.lamp.height = of.height;
    const reference::DiscLight matter(*metric, disc, {});
    Scene scene;
    scene.spacetime = of.spec;
    std::array<double, kLampParts + 1> parts{};
    const double low = std::log(0.05 * of.inner), high = std::log(of.outer + 2), step = (high - low) / of.radii;
    for (int i = 0; i < of.radii; ++i)
        for (int j = 0; j < of.angles; ++j) {
            const double rho = std::exp(low + (i + 0.5) * step), chi = 2 * M_PI * (j + 0.5) / of.angles;
            RayQuery query;
            query.r = kFar, query.theta = of.inclination_deg * M_PI / 180;
            query.n = {-1, -rho * std::sin(chi) / kFar, rho * std::cos(chi) / kFar};
            const auto ray = reference::trace_ray(scene, query, 1, &matter);
            if (!ray || ray->crossings.empty() || !(lamp_fade(of, ray->crossings[0].r) > 0)) continue;
            const double r = ray->crossings[0].r, g = ray->crossings[0].g * std::sqrt(1 - 1 / kFar);
            const double photons =
                g * g * g * matter.heat(r) * lamp_fade(of, r) * rho * rho * step * 2 * M_PI / of.angles;
            parts[kLampParts] += photons;
            parts[static_cast<std::size_t>((g - kLeastLampG) / (kMostLampG - kLeastLampG) * kLampParts)] += photons;
        }
    return parts;
}

TEST_CASE("disc emissivity: the line of a disc that a lamp lights is the reference's transfer integral") {
    constexpr double kShare = 0.005;
    for (const LampImage& of : {LampImage{{"schwarzschild", {}}, 60, 3, 20, 4, 400, 400},
                                LampImage{{"kerr", MetricParameters{{"spin", 0.9}}}, 40, 0.85, 6, 1.5, 64, 96}}) {
        CAPTURE(of.spec.metric);
        const auto spacetime = *make_spacetime(of.spec.metric, of.spec.parameters);
        const auto light = DistantLight::make(spacetime, of.inclination_deg * M_PI / 180);
        REQUIRE(light);
        EmissivitySpec lamp;
        lamp.by = Emissivity::kLamp, lamp.lamp.height = of.height;
        const DiscLine line{of.inner, of.outer, [&](const std::vector<double>& radii) {
                                std::vector<double> values = disc_emissivity(*spacetime, radii, lamp, Sense::kEastward);
                                for (std::size_t i = 0; i < radii.size(); ++i) values[i] *= lamp_fade(of, radii[i]);
                                return values;
                            }};
        const LineProfile profile = line_profile(*light, line, {kLampParts, kLeastLampG, kMostLampG}, LineCells(1));
        const auto exact = transfer_integral(of);
        double worst = 0;
        for (std::size_t n = 0; n < kLampParts; ++n) {
            worst = std::max(worst, std::fabs(profile.share(n) - exact[n] / exact[kLampParts]));
            CHECK(std::fabs(profile.share(n) - exact[n] / exact[kLampParts]) < kShare);
        }
        MESSAGE(fmt::format("line of a lamp, {}: shares of its bins {:.1e} apart", of.spec.metric, worst));
    }
}

TEST_CASE("disc emissivity: a line of two powers has its break in its cells") {
    const auto spacetime = *make_spacetime("kerr", MetricParameters{{"spin", 0.9}});
    const auto light = DistantLight::make(spacetime, 0.7);
    REQUIRE(light);
    EmissivitySpec spec;
    spec.by = Emissivity::kPowerLaw, spec.powers = {7, 2, 2}, spec.breaks = {3};
    const auto line_of = [&](double inner, double outer) {
        DiscLine line{inner, outer, [&](const std::vector<double>& radii) {
                          return disc_emissivity(*spacetime, radii, spec, Sense::kEastward);
                      }};
        line.kinks = spec.breaks;
        return line_profile(*light, line, {50, 0.2, 1.3}, LineCells(0));
    };
    const LineProfile whole = line_of(1.2, 30), within = line_of(1.2, 3), beyond = line_of(3, 30);
    CHECK(std::fabs((within.all_photons + beyond.all_photons) / whole.all_photons - 1) < 1e-12);
    for (std::size_t i = 0; i < 50; ++i)
        CHECK(std::fabs(within.photons[i] + beyond.photons[i] - whole.photons[i]) < 1e-10 * whole.all_photons);
}

}  // namespace
