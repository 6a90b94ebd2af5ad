// Cameras that are let go about a rotating hole: constants of motion, parallel axes, proper times, and what Schwarzschild has of it.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observer/observer.h"
#include "observer/path.h"
#include "observer/pose.h"
#include "observer/spin_frame.h"
#include "observer/spin_worldline.h"
#include "observer/worldline.h"
#include "scenefile/scene_file.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "support/metrics.h"

namespace {

using namespace nullscope;
using test::kerr;

constexpr double kConserved = 1e-10;  // what is promised of E, L, K and u . u

CameraSpec spin_worldline_camera_at(double r, double theta, ObserverKind observer, Vec3 velocity = {}) {
    CameraSpec camera;
    camera.r = r, camera.theta = theta, camera.phi = 0.4, camera.observer = observer, camera.velocity = velocity;
    camera.yaw = 0.3, camera.pitch = -0.2, camera.roll = 0.1;
    return camera;
}

double worst_change(const SpinWorldline& line, bool planted = false) {
    const SpinWorldline::Constants first = line.constants(0);
    double worst = 0;
    for (int i = 0; i <= 200; ++i) {
        const SpinWorldline::Constants c = line.constants(line.last() * i / 200);
        worst = std::max({worst, std::fabs(c.energy - first.energy), std::fabs(c.momentum - first.momentum),
                          std::fabs(c.carter - first.carter), std::fabs(c.norm + (planted ? 1.0 - 1e-9 : 1.0))});
    }
    return worst;
}

}  // namespace

TEST_CASE("spin worldline: energy, angular momentum, Carter's constant and unit velocity stay, through the horizon") {
    for (const double spin : {0.1, 0.9, 0.998})
        for (const CameraSpec& start : {spin_worldline_camera_at(3, 1.2, ObserverKind::kZamo, {-0.1, 0.2, 0.3}),
                                        spin_worldline_camera_at(5, 0.3, ObserverKind::kStatic, {-0.3, 0.05, 0}),
                                        spin_worldline_camera_at(4, 1.1, ObserverKind::kOrbit),
                                        spin_worldline_camera_at(6, 0, ObserverKind::kRain),
                                        spin_worldline_camera_at(0.9, 1.4, ObserverKind::kThrow, {0.2, -0.4, 0.1})}) {
            const auto line = SpinWorldline::make(kerr(spin), start, 200);
            REQUIRE(line);
            const double worst = worst_change(*line);
            fmt::print("a = {:<5} from r = {:<3}: {:.4g} r_s/c, E, L, K and the norm change by {:.1e}; inside: {}\n",
                       spin, start.r, line->last(), worst, line->reaches_inner_horizon());
            CHECK(worst < kConserved);
            CHECK(worst_change(*line, true) > kConserved);  // the check can fail
        }
}

TEST_CASE("spin worldline: what falls keeps its observer: rain stays rain, a circle a circle") {
    const auto hole = kerr(0.9);
    const auto rain = SpinWorldline::make(hole, spin_worldline_camera_at(4, 1.1, ObserverKind::kRain), 100);
    REQUIRE(rain);
    CHECK(rain->reaches_inner_horizon());
    for (int i = 0; i <= 20; ++i) CHECK(length(rain->at(rain->last() * i / 20).velocity) < 1e-10);
    const double r = 3;
    const auto orbit = SpinWorldline::make(hole, spin_worldline_camera_at(r, M_PI / 2, ObserverKind::kOrbit), 60);
    REQUIRE(orbit);
    const CircularOrbit circle = *circular_orbit(*hole, r);
    CHECK(std::fabs(orbit->at(60).r - r) < 1e-9);
    CHECK(std::fabs(orbit->azimuth(60) - 60 * circle.u_t * circle.omega) < 1e-9);  // phi~ - phi stays where r does
}

// A camera that is let go from rest without angular momentum has E and Carter's K of its start. `fall` has p_theta = 0 wherever it is: the same
// geodesic in the plane of the equator, and off it by p_theta^2 = K - a^2 E^2 sin^2 - a^2 cos^2 = a^2 (1 - E^2)(cos^2 theta0 - cos^2 theta).
TEST_CASE(
    "spin worldline: from rest it is the observer `fall` in the equator's plane, elsewhere off by Carter's p_theta") {
    constexpr double kFrom = 5, kSameMotion = 1e-12;
    for (const double spin : {0.9, 0.998})
        for (const double theta : {M_PI / 2, 1.2, 0.6}) {
            const auto hole = kerr(spin);
            const auto line =
                SpinWorldline::make(hole, spin_worldline_camera_at(kFrom, theta, ObserverKind::kZamo), 200);
            REQUIRE(line);
            const double a = spin / 2, energy = line->energy();
            CHECK(std::fabs(energy - std::sqrt(zamo_lapse2(spin_place(*hole, kFrom, theta)))) < kConserved);
            for (const double part : {0.7, 0.9, 0.97, 0.99}) {  // from 4 r_s to inside the horizon
                const CameraSpec here = line->at(part * line->last());
                CameraSpec falls = here;
                falls.observer = ObserverKind::kFall, falls.fall_from = kFrom, falls.velocity = {};
                const auto u = ingoing_hat_pair(*hole, here), axes = ingoing_hat_pair(*hole, falls);
                REQUIRE(u);
                REQUIRE(axes);
                const double sigma = here.r * here.r + std::pow(a * std::cos(here.theta), 2),
                             p_theta = sigma * u->high[0][2];
                const double carter =
                    a * a * (1 - energy * energy) * (std::pow(std::cos(theta), 2) - std::pow(std::cos(here.theta), 2));
                CAPTURE(spin);
                CAPTURE(theta);
                CAPTURE(here.r);
                CHECK(std::fabs(p_theta - std::sqrt(std::fmax(carter, 0))) < 1e-9);
                double apart = 0;
                for (std::size_t mu = 0; mu < 4; ++mu)
                    apart = std::fmax(apart, std::fabs(u->high[0][mu] - axes->high[0][mu]));
                if (theta == M_PI / 2)
                    CHECK(apart < kSameMotion);
                else
                    CHECK(apart > 1e-4);
            }
        }
}

TEST_CASE("spin worldline: a camera without spin is the plane orbit's, axes and all") {
    const CameraSpec start = spin_worldline_camera_at(4, 1.1, ObserverKind::kStatic, {-0.2, 0.15, 0.25});
    const auto spun = SpinWorldline::make(kerr(1e-9), start, 12);
    const auto plane = Worldline::make(*make_spacetime("kerr", {{"spin", 0.0}}), start, 12);
    REQUIRE(spun);
    REQUIRE(plane);
    CHECK(spun->reaches_inner_horizon());
    for (int i = 0; i <= 12; ++i) {
        const double tau = 0.99 * spun->last() * i / 12;
        const CameraSpec a = spun->at(tau), b = plane->at(tau);
        CHECK(std::fabs(a.r - b.r) < 1e-8);
        CHECK(std::fabs(a.theta - b.theta) < 1e-8);
        CHECK(std::fabs(std::remainder(a.phi - b.phi, 2 * M_PI)) < 1e-8);
        CHECK(length(a.velocity - b.velocity) < 1e-8);
        CHECK(length(static_from_camera(a).a - static_from_camera(b).a) +
                  length(static_from_camera(a).c - static_from_camera(b).c) <
              1e-8);
    }
}

TEST_CASE("spin worldline: the scene that ships goes round and through the outer horizon") {
    const auto scene = load_scene("kerr-plunge");
    REQUIRE(scene);
    const auto spacetime = *make_spacetime(scene->spacetime.metric, scene->spacetime.parameters);
    const auto line = SpinWorldline::make(spacetime, scene->camera, 1e4);
    REQUIRE(line);
    REQUIRE(line->horizon_time());
    const double turns = line->azimuth(*line->horizon_time()) / (2 * M_PI), worst = worst_change(*line);
    fmt::print(
        "kerr-plunge: {:.3f} turns to the horizon at {:.4f} r_s/c, end at {:.4f}, r = {:.4f}; constants change by "
        "{:.1e}\n",
        turns, *line->horizon_time(), line->last(), line->at(line->last()).r, worst);
    CHECK(turns > 1);
    CHECK(line->reaches_inner_horizon());
    CHECK(worst < kConserved);
    const auto path = CameraPath::make(*scene);
    REQUIRE(path);
    CHECK(path->at(path->frames() - 1).r < *spacetime->horizon_radius());
}
