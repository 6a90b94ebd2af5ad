// Images of the disc of high order by the limit of many windings and its next term, against the reference's isoradials seen from above,
// which are circles.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "reference/isoradial.h"
#include "reference/photon_ring.h"
#include "support/metrics.h"
#include "table/critical_images.h"

namespace {

using namespace nullscope;

constexpr double kCameraR = 60.0;

Scene from_above(const std::string& metric, const MetricParameters& parameters) {
    Scene scene;
    scene.spacetime = {metric, parameters};
    scene.camera.r = kCameraR, scene.camera.theta = 0.0;
    scene.camera.plane_width = 0.6, scene.camera.focal_distance = 1;
    scene.camera.width = 800, scene.camera.height = 600;
    scene.disc.emplace();
    return scene;
}

double bent(double c, const CriticalImages::Bend& bend, double per_angle, double phi) {
    const double x = c * std::exp(-phi * per_angle), size = std::fabs(x);
    return x * (1 + size * (bend.constant + bend.logarithm * std::log2(size)));
}

TEST_CASE("critical images: rims of rings of order 2 and 3") {
    // Of the angle from the critical direction. Order 2 lies at up to 0.03 of the critical angle: without the next term it is off by 2 %.
    constexpr double kOff[] = {1e-3, 1e-4}, kOffInLimit = 0.01;
    double most = 0, most_in_limit = 0;
    for (const auto& [metric, parameters] :
         {std::pair{"schwarzschild", MetricParameters{}}, {"reissner-nordstrom", MetricParameters{{"charge", 0.8}}}}) {
        const Scene scene = from_above(metric, parameters);
        const std::shared_ptr<const SphericalMetric> spacetime = test::spherical(metric, parameters);
        const auto table = std::make_shared<const DeflectionTable>(*spacetime);
        const RayFamily family(spacetime, table, kCameraR, frame_at_rest(spacetime->lapse_squared(kCameraR)));
        const std::string name(metric);  // clang 14 captures no structured binding
        for (const double r : {2.6, 5.0, 15.0}) {
            const CriticalImages images = critical_images(family, r, r);
            for (const int order : {2, 3}) {
                const auto curve = reference::isoradial(scene, r, order + 1, 8);
                REQUIRE(curve);
                REQUIRE(!curve->empty());
                const double radius = std::hypot(curve->front()[0] - 400, curve->front()[1] - 300),
                             exact = std::atan(radius * scene.camera.pixel()) - family.critical_angle(),
                             phi = M_PI * (0.5 + order);
                const double off = bent(images.outer, images.outer_bend, images.per_angle, phi) / exact - 1,
                             in_limit = images.outer * std::exp(-phi * images.per_angle) / exact - 1;
                CAPTURE(name);
                CAPTURE(r);
                CAPTURE(order);
                CHECK(std::abs(off) <= kOff[order - 2]);
                most = std::max(most, std::abs(off)), most_in_limit = std::max(most_in_limit, std::abs(in_limit));
            }
        }
    }
    CHECK(most_in_limit > kOffInLimit);
    fmt::print("critical images: rims off by {:.1e} at most, by {:.1e} without the next term\n", most, most_in_limit);
}

// A ring's ratio tends to exp(-pi) by delta ln(delta): it is there to 1e-9 from the tenth crossing on, down to what is left of a double; and
// less that from the seventh on.
TEST_CASE("critical images: successive rings are exp(-pi) as wide, without the limit") {
    const auto spacetime = test::spherical("schwarzschild");
    const RayFamily family(spacetime, std::make_shared<const DeflectionTable>(*spacetime), kCameraR,
                           frame_at_rest(spacetime->lapse_squared(kCameraR)));
    constexpr double kSame = 1e-9;
    std::array<double, 4> log_width{};  // of the last rings
    int within = 0, limit_within = 0;
    for (int n = 3; n <= 200; ++n) {
        const double phi = M_PI * (n - 0.5), outer = delta_of_image(family, 10.0, phi),
                     width = outer - delta_of_image(family, 3.0, phi),
                     before = outer * std::exp(M_PI) / family.critical_angle();
        std::shift_left(log_width.begin(), log_width.end(), 1);
        log_width[3] = std::log(width);
        const auto narrower = [&](std::size_t i) { return std::expm1(log_width[i] - log_width[i - 1] + M_PI); };
        CAPTURE(n);
        CHECK(std::fabs(swept_to(family, Segment::kSky, outer, 10.0) - phi) <= 1e-11);
        const double inside = delta_of_image(family, 1.2, phi);
        CHECK(inside < 0);
        CHECK(std::fabs(swept_to(family, Segment::kCaptured, -inside, 1.2) - phi) <= 1e-11);
        if (n > 3) CHECK(std::fabs(narrower(3)) <= 2 * before * -std::log(before) + kSame);
        if (n < 6) continue;
        const double limit = reference::limit_of(narrower(1), narrower(2), narrower(3), std::exp(-M_PI));
        if (within == 0 && std::fabs(narrower(3)) <= kSame) within = n;
        if (limit_within == 0 && std::fabs(limit) <= kSame) limit_within = n;
        if (n >= 10) CHECK(std::fabs(narrower(3)) <= kSame);
        if (n >= 7) CHECK(std::fabs(limit) <= kSame);
    }
    fmt::print(
        "critical images: rings exp(-pi) as wide as the ones before to 1e-9 from crossing {} on, less delta ln(delta) "
        "from {} on\n",
        within, limit_within);
}

// Rings are drawn by the limit and its next term as far as that tells a pixel's place: shaders/planar/disc_thin.glsl counts on this error.
TEST_CASE("critical images: the error grows with the square of the angle from the critical direction") {
    constexpr double kOff = 2.0, kOffWithin = 3.7,
                     kRounding = 1e-4;  // of (delta / critical angle)^2: beyond the photon sphere, and within
    double most = 0, most_within = 0;
    for (const double camera : {4.0, 11.0, 60.0, 1e4})
        for (const auto& [metric, charge] : {std::pair{"schwarzschild", 0.0}, {"reissner-nordstrom", 0.8}}) {
            const auto spacetime =
                charge > 0 ? test::spherical(metric, MetricParameters{{"charge", charge}}) : test::spherical(metric);
            const RayFamily family(spacetime, std::make_shared<const DeflectionTable>(*spacetime), camera,
                                   frame_at_rest(spacetime->lapse_squared(camera)));
            for (const double r : {1.3, 2.6, 3.2, 7.0, 30.0}) {
                const CriticalImages images = critical_images(family, r, r);
                double& worst = images.outer > 0 ? most : most_within;
                for (const double part : {0.03, 0.06, 0.1, 0.15, 0.2, 0.3}) {
                    const double delta = part * family.critical_angle();
                    const double phi =
                        swept_to(family, images.outer > 0 ? Segment::kSky : Segment::kCaptured, delta, r);
                    if (!(phi > images.from_angle)) continue;  // not met there, or not past the disc
                    const double drawn = std::fabs(bent(images.outer, images.outer_bend, images.per_angle, phi));
                    worst = std::max(worst, (std::fabs(drawn / delta - 1) - kRounding) / (part * part));
                }
            }
        }
    fmt::print("critical images: off by {:.2f} (delta / critical angle)^2 of delta, {:.2f} within the photon sphere\n",
               most, most_within);
    CHECK(most <= kOff);
    CHECK(most_within <= kOffWithin);
}

}  // namespace
