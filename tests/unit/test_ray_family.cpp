// The family of rays of observers that fall: outside, on and inside the horizon.
#include <cmath>
#include <memory>

#include <doctest/doctest.h>

#include "reference/orbit.h"
#include "support/metrics.h"
#include "table/ray_family.h"

namespace {

using namespace nullscope;

constexpr double kRayFamilyDegree = M_PI / 180.0;

struct RayFamilyWorld {
    std::shared_ptr<const SphericalMetric> spacetime;
    std::shared_ptr<const DeflectionTable> table;
    std::shared_ptr<reference::Metric> reference;
};
RayFamilyWorld world_of(const std::string& metric, const std::map<std::string, double>& parameters = {}) {
    RayFamilyWorld world;
    world.spacetime = test::spherical(metric, parameters);
    world.table = std::make_shared<const DeflectionTable>(*world.spacetime);
    auto orbits = reference::make_metric({metric, parameters});
    REQUIRE(orbits);
    world.reference = std::move(*orbits);
    return world;
}
RayFamily rain_fan(const RayFamilyWorld& world, double r) {
    return {world.spacetime, world.table, r, falling_frame(world.spacetime->lapse_squared(r), 1.0)};
}

TEST_CASE("ray family: the shadow of the rain observer") {
    // Half-angles about the inward direction (physics: Part B.2), r in r_s.
    const RayFamilyWorld world = world_of("schwarzschild");
    for (const auto& [r, half_angle] : {std::pair{5.0, 17.3241986566},
                                        {1.5, 35.2643896828},
                                        {1.0, 42.1034488707},
                                        {0.5, 53.2702658035},
                                        {0.05, 77.3257155812}})
        CHECK(std::fabs(std::acos(-rain_fan(world, r).critical_cosine()) / kRayFamilyDegree - half_angle) < 1e-10);
}

constexpr double kBesideRoot = 2e-7;  // rad; measured: 8e-8

// Largest error of the swept angle against the reference, over rays 1e-6 ... 1 of the way from the critical direction to the radial one;
// each over 1 + d phi/d ln(delta), about 1: what the last digit of the direction is worth.
double worst_sweep(const RayFamilyWorld& world, double r) {
    const RayFamily family = rain_fan(world, r);
    double worst = 0.0;
    for (const Segment segment : {Segment::kSky, Segment::kCaptured})
        for (double delta = 1e-6; delta < 0.999 * family.delta_limit(segment); delta *= 1.3) {
            const FanRay ray = family.ray(segment, delta);
            const auto [orbit, g] = world.reference->orbits()->from_rain({r, -std::cos(ray.beta), ray.sin_beta});
            if (!(orbit->angle() >= 0)) continue;  // no end: light from nowhere
            // Within an inner horizon, dark rays that turn next to the camera: the reference's panels are too wide for the root of
            // q^2 - V beside them. Extremal hole, r = 0.4185, q = 0.46605: exactly 7.5581563430, as the family has it, not ...2596.
            if (world.spacetime->lapse_squared(r) > 0 && r < *world.spacetime->horizon_radius() &&
                std::fabs(ray.slope) < 0.05) {
                CHECK(std::fabs(ray.phi_end - orbit->angle()) < kBesideRoot);
                continue;
            }
            CHECK((orbit->fate() == Fate::kEscaped) == (segment == Segment::kSky));
            const double slope = family.ray(segment, 1.001 * delta).phi_end - ray.phi_end;
            worst = std::fmax(worst, std::fabs(ray.phi_end - orbit->angle()) / (1.0 + 1e3 * std::fabs(slope)));
        }
    return worst;
}

TEST_CASE("ray family: swept angles of rain observers are the reference's, through the horizon") {
    constexpr double kSweep = 4e-9;  // rad; of a camera at rest 2e-9 (test_deflection_table.cpp); measured here 1.1e-9
    for (const RayFamilyWorld& world : {world_of("schwarzschild"), world_of("reissner-nordstrom", {{"charge", 0.8}}),
                                        world_of("reissner-nordstrom", {{"charge", 1.0}})}) {
        const double horizon = *world.spacetime->horizon_radius(), low = world.spacetime->falling_range().low;
        for (const double r : {50.0, 5.0, 1.5, 1.2, horizon * (1 + 1e-9), horizon, horizon * (1 - 1e-9), 0.9 * horizon,
                               0.5 * (horizon + low) + 1e-3, low + 0.05 * (horizon - low), 0.1, 0.05, 0.01}) {
            if (!(r > 1.01 * low)) continue;
            const double worst = worst_sweep(world, r);
            MESSAGE(world.spacetime->name() << " r = " << r << ": " << worst << " rad");
            CHECK(worst < kSweep);
        }
    }
}

TEST_CASE("ray family: nothing happens to rays as a camera falls through the horizon") {
    constexpr double kStep = 1e-7;
    const RayFamilyWorld world = world_of("schwarzschild");
    double before[40] = {};
    for (int i = -3; i <= 3; ++i) {
        const RayFamily family = rain_fan(world, 1.0 - i * kStep);
        for (int j = 1; j < 40; ++j) {
            const double alpha = M_PI * j / 40, critical = std::acos(family.critical_cosine());
            const double phi =
                family.ray(alpha < critical ? Segment::kSky : Segment::kCaptured, std::fabs(alpha - critical)).phi_end;
            if (i > -3) CHECK(std::fabs(phi - before[j]) < 20 * kStep);
            before[j] = phi;
        }
    }
}

// Light that turns at 1e3 r_s and more is bent by (1 + cos(beta))/b and, at the next order, by less than 2/b of that.
TEST_CASE("ray family: far from a charge without horizon light is bent as weakly as it should be") {
    constexpr double kFarSweep = 2e-11;  // rad: the panels'
    for (const double charge : {1.02, 1.2, 2.03, 3.0})
        for (const double r : {1e4, 1e6, 1e8, 1e10}) {
            const auto spacetime = test::spherical("reissner-nordstrom", {{"charge", charge}});
            const RayFamily family(spacetime, nullptr, r, frame_at_rest(spacetime->lapse_squared(r)));
            double worst = 0;
            int rays = 0;
            for (const Segment segment : {Segment::kSky, Segment::kCaptured})
                for (double delta = 1e-6; delta < family.delta_limit(segment); delta *= 1.7) {
                    const FanRay ray = family.ray(segment, delta);
                    if (!(1 / ray.q > 1e3)) continue;
                    const double weak = (1 + std::cos(ray.beta)) * ray.q;
                    worst = std::max(worst, std::fabs(ray.phi_end - (M_PI - ray.beta) - weak) - 2 * ray.q * weak);
                    ++rays;
                }
            CAPTURE(charge);
            CAPTURE(r);
            CHECK(rays > 3);
            CHECK(worst < kFarSweep);
        }
}

}  // namespace
