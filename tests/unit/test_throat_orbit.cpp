// Columns of the orbit table through wormholes against the reference's orbits, which are closed forms and quadratures in l.
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include <doctest/doctest.h>

#include "reference/orbit.h"
#include "spacetime/radial_frame.h"
#include "support/depth.h"
#include "support/metrics.h"
#include "table/throat_orbit.h"

namespace {

using namespace nullscope;

struct ThroatOrbitWorld {
    std::shared_ptr<const SphericalMetric> spacetime;
    std::shared_ptr<const DeflectionTable> table;
    std::shared_ptr<reference::Metric> reference;
};
ThroatOrbitWorld throat_world(const std::string& metric, const std::map<std::string, double>& parameters) {
    ThroatOrbitWorld world;
    world.spacetime = test::spherical(metric, parameters);
    world.table = std::make_shared<const DeflectionTable>(*world.spacetime);
    world.reference = std::move(*reference::make_metric({metric, parameters}));
    return world;
}
std::vector<ThroatOrbitWorld> worlds() {
    std::vector<ThroatOrbitWorld> all{throat_world("ellis", {}), throat_world("ellis", {{"throat", 3.0}})};
    for (const auto& [length, width] : {std::pair{0.01, 0.05}, {0.0, 0.02}, {0.5, 0.3}, {0.5, 2.0}})
        all.push_back(throat_world("dneg-wormhole", {{"throat", 1.0}, {"length", length}, {"lensing_width", width}}));
    return all;
}
RayFamily fan_at(const ThroatOrbitWorld& world, double r) {
    return {world.spacetime, world.table, r, frame_at_rest(1.0)};
}

constexpr double kNearest = 1e-4;    // rad from the critical ray: a tenth of a pixel of 60 degrees on 1080 rows
constexpr double kMostSwept = 30.0;  // rad; rays that wind more often in a tube lie in a line thinner than that
constexpr double kThroatRadii[] = {20.0, 3.0, 0.4, 0.0, -0.003, -2.0, -50.0};

// Largest difference of l on the rows, over the distance from the throat (1 at least) and over how far l moves with the last digits of the
// view direction and of the swept angle: 1 for both together.
double worst_place(const ThroatOrbitWorld& world, double r) {
    const RayFamily family = fan_at(world, r);
    const ThroatShape shape(*world.spacetime);
    double worst = 0.0;
    for (const Segment segment : {Segment::kSky, Segment::kCaptured})
        for (double delta = kNearest; delta < 0.999 * family.delta_limit(segment); delta *= 1.7) {
            const FanRay ray = family.ray(segment, delta);
            if (ray.phi_end > kMostSwept) continue;
            const auto orbit = world.reference->orbits()->from_static({r, -std::cos(ray.beta), ray.sin_beta});
            const OrbitTexels column = throat_column(family, segment, delta);
            const double end = segment == Segment::kSky ? 1.0 : -1.0;
            for (int i = 1; i < family.orbit_rows(); ++i) {
                const double v = static_cast<double>(i) / family.orbit_rows(), w = column[i][0] * (1.0 - v);
                const double l = end * shape.throat() * shape.length(w), exact = orbit->zeta_at(v * orbit->angle());
                const double slope = shape.throat() * shape.length_slope(w);
                const double moved = std::fabs(slope * (1.0 - v)) *
                                     (std::fabs(column[i][1]) * delta + std::fabs(column[i][2]) * family.orbit_rows());
                worst = std::fmax(worst, std::fabs(l - exact) / (shape.throat() + std::fabs(exact) + moved));
            }
        }
    return worst;
}

TEST_CASE("orbit table through a throat: l is the reference's on every row") {
    constexpr double kPlace = 1e-6;  // measured 3.5e-7; Ellis' 1e-9
    test::Selection selection(3);
    for (const ThroatOrbitWorld& world : worlds())
        for (const double r : kThroatRadii) {
            if (!selection.takes_next()) continue;
            const double worst = worst_place(world, r * world.spacetime->length_unit());
            MESSAGE(world.spacetime->name() << " r = " << r << ": " << worst);
            CHECK(worst < kPlace);
        }
}

// A step may go over both rims of a short tube, and where it begins may hang on a last digit.
TEST_CASE("orbit table through a throat: of cameras a last digit apart it is the same") {
    constexpr double kApart = 1e-7;  // of the largest; 3.4e-5 where a step went over both rims unseen
    const ThroatOrbitWorld world =
        throat_world("dneg-wormhole", {{"throat", 1.0}, {"length", 0.01}, {"lensing_width", 0.05}});
    std::vector<double> first;
    double r = 8.187228376212072, worst = 0.0, largest = 0.0;
    for (int i = 0; i < 11; ++i, r = std::nextafter(r, 10.0)) {
        const RayFamily family = fan_at(world, r);
        std::size_t place = 0;
        for (const Segment segment : {Segment::kSky, Segment::kCaptured})
            for (double delta = kNearest; delta < 0.999 * family.delta_limit(segment); delta *= 1.3)
                for (const auto& texel : throat_column(family, segment, delta))
                    for (const double number : {texel[0], texel[1] * delta, texel[2], texel[3] * delta}) {
                        if (i == 0) first.push_back(number);
                        largest = std::fmax(largest, std::fabs(number));
                        worst = std::fmax(worst, std::fabs(number - first[place++]));
                    }
    }
    MESSAGE("apart by " << worst / largest);
    CHECK(worst < kApart * largest);
}

TEST_CASE("orbit table through a throat: rays next to the critical one stay between the skies") {
    // Of a camera that magnifies: so close steps of double precision do not say on which side a ray comes out.
    constexpr double kOfW = 1e-3;  // rad, that a row may lie beyond a sky
    std::vector<ThroatOrbitWorld> all = worlds();
    all.push_back(throat_world("dneg-wormhole", {{"throat", 75.0}, {"length", 0.01}, {"lensing_width", 1.37}}));
    for (const ThroatOrbitWorld& world : all)
        for (const double r : {3.0, 0.24, -2.0})
            for (const Segment segment : {Segment::kSky, Segment::kCaptured})
                for (const double delta : {1e-17, 1.8e-15, 3e-14, 1e-12, 1e-9}) {
                    const RayFamily family = fan_at(world, r * world.spacetime->length_unit());
                    if (delta > 0.999 * family.delta_limit(segment)) continue;
                    const OrbitTexels column = throat_column(family, segment, delta);
                    double least = 1.0, most = 0.0;
                    for (int i = 0; i < family.orbit_rows(); ++i) {
                        const double w = column[i][0] * (1.0 - static_cast<double>(i) / family.orbit_rows());
                        least = std::fmin(least, w), most = std::fmax(most, w);
                    }
                    CAPTURE(world.spacetime->name());
                    CAPTURE(r);
                    CAPTURE(delta);
                    CAPTURE(segment == Segment::kSky);
                    CHECK(least >= -kOfW);
                    CHECK(most <= M_PI + kOfW);
                }
}

}  // namespace
