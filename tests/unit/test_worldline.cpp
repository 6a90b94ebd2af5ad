// Cameras that are let go: proper times, conserved quantities, parallel axes.
#include <cmath>

#include <doctest/doctest.h>

#include "observer/observer.h"
#include "observer/path.h"
#include "observer/pose.h"
#include "observer/worldline.h"
#include "spacetime/registry.h"
#include "support/observer.h"

namespace {

using namespace nullscope;

constexpr double kMass = 0.5;  // in r_s: proper times of the literature are in M

std::shared_ptr<const Spacetime> worldline_spacetime(const std::string& metric,
                                                     const std::map<std::string, double>& parameters = {}) {
    return *make_spacetime(metric, parameters);
}
CameraSpec camera_at(double r, ObserverKind observer, Vec3 velocity = {}) {
    CameraSpec camera;
    camera.r = r, camera.observer = observer, camera.velocity = velocity, camera.theta = 1.1, camera.phi = 0.4;
    camera.yaw = 0.3, camera.pitch = -0.2, camera.roll = 0.1;
    return camera;
}

TEST_CASE("worldline: proper times of falls") {
    constexpr double kPromised = 1e-10;  // M
    const auto hole = worldline_spacetime("schwarzschild");
    const auto rain = Worldline::make(hole, camera_at(1.0, ObserverKind::kRain), 100);
    REQUIRE(rain);
    CHECK(rain->end() == WorldlineEnd::kSingularity);
    CHECK(std::fabs(rain->end_time() / kMass - 4.0 / 3.0) < kPromised);
    const auto drop = Worldline::make(hole, camera_at(5.0, ObserverKind::kStatic), 100);
    REQUIRE(drop);
    REQUIRE(drop->horizon_time());
    MESSAGE("from rest at 10 M: horizon after " << *drop->horizon_time() / kMass << " M, end after "
                                                << drop->end_time() / kMass << " M");
    CHECK(std::fabs(*drop->horizon_time() / kMass - 33.7008698518923) < kPromised);
    CHECK(std::fabs(drop->end_time() / kMass - 35.1240736552036) < kPromised);
    const auto long_rain = Worldline::make(hole, camera_at(5.0, ObserverKind::kRain), 100);
    REQUIRE(long_rain);
    CHECK(std::fabs(*long_rain->horizon_time() / kMass - 13.5737865166653) < kPromised);
}

TEST_CASE("worldline: the azimuth keeps whole turns, however an orbit lies") {
    const auto hole = worldline_spacetime("schwarzschild"), spun = worldline_spacetime("kerr", {{"spin", 0.9}});
    // Along e_r, e_theta, e_phi; on a circle r = 5 at rest's speed 1/sqrt(2 (r - 1)): 41.6 r_s/c of proper time a turn and more.
    const double pace = std::sqrt(0.125);
    for (const double tilt : {0.0, 0.9, M_PI / 2 - 1e-3, M_PI / 2 + 1e-3, M_PI}) {
        CameraSpec start = camera_at(5.0, ObserverKind::kStatic, {0, pace * std::sin(tilt), pace * std::cos(tilt)});
        start.theta = M_PI / 2;
        const auto line = Worldline::make(hole, start, 1000);
        REQUIRE(line);
        const double turns = 1000 * pace / std::sqrt(0.875) / 5.0 / (2 * M_PI), sense = tilt < M_PI / 2 ? 1 : -1;
        CHECK(line->azimuth(0) == doctest::Approx(start.phi).epsilon(1e-14));
        CHECK(std::fabs(line->azimuth(1000) - start.phi - sense * turns * 2 * M_PI) < M_PI / 2 + 1e-9);
        for (double tau = 0; tau <= 1000; tau += 31)
            CHECK(std::fabs(std::remainder(line->azimuth(tau) - line->at(tau).phi, 2 * M_PI)) < 1e-12);
    }
    CameraSpec over_the_poles = camera_at(5.0, ObserverKind::kStatic, {0, pace, 0});
    CHECK(std::fabs(Worldline::make(hole, over_the_poles, 1000)->azimuth(1000) - over_the_poles.phi) < M_PI + 1e-9);
    const auto orbit = Worldline::make(spun, camera_at(5.0, ObserverKind::kOrbit), 1000);
    REQUIRE(orbit);
    CHECK(orbit->azimuth(1000) > 20 * M_PI);
    CHECK(std::fabs(std::remainder(orbit->azimuth(777) - orbit->at(777).phi, 2 * M_PI)) < 1e-9);
}

TEST_CASE("worldline: the clock of what falls is v - r, through the horizon, and of what was at rest t before") {
    constexpr double kPromised = 1e-10;  // r_s/c
    const auto hole = worldline_spacetime("schwarzschild");
    const auto rain = Worldline::make(hole, camera_at(5.0, ObserverKind::kRain), 100);
    REQUIRE(rain);
    const auto wound = [](double r) { return 2 * (std::sqrt(r) - std::log1p(std::sqrt(r))); };
    for (const double part : {0.0, 0.3, 0.9, 0.99, 0.9999}) {  // the horizon is passed at 0.91
        const double tau = part * rain->last(), r = rain->at(tau).r;
        CHECK(std::fabs(rain->clock(tau) - (tau + wound(5.0) - wound(r))) < kPromised);
    }
    // On a circle t = u^t tau; v - r is ahead of it by r_* - r = ln(r - 1).
    const auto orbit = Worldline::make(hole, camera_at(5.0, ObserverKind::kOrbit), 100);
    REQUIRE(orbit);
    CHECK(std::fabs(orbit->clock(80) - (std::log(4.0) + 80 / std::sqrt(1 - 1.5 / 5))) < kPromised);
    // Without a horizon time is t.
    const auto flat =
        Worldline::make(worldline_spacetime("minkowski"), camera_at(5.0, ObserverKind::kStatic, {0.6, 0, 0}), 100);
    REQUIRE(flat);
    CHECK(std::fabs(flat->clock(80) - 100) < kPromised);
    // About a rotating hole: u^t of a circle in the equator's plane (Bardeen, Press and Teukolsky 1972), M = 1/2.
    const double a = 0.45, r = 3, drag = a * std::sqrt(0.5) / std::pow(r, 1.5);
    CameraSpec turning = camera_at(r, ObserverKind::kOrbit);
    turning.theta = M_PI / 2;
    const auto spun = worldline_spacetime("kerr", {{"spin", 0.9}});
    const auto round = Worldline::make(spun, turning, 100);
    REQUIRE(round);
    CHECK(std::fabs(round->clock(80) - round->clock(0) - 80 * (1 + drag) / std::sqrt(1 - 1.5 / r + 2 * drag)) <
          10 * kPromised);
    const auto slow =
        Worldline::make(worldline_spacetime("kerr", {{"spin", 1e-9}}), camera_at(5.0, ObserverKind::kStatic), 100);
    const auto still = Worldline::make(hole, camera_at(5.0, ObserverKind::kStatic), 100);
    REQUIRE((slow && still));
    for (const double tau : {0.0, 5.0, 16.0}) CHECK(std::fabs(slow->clock(tau) - still->clock(tau)) < 100 * kPromised);
}

// The tetrad of a camera in ingoing coordinates: products against the metric.
double orthonormality(const Spacetime& spacetime, const CameraSpec& camera) {
    const auto tetrad = ingoing_tetrad_pair(spacetime, camera);
    REQUIRE(tetrad);
    const Matrix4 g = ingoing_metric(spacetime, camera.r, camera.theta);
    double worst = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            long double product = 0;
            for (int mu = 0; mu < 4; ++mu)
                for (int nu = 0; nu < 4; ++nu)
                    product += static_cast<long double>(g[mu][nu]) *
                               (static_cast<long double>(tetrad->high[i][mu]) + tetrad->low[i][mu]) *
                               (static_cast<long double>(tetrad->high[j][nu]) + tetrad->low[j][nu]);
            const long double wanted = i != j ? 0 : i == 0 ? -1 : 1;
            worst = std::fmax(worst, static_cast<double>(std::fabs(product - wanted)));
        }
    return worst;
}

TEST_CASE("observers: orthonormal outside, on and inside the horizon") {
    constexpr double kPromised = 1e-12;
    for (const auto& spacetime :
         {worldline_spacetime("schwarzschild"), worldline_spacetime("reissner-nordstrom", {{"charge", 0.8}}),
          worldline_spacetime("reissner-nordstrom", {{"charge", 1.0}})})
        for (const double r : {100.0, 6.0, 3.0, 1.6, 1.0 + 1e-9, 1.0, 1.0 - 1e-9, 0.7, 0.45, 0.05, 0.001})
            for (const ObserverKind kind : {ObserverKind::kStatic, ObserverKind::kRain, ObserverKind::kFall,
                                            ObserverKind::kThrow, ObserverKind::kOrbit})
                for (const Vec3 v : {Vec3{}, Vec3{0.3, -0.5, 0.6}, Vec3{-0.9, 0.1, 0.2}}) {
                    CameraSpec camera = camera_at(r, kind, v);
                    camera.fall_from = std::fmax(r, 8.0), camera.energy = 1.7;
                    const auto observer = observer_of(*spacetime, camera);
                    if (!observer || length(observer->velocity) > 0.999999)
                        continue;  // an orbit next to the photon sphere
                    CAPTURE(r);
                    CAPTURE(std::string(observer_name(kind)));
                    CHECK(orthonormality(*spacetime, camera) < kPromised);
                }
}

TEST_CASE("observers: a static frame and a rain frame that fall back by their relative speed are one") {
    constexpr double kPromised = 1e-12;
    const auto hole = worldline_spacetime("schwarzschild");
    for (const double r : {1.01, 1.5, 5.0, 100.0}) {
        const CameraSpec rest = camera_at(r, ObserverKind::kStatic),
                         rain = camera_at(r, ObserverKind::kRain, {std::sqrt(1 / r), 0, 0});
        const auto a = ingoing_tetrad_pair(*hole, rest), b = ingoing_tetrad_pair(*hole, rain);
        REQUIRE(a);
        REQUIRE(b);
        for (int i = 0; i < 4; ++i)
            for (int mu = 0; mu < 4; ++mu) {
                const double scale = std::fmax(1.0, std::fabs(a->high[i][mu])), gamma2 = 1 / (1 - 1 / r);
                CHECK(std::fabs(a->high[i][mu] - b->high[i][mu]) < kPromised * scale * std::fmax(1.0, 1e-3 * gamma2));
            }
    }
}

TEST_CASE("worldline: nothing is lost on the way") {
    for (const auto& spacetime :
         {worldline_spacetime("schwarzschild"), worldline_spacetime("reissner-nordstrom", {{"charge", 0.9}})}) {
        const auto line = Worldline::make(spacetime, camera_at(6.0, ObserverKind::kStatic, {-0.2, 0.15, 0.25}), 300);
        REQUIRE(line);
        for (int i = 0; i <= 50; ++i) {
            const CameraSpec camera = line->at(line->last() * i / 50);
            // Large next to the singularity, in the rain frame.
            const double gamma2 = 1 / (1 - dot(camera.velocity, camera.velocity));
            CHECK(orthonormality(*spacetime, camera) < 1e-12 * std::fmax(1, 1e-3 * gamma2));
            // E of the 4-velocity that the camera has now.
            const auto tetrad = ingoing_tetrad_pair(*spacetime, camera);
            const double e = spacetime->lapse_squared(camera.r) * tetrad->high[0][0] - tetrad->high[0][1];
            CHECK(std::fabs(e - line->energy()) < 1e-12 * gamma2 + 1e-10);
        }
    }
}

TEST_CASE("worldline: a gyroscope on a circular orbit turns by de Sitter's angle") {
    const auto hole = worldline_spacetime("schwarzschild");
    CameraSpec camera = camera_at(5.0, ObserverKind::kOrbit);
    camera.theta = M_PI / 2, camera.yaw = camera.pitch = camera.roll = 0;
    // Proper: 2 pi r^(3/2)/sqrt(M) sqrt(1 - 3M/r).
    const double period = 2 * M_PI * std::sqrt(2.0 * 125.0) * std::sqrt(1 - 1.5 / 5.0);
    const auto line = Worldline::make(hole, camera, 2 * period);
    REQUIRE(line);
    CHECK(line->end() == WorldlineEnd::kOpen);
    const CameraSpec after = line->at(period);
    CHECK(std::fabs(after.r - 5.0) < 1e-9);
    CHECK(std::fabs(std::remainder(after.phi - camera.phi, 2 * M_PI)) < 1e-9);
    // Its forward axis along those of an observer who has been turning with the radius.
    CameraSpec turning = camera;
    turning.phi = after.phi;
    const auto gyroscope = ingoing_tetrad_pair(*hole, after), orbiting = ingoing_tetrad_pair(*hole, turning);
    REQUIRE(gyroscope);
    REQUIRE(orbiting);
    const Matrix4 g = ingoing_metric(*hole, after.r, after.theta);
    const auto product = [&](int i, int j) {
        double sum = 0;
        for (int mu = 0; mu < 4; ++mu)
            for (int nu = 0; nu < 4; ++nu) sum += g[mu][nu] * gyroscope->high[i][mu] * orbiting->high[j][nu];
        return sum;
    };
    const double turned = std::fabs(std::atan2(product(3, 1), product(3, 3))),
                 sitter = 2 * M_PI * (1 - std::sqrt(1 - 1.5 / 5.0));
    MESSAGE("turned by " << turned << " rad, de Sitter: " << sitter);
    CHECK(std::fabs(turned - sitter) < 1e-9);
}

TEST_CASE("paths: keys are met, and the way between them is smooth") {
    Scene scene;
    scene.path.emplace();
    scene.path->kind = PathKind::kKeys;
    for (const auto& [frame, r] : {std::pair{0.0, 10.0}, {10.0, 6.0}, {30.0, 4.0}}) {
        PathKey key{frame, scene.camera};
        key.camera.r = r, key.camera.velocity = {0, 0, 0.01 * r};
        scene.path->keys.push_back(key);
    }
    scene.path->frames = 31;
    const auto path = CameraPath::make(scene);
    REQUIRE(path);
    for (const PathKey& key : scene.path->keys) CHECK(std::fabs(path->at(key.frame).r - key.camera.r) < 1e-12);
    const double left = (path->at(10).r - path->at(10 - 1e-5).r) / 1e-5,
                 right = (path->at(10 + 1e-5).r - path->at(10).r) / 1e-5;
    CHECK(std::fabs(left - right) < 1e-4);
    CHECK(path->at(-5).r == path->at(0).r);
    CHECK(path->at(99).r == path->at(30).r);

    scene.path->easing = PathEasing::kSmooth;
    scene.path->keys.back().time = 4.0;
    const auto smooth = CameraPath::make(scene);
    REQUIRE(smooth);
    constexpr double kStep = 1e-4;
    CHECK(std::fabs(smooth->at(kStep).r - 10.0) < 1e-8);  // at rest at both ends
    CHECK(std::fabs(smooth->at(30 - kStep).r - 4.0) < 1e-8);
    CHECK(std::fabs(smooth->clock(30 - kStep) - 4.0) < 1e-8);
    CHECK(std::fabs(smooth->at(15).r - path->at(15).r) < 1e-12);  // the middle is met halfway
    for (const PathKey& key : scene.path->keys) {
        const double frame = frame_of_key(*scene.path, key.frame);
        CHECK(std::fabs(eased(*scene.path, frame) - key.frame) < 1e-12);
        CHECK(std::fabs(smooth->at(frame).r - key.camera.r) < 1e-12);
    }
    CHECK(std::fabs(eased(*scene.path, 7.5) - 30 * 0.15625) < 1e-12);  // 3/16 - 2/64 of the way
    CHECK(smooth->at(-5).r == 10.0);
    CHECK(smooth->at(99).r == 4.0);
}

}  // namespace
