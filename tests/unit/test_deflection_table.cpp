// The deflection table and what is cut from it: strip and orbit table, against the 50-digit vectors and against each other.
#include <doctest/doctest.h>

#include <cmath>
#include <ctime>
#include <memory>

#include "reference/orbit.h"
#include "shadercore/core64.h"
#include "spacetime/registry.h"
#include "support/folders.h"
#include "support/metrics.h"
#include "table/deflection_table.h"
#include "table/density_fit.h"
#include "table/orbit_table.h"
#include "table/strip.h"
#include "vector_file.h"

using namespace nullscope;

namespace {

// Interpolation error of the remainder at the default size, for every row of the vectors, near-critical ones included.
constexpr double kTableError = 2e-9;
// The bound for the default table on two cores; measured 7 ms on a quiet machine, so a busy one passes too.
constexpr double kBuildMs = 100.0;
// Lines over cells of at most pi/1024 rad, where the sky turns by 1 to 1.5 rad per rad: (pi/1024)^2/16 x 1.5^2 < 1.4e-6 in the
// last cells before the radial ray, half of it on the mean, and float rounding.
constexpr double kStripError = 1e-6;
constexpr double kRoundTrip = 1e-15;  // a few roundings

std::shared_ptr<const SphericalMetric> schwarzschild() { return test::spherical("schwarzschild"); }

std::shared_ptr<const DeflectionTable> table() {
    static const auto shared = std::make_shared<const DeflectionTable>(*schwarzschild());
    return shared;
}

}  // namespace

TEST_CASE("table mapping: forward and inverse are each other's") {
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        CHECK(std::fabs(core64::turning_x_from_one_minus_k(core64::turning_one_minus_k_from_x(x)) - x) <= kRoundTrip);
        CHECK(std::fabs(core64::table_y_from_angle(core64::table_angle_from_y(x)) - x) <= kRoundTrip);
        if (i < 1000)
            CHECK(std::fabs(core64::through_x_from_k_minus_one(core64::through_k_minus_one_from_x(x)) - x) <=
                  kRoundTrip);
    }
}

TEST_CASE("deflection table: swept angle of every escaping vector") {
    const auto spacetime = schwarzschild();
    const double q_crit = spacetime->photon_sphere()->q_crit;
    double worst = 0.0;
    int rows = 0;
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/schwarzschild.csv")) {
        const double zeta0 = number(row, "zeta0"), delta = number(row, "delta");  // delta = q/q_crit - 1 to all digits
        if (number(row, "status") != 0 || zeta0 >= 1.0) continue;
        const double k = number(row, "q") / q_crit, one_minus_k2 = -delta * (2.0 + delta);
        const double chi = spacetime->chi()->chi_from_radius(1.0 / zeta0);
        double phi = 0.0;
        if (delta < 0.0) {
            const double sine = std::fmin(1.0, std::sin(chi) / k);
            // At the turning point itself the angle follows from 1 - sin^2 only to half the digits: left to the hard cases.
            if (row.at("group") == "camera_at_turning_point") continue;
            const double acute = std::asin(sine);
            phi = table()->turning_to_sky(k, one_minus_k2, number(row, "s") > 0 ? M_PI - acute : acute);
        } else {
            phi = table()->through_from_infinity(k, -one_minus_k2, chi);
        }
        const double condition = 1.0 + std::fabs(number(row, "dphi_dq") * number(row, "q"));
        const double exact = number(row, "phi");
        worst = std::fmax(worst, std::fabs(phi - exact) / std::fmax(1.0, 1e-6 * condition));
        ++rows;
    }
    MESSAGE("rows " << rows << ", worst error " << worst << " rad");
    CHECK(rows > 90);
    CHECK(worst < kTableError);
}

// Processor time, ms, of all threads: what the promise of kBuildMs on two free cores costs, whatever else the machine does.
template <class Work>
double processor_ms(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST_CASE("deflection table: of every metric built within the time that is promised") {
    for (const MetricEntry& entry : metric_registry()) {
        const auto spacetime = test::spherical(std::string(entry.key));
        if (spacetime == nullptr || spacetime->chi() == nullptr) continue;
        double best = 1e9;  // of a few tries: the first meets cold caches
        for (int i = 0; i < 5 && !(best < 2 * kBuildMs); ++i)
            best = std::fmin(best, processor_ms([&] {
                                 const auto made = test::spherical(std::string(entry.key));
                                 const DeflectionTable built(*made);
                             }));
        MESSAGE(std::string(entry.key) << ": metric and table " << best << " ms of processor time");
        CHECK(best < 2 * kBuildMs);
    }
}

TEST_CASE("ray family: continuous through k = 1 and through the photon sphere") {
    // Outgoing rays from outside pass k = 1 without anything happening: the two branches must meet.
    for (const double r : {1.6, 2.0, 5.0, 50.0, 1e4}) {
        const RayFamily family(schwarzschild(), table(), r, frame_at_rest(schwarzschild()->lapse_squared(r)));
        const double delta = M_PI - 2.0 * family.critical_angle();  // beta = pi - chi0: k = 1 on the way out
        const double before = family.ray(Segment::kSky, delta * (1 - 1e-13)).phi_end;
        const double after = family.ray(Segment::kSky, delta * (1 + 1e-13)).phi_end;
        CHECK(std::fabs(before - after) < 2 * kTableError);
    }
}

TEST_CASE("density fit: h of every metric to 1e-12, also next to both ends") {
    constexpr double kFitError = 1e-12;  // degree 11 on panels of 1/64 of pi
    // Next to a horizon a metric's own h has the last bit of zeta, over its distance from there.
    constexpr double kOwnDigits = 1e-14;
    for (const MetricEntry& entry : metric_registry()) {
        std::vector<std::map<std::string, double>> sets{{}};
        for (const MetricParameter& p : entry.parameters)
            for (const double value : {p.low, p.high, 0.7 * p.low + 0.3 * p.high})
                sets.push_back({{std::string(p.name), value}});
        if (entry.key == "reissner-nordstrom") sets.push_back({{"charge", 0.999}}), sets.push_back({{"charge", 1.0}});
        for (const auto& parameters : sets) {
            const auto made = make_spacetime(std::string(entry.key), parameters);
            if (!made) continue;  // parameters that do not go together
            const auto spacetime = test::spherical(*made);
            if (spacetime == nullptr || spacetime->chi() == nullptr) continue;
            const DensityFit fit(*spacetime);
            double worst = 0.0, where = 0.0;  // worst: over its bound
            const auto check = [&](double chi) {
                const double exact = spacetime->chi()->bending_density(chi);
                const double bound =
                    kFitError * std::fmax(exact, 1.0) + (spacetime->horizon_radius() ? kOwnDigits / (M_PI - chi) : 0.0);
                const double error = std::fabs(fit(chi) - exact) / bound;
                if (!(error <= worst)) worst = error, where = chi;
            };
            for (int i = 0; i < 4000; ++i) check(M_PI * i / 4000.0);
            for (double off = 1e-14; off < 0.1; off *= 1.3) check(off), check(M_PI - off), check(M_PI / 2 + off);
            CAPTURE(entry.key);
            CAPTURE(where);
            const double value = parameters.empty() ? 0.0 : parameters.begin()->second;
            CAPTURE(value);
            CHECK(worst < 1.0);
        }
    }
}

constexpr RadialFrame kAtRest{1.0, 1.0};  // in wormholes without gravity

// Largest step of the swept angle over what one of l makes, for a camera that passes l = middle in steps of 1e-7.
// tan(angle) up to steepest: outside of a tube V changes, and what is swept in the tube changes by the cube of the tangent.
double step_of_sweep(const std::string& metric, const std::map<std::string, double>& parameters, double middle,
                     double steepest = 1e9) {
    constexpr double kStep = 1e-7;
    const auto spacetime = test::spherical(metric, parameters);
    const auto made = std::make_shared<const DeflectionTable>(*spacetime);
    double worst = 0.0;
    for (const double angle :
         {0.2, 0.9, 1.5, 1.57, 1.5708, 1.6, 2.2, 3.0}) {  // from the direction of growing l, tilted off the rim
        double before = 0.0;
        if (std::fabs(std::tan(angle)) > steepest) continue;
        for (int i = -3; i <= 3; ++i) {
            const RayFamily family(spacetime, made, middle + i * kStep, kAtRest);
            const double critical = std::acos(family.critical_cosine());
            const bool sky = angle < critical;
            const double phi =
                family.ray(sky ? Segment::kSky : Segment::kCaptured, std::fabs(angle - critical)).phi_end;
            CHECK(sky == (angle < M_PI / 2));
            // d phi/d l at the throat = -V^(1/2)/sqrt(k^2 - 1) = -1/|cot(angle)|: steep only next to the rim itself.
            const double steep = 1.0 + std::fabs(std::tan(angle));
            if (i > -3) worst = std::fmax(worst, std::fabs(phi - before) / (kStep * steep));
            before = phi;
        }
    }
    return worst;
}

TEST_CASE(
    "ray family: nothing happens to rays as a camera passes the throat of a wormhole, or the mouths of its tube") {
    const std::map<std::string, double> tube{{"length", 1.0}};
    for (const double worst :
         {step_of_sweep("ellis", {}, 0.0), step_of_sweep("ellis", {{"throat", 1.5}}, 0.0),
          step_of_sweep("dneg-wormhole", {{"length", 0.0}}, 0.0), step_of_sweep("dneg-wormhole", tube, 0.0),
          step_of_sweep("dneg-wormhole", tube, 0.5, 1e3), step_of_sweep("dneg-wormhole", tube, -0.5, 1e3)}) {
        MESSAGE("largest step over what one of l makes: " << worst);
        CHECK(worst < 1.5);
    }
}

// Weak deflection where R = l + ln l: what polynomials on even nodes miss by 7e-5 rad.
TEST_CASE("ray family: wormholes of every width as seen from afar, against the reference") {
    constexpr double kGradedError = 2e-9;  // rad; measured 7e-10 for the widest
    for (const double width : {0.05, 0.5, 2.0})
        for (const double r : {5.0, 50.0, 1000.0, 1e7}) {
            const std::map<std::string, double> parameters{{"length", 0.5}, {"lensing_width", width}};
            const auto spacetime = test::spherical("dneg-wormhole", parameters);
            const RayFamily family(spacetime, std::make_shared<const DeflectionTable>(*spacetime), r, kAtRest);
            const auto metric = reference::make_metric({"dneg-wormhole", parameters});
            REQUIRE(metric);
            double worst = 0.0;
            for (double delta = 0.1 * family.critical_angle(); delta < family.delta_limit(Segment::kSky);
                 delta *= 1.03) {
                const FanRay ray = family.ray(Segment::kSky, delta);
                worst = std::fmax(
                    worst,
                    std::fabs(ray.phi_end -
                              (*metric)->orbits()->from_static({r, -std::cos(ray.beta), ray.sin_beta})->angle()));
            }
            MESSAGE("width " << width << ", r = " << r << ": " << worst << " rad");
            CHECK(worst < kGradedError);
        }
}

TEST_CASE("strip: lines reproduce the family") {
    for (const double r : {1.0001, 1.1, 1.5, 2.0, 5.0, 20.0, 1000.0, 1e6}) {
        const RayFamily family(schwarzschild(), table(), r, frame_at_rest(schwarzschild()->lapse_squared(r)));
        const TexelGrid strip = build_strip(family).sky;
        double worst = 0.0;
        for (double delta = family.w0() * 0.7; delta < family.delta_limit(Segment::kSky); delta *= 1.0037) {
            const double u = 1.0 + 2.0 * std::tan(0.5 * delta) / family.w0();
            const int octave = std::ilogb(u);
            const double position = (std::ldexp(u, -octave) - 1.0) * 1024.0;
            const float* line = strip.texels.data() +
                                4 * (static_cast<std::size_t>(octave) * 1024 + static_cast<std::size_t>(position));
            const double f = position - std::floor(position);
            const FanRay ray = family.ray(Segment::kSky, delta);
            worst = std::fmax(worst, std::fabs(line[0] + f * line[1] - std::cos(ray.phi_end)));
            worst = std::fmax(worst, std::fabs((line[2] + f * line[3]) * ray.sin_beta - std::sin(ray.phi_end)));
        }
        MESSAGE("r = " << r << ": worst of cos and sin phi " << worst);
        CHECK(worst < kStripError);
    }
}

TEST_CASE("strip and orbit table: finite everywhere") {
    for (const double r : {1.0 + 1e-9, 1.0001, 1.1, 1.4999999, 1.5, 1.5000001, 3.0, 1e3, 1e9}) {
        const RayFamily family(schwarzschild(), table(), r, frame_at_rest(schwarzschild()->lapse_squared(r)));
        int bad = 0;
        const Strip strip = build_strip(family);
        for (const float v : strip.sky.texels) bad += !std::isfinite(v);
        for (const float v : strip.ends.texels) bad += !std::isfinite(v);
        for (const float v : build_orbit_table(family, false).places.texels) bad += !std::isfinite(v);
        CHECK_MESSAGE(bad == 0, "r = ", r);
    }
}
