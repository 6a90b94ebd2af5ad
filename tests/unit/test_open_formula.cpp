// Metrics by formula that are no holes in space that is flat far out: each ray's quadrature against the reference's steps.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "reference/orbit.h"
#include "spacetime/photon_shell.h"
#include "spacetime/potential_survey.h"
#include "support/depth.h"
#include "support/metrics.h"
#include "table/ray_family.h"

namespace {

using namespace nullscope;

struct Open {
    std::string name;
    std::map<std::string, std::string> formulas;
    double near;  // a camera next to where rays part
    double least_part =
        0.0;  // of the angle to that, of rays that the reference can follow: nearer ones come to r - 2.5 = 1e-30
};

const std::vector<Open>& open_worlds() {
    const std::string shape = "1 + 0.25/r", length = "sqrt(r^2 + 1)";
    static const std::vector<Open> worlds = {
        {"naked charge", {{"A", "1 - 1/r + 0.3/r^2"}}, 0.3},
        {"charge with a photon sphere", {{"A", "1 - 1/r + 0.26/r^2"}}, 1.1},
        {"regular centre", {{"A", "1 - r^2/(r^2 + 0.45^2)^1.5"}}, 0.1},
        {"two photon spheres", {{"A", "1 - 1/r + 0.26/r^2 - 0.0005/r^6"}}, 1.1},
        {"extremal", {{"A", "(1 - 0.5/r)^2"}}, 1.1},
        {"isotropic",
         {{"A", "((1 - 0.25/r)/(" + shape + "))^2"}, {"B", "(" + shape + ")^4"}, {"R", "r*(" + shape + ")^2"}},
         1.1},
        {"proper length", {{"A", "1"}, {"B", "1"}, {"R", length}}, 0.2},
        {"throat", {{"A", "1"}, {"B", "1/(1 - 1/r^2)"}}, 1.1},
        {"acceleration", {{"A", "1 - 1/r + 0.01*r"}}, 1.7},
        {"quintessence", {{"A", "1 - 1/r - 0.01*r"}}, 1.7},
        {"logarithm", {{"A", "1 - 1/r + 0.1/r*log(r/0.1)"}}, 1.6},
        {"singular surface",
         {{"A", "(1 - 2.5/r)^0.4"}, {"B", "(1 - 2.5/r)^(-0.4)"}, {"R", "r*(1 - 2.5/r)^0.3"}},
         2.8,
         0.1},
    };
    return worlds;
}

MetricParameters parameters_of(const Open& open) {
    MetricParameters parameters;
    parameters.formulas = open.formulas;
    return parameters;
}

std::shared_ptr<const SphericalMetric> made(const Open& open) {
    const auto spacetime = make_spacetime("formula", parameters_of(open));
    REQUIRE_MESSAGE(spacetime, spacetime.error().message());
    return test::spherical(*spacetime);
}

TEST_CASE("open formula: swept angles are the reference's, next to the dividing ray and far from it") {
    constexpr double kSwept = 2e-10;  // rad, and of the angle: what a ray sweeps grows as it nears the dividing one
    const int each = test::by_depth(4, 1, 1);
    int number = 0;
    for (const Open& open : open_worlds()) {
        CAPTURE(open.name);
        const auto spacetime = made(open);
        REQUIRE(spacetime->potential() != nullptr);
        const auto reference = reference::make_metric({"formula", parameters_of(open)});
        REQUIRE(reference);
        double worst = 0.0;
        for (const double r : {open.near, 15.0, 60.0}) {
            CAPTURE(r);
            const nullscope::RayFamily family(spacetime, nullptr, r, frame_at_rest(spacetime->lapse_squared(r)));
            for (const Segment segment : {Segment::kSky, Segment::kCaptured}) {
                const double limit = family.delta_limit(segment);
                for (const double part : {1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.5, 0.8, 0.999}) {
                    if (!(limit > 0.0) || part < open.least_part || number++ % each != 0) continue;
                    CAPTURE(part);
                    const FanRay ray = family.ray(segment, part * limit);
                    const auto orbit = (*reference)->orbits()->from_static({r, -std::cos(ray.beta), ray.sin_beta});
                    const bool back = segment == Segment::kSky || spacetime->inner_end() == InnerEnd::kSameSky;
                    CHECK(orbit->fate() == (back ? Fate::kEscaped : Fate::kCaptured));
                    if (!back) continue;
                    // The angle beta is a double: what it tells the reference is off by a rounding.
                    const double known = 4e-16 / (part * limit);
                    const double off = std::fabs(ray.phi_end - orbit->angle()) / (1.0 + orbit->angle()) - known;
                    CHECK_MESSAGE(off < kSwept, ray.phi_end << " " << orbit->angle());
                    worst = std::fmax(worst, off);
                }
            }
        }
        MESSAGE(open.name << ": " << worst);
    }
}

TEST_CASE("open formula: what winds about a photon sphere does so by its closed form") {
    const auto isotropic = made(open_worlds()[5]);
    const auto orbit = photon_orbit(*isotropic, M_PI / 2, 0.0);
    REQUIRE_MESSAGE(orbit, orbit.error().message());
    CHECK(orbit->r == doctest::Approx((2.0 + std::sqrt(3.0)) / 4.0).epsilon(1e-12));
    CHECK(orbit->gamma == doctest::Approx(M_PI).epsilon(1e-9));  // of Schwarzschild's, a = 1
    CHECK(isotropic->photon_sphere()->q_crit == doctest::Approx(2.0 / std::sqrt(27.0)).epsilon(1e-13));
    const auto extremal = made(open_worlds()[4]);
    CHECK(photon_orbit(*extremal, M_PI / 2, 0.0)->gamma == doctest::Approx(M_PI / std::sqrt(2.0)).epsilon(1e-9));
    CHECK_FALSE(photon_orbit(*made(open_worlds()[0]), M_PI / 2, 0.0));
}

TEST_CASE("open formula: places that are no limits of the search are told as they are") {
    const auto hole = made(open_worlds()[4]);
    CHECK(*hole->horizon_radius() == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(*made(open_worlds()[5])->horizon_radius() == doctest::Approx(0.25).epsilon(1e-12));
    CHECK_FALSE(made(open_worlds()[6])->horizon_radius());
    CHECK_FALSE(made(open_worlds()[7])->horizon_radius());
    CHECK(made(open_worlds()[9])->camera_range().high == doctest::Approx(50 + std::sqrt(2400.0)).epsilon(1e-12));
    CHECK(made(open_worlds()[0])->inner_end() == InnerEnd::kSameSky);
    CHECK(made(open_worlds()[7])->inner_end() == InnerEnd::kHorizon);
}

}  // namespace
