// The viewer's camera in the hand: conversion, drags, flight.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>

#include "observer/pose.h"
#include "scene/projection.h"
#include "spacetime/registry.h"
#include "studio/fly_camera.h"

using namespace nullscope;
using namespace nullscope::viewer;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoundTrip = 1e-12;    // of angles whose cosines are not small; measured 3e-15 for the orientation
constexpr double kOrientation = 4e-15;  // products of three rotations each way

struct Dice {
    std::mt19937_64 engine{20151127};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    CameraSpec pose() {
        CameraSpec camera;
        camera.r = 1.0 + std::pow(10.0, uniform(-3.0, 3.0));
        camera.theta = uniform(0.02, kPi - 0.02);
        camera.phi = uniform(-kPi, kPi);
        camera.yaw = uniform(-kPi, kPi);
        camera.pitch = uniform(-0.5 * kPi + 0.02, 0.5 * kPi - 0.02);
        camera.roll = uniform(-kPi, kPi);
        camera.velocity = {uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5)};
        return camera;
    }
};

double difference(Vec3 a, Vec3 b) { return length(a - b); }
double difference(const Mat3& a, const Mat3& b) {
    return std::max({difference(a.a, b.a), difference(a.b, b.b), difference(a.c, b.c)});
}
double angle_difference(double a, double b) { return std::fabs(std::remainder(a - b, 2.0 * kPi)); }
double departure_from_rotation(const Mat3& m) { return difference(transposed(m) * m, Mat3{}); }

CameraSpec spec_of(const FlyCamera& camera) {
    CameraSpec spec;
    write_spec(camera, spec);
    return spec;
}

std::shared_ptr<const Spacetime> spacetime(const std::string& metric) { return *make_spacetime(metric, {}); }

// Unmoved by world axes: what a picture depends on.
void check_same_view(const FlyCamera& a, const FlyCamera& b, double tolerance) {
    CHECK(difference(a.place, b.place) < tolerance);
    CHECK(difference(a.world_from_camera, b.world_from_camera) < tolerance);
    CHECK(difference(a.velocity, b.velocity) < tolerance);
}

}  // namespace

TEST_CASE("a camera comes back from its angles and its matrix") {
    Dice dice;
    for (int i = 0; i < 20'000; ++i) {
        const CameraSpec before = dice.pose();
        const CameraSpec after = spec_of(fly_camera(before));
        REQUIRE(after.r == before.r);
        REQUIRE(std::fabs(after.theta - before.theta) < kRoundTrip);
        REQUIRE(angle_difference(after.phi, before.phi) < kRoundTrip);
        REQUIRE(angle_difference(after.yaw, before.yaw) < kRoundTrip);
        REQUIRE(angle_difference(after.pitch, before.pitch) < kRoundTrip);
        REQUIRE(angle_difference(after.roll, before.roll) < kRoundTrip);
        REQUIRE(difference(after.velocity, before.velocity) < kRoundTrip);
        REQUIRE(difference(fly_camera(after).world_from_camera, fly_camera(before).world_from_camera) < kOrientation);
    }
}

TEST_CASE("the view comes back where its angles are not unique") {
    Dice dice;
    for (int i = 0; i < 1000; ++i) {
        for (const double pitch : {0.5 * kPi, -0.5 * kPi, 0.5 * kPi - 1e-9, 0.5 * kPi + 1e-9, 3.0}) {
            for (const double theta : {0.0, kPi, 1e-9, kPi - 1e-9, 1.2}) {
                CameraSpec spec = dice.pose();
                spec.pitch = pitch;
                spec.theta = theta;
                const FlyCamera camera = fly_camera(spec);
                check_same_view(fly_camera(spec_of(camera)), camera, kOrientation);
            }
        }
    }
}

TEST_CASE("a drag puts what was grabbed under the hand") {
    Dice dice;
    for (int i = 0; i < 1000; ++i) {
        CameraSpec spec = dice.pose();
        const Mat3 before = fly_camera(spec).world_from_camera;
        const Vec3 grabbed = pixel_direction(spec, dice.uniform(0, spec.width), dice.uniform(0, spec.height));
        const Vec3 now =
            pixel_direction(spec, dice.uniform(-200, spec.width + 200), dice.uniform(-200, spec.height + 200));
        const Mat3 after = dragged(before, grabbed, now);
        CHECK(angle_between(after * now, before * grabbed) < 1e-14);
        CHECK(departure_from_rotation(after) < kOrientation);
        CHECK(difference(dragged(before, grabbed, grabbed), before) < kOrientation);
    }
}

TEST_CASE("a roll takes the top to the right and leaves the line of sight") {
    const FlyCamera camera = fly_camera(CameraSpec{});
    const Mat3 turned = rolled(camera.world_from_camera, 0.5 * kPi);
    CHECK(difference(turned.b, camera.world_from_camera.a) < kOrientation);
    CHECK(difference(turned.c, camera.world_from_camera.c) < kOrientation);
    CameraSpec spec;
    spec.roll = 0.3;
    FlyCamera again = camera;
    again.world_from_camera = rolled(camera.world_from_camera, 0.3);
    CHECK(spec_of(again).roll == doctest::Approx(0.3).epsilon(1e-14));
}

TEST_CASE("an orbit keeps r, the look and the motion as the hole sees them, and comes back with the hand") {
    Dice dice;
    for (int i = 0; i < 1000; ++i) {
        CameraSpec before = dice.pose();
        if (i % 2 == 1) before.r = -before.r;  // the far side of a wormhole
        CameraSpec after = before;
        const double right = dice.uniform(-3.0, 3.0);
        const double down = dice.uniform(-1.0, 1.0) * (std::min(before.theta, kPi - before.theta) - 0.01);
        orbit(after, right, down);
        CHECK(after.phi >= -kPi);
        CHECK(after.phi <= kPi);
        CHECK(std::fabs(std::remainder(after.phi - before.phi, 2.0 * kPi)) ==
              doctest::Approx(std::fabs(right)).epsilon(1e-12));
        CHECK(std::fabs(after.theta - before.theta) == doctest::Approx(std::fabs(down)).epsilon(1e-9));
        orbit(after, -right, -down);
        CHECK(angle_difference(after.phi, before.phi) < kRoundTrip);
        CHECK(std::fabs(after.theta - before.theta) < kRoundTrip);
        after.phi = before.phi, after.theta = before.theta;
        CHECK(after == before);
    }
}

TEST_CASE("an orbit follows the hand, whichever way the camera looks, and stops at the poles") {
    CameraSpec inward, outward, turned;
    outward.yaw = kPi, turned.roll = kPi;
    for (CameraSpec* camera : {&inward, &outward, &turned}) {
        camera->theta = 1.0, camera->phi = 0.5;
        orbit(*camera, 0.2, 0.1);
    }
    CHECK(inward.phi == doctest::Approx(0.3));
    CHECK(inward.theta == doctest::Approx(0.9));  // what is near goes down: the camera goes up
    CHECK(outward.phi == doctest::Approx(0.7));
    CHECK(outward.theta == doctest::Approx(0.9));
    CHECK(turned.phi == doctest::Approx(0.7));
    CHECK(turned.theta == doctest::Approx(1.1));
    CameraSpec camera = inward;
    orbit(camera, 0.0, 5.0);
    CHECK(camera.theta == doctest::Approx(0.01));
    CHECK(camera.phi == inward.phi);
    orbit(camera, 0.0, -5.0);
    CHECK(camera.theta == doctest::Approx(kPi - 0.01));
    camera.theta = 0.001;  // a scene's own camera stays
    orbit(camera, 0.1, 1.0);
    CHECK(camera.theta == 0.001);
    orbit(camera, 0.1, -1.0);
    CHECK(camera.theta == doctest::Approx(1.001));
}

TEST_CASE("the distance to the horizon scales and never ends there") {
    const FlightRange range = flight_range(*spacetime("schwarzschild"));
    CHECK(range.horizon == 1.0);
    CHECK(scaled_radius(3.0, std::log(2.0), range) == doctest::Approx(5.0).epsilon(1e-14));
    CHECK(scaled_radius(3.0, -std::log(2.0), range) == doctest::Approx(2.0).epsilon(1e-14));
    CHECK(scaled_radius(3.0, -1000.0, range) == range.nearest);
    CHECK(range.nearest > 1.0);
    CHECK(scaled_radius(3.0, 1000.0, range) == range.farthest);
    CHECK(scaled_radius(1.00001, -1.0, range) == 1.00001);  // a scene's own camera stays
    CHECK(scaled_radius(1e6, 1.0, range) == 1e6);
    CHECK(scaled_radius(1e6, -1.0, range) < 1e6);
}

TEST_CASE("a hand flies slower near a horizon, and as fast as ever where there is none") {
    const FlightRange hole = flight_range(*spacetime("schwarzschild"));
    CHECK(hole.pace(1.0) == doctest::Approx(1.0 / 3.0));
    CHECK(hole.pace(2.0) == doctest::Approx(0.5));
    CHECK(hole.pace(1e4) == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(flight_range(*spacetime("ellis")).pace(0.0) == 1.0);
    CHECK(flight_range(*spacetime("minkowski")).pace(0.5) == 1.0);
}

TEST_CASE("flight through a wormhole: the same pace all the way, through l = 0 to the far side and back") {
    for (const char* metric : {"ellis", "dneg-wormhole"}) {
        const auto hole = spacetime(metric);
        const FlightRange range = flight_range(*hole);
        CHECK(range.nearest == -range.farthest);
        FlyCamera camera = fly_camera(CameraSpec{});
        camera.r = 3.0;
        double before = camera.r;
        for (int i = 0; i < 400; ++i) {  // ahead is inward
            fly(camera, {0, 0, -0.01}, *hole);
            CHECK(camera.r < before);
            CHECK(before - camera.r == doctest::Approx(0.01 * std::hypot(camera.r, 1.0)).epsilon(0.02));
            before = camera.r;
        }
        CHECK(camera.r < -3.0);
        CHECK(scaled_radius(0.0, 1.0, range) == doctest::Approx(std::sinh(1.0)).epsilon(1e-14));
        CHECK(scaled_radius(-2.0, 1000.0, range) == range.farthest);
        CHECK_FALSE(circular_orbit_speed(*hole, 0.0));
    }
    const FlightRange star = flight_range(*spacetime("neutron-star"));
    CHECK(camera_can_rest(*spacetime("neutron-star"), star.nearest));
}

TEST_CASE("in flat space flight is straight") {
    const auto flat = spacetime("minkowski");
    CameraSpec spec;
    spec.yaw = 0.7, spec.pitch = -0.2;
    const FlyCamera start = fly_camera(spec);
    FlyCamera camera = start;
    const Vec3 ahead = -start.world_from_camera.c;
    for (int i = 0; i < 40; ++i) fly(camera, {0, 0, -0.05}, *flat);
    const Vec3 way = camera.r * camera.place - start.r * start.place;
    CHECK(length(way) > 10.0);
    CHECK(angle_between(way, ahead) < 0.01);  // of one Euler step
    CHECK(difference(camera.world_from_camera, start.world_from_camera) == 0.0);
}

TEST_CASE("flight stays outside of the horizon and keeps the look in world axes") {
    const auto hole = spacetime("schwarzschild");
    FlyCamera camera = fly_camera(CameraSpec{});
    const Mat3 look = camera.world_from_camera;
    fly(camera, {0, 0, -100}, *hole);
    CHECK(camera.r == flight_range(*hole).nearest);
    fly(camera, {0.3, 0.1, 0.7}, *hole);
    CHECK(camera.r > 1.0);
    CHECK(difference(camera.world_from_camera, look) == 0.0);
    // Sideways: r stays in the first order, and the way is as long as asked for in proper length.
    FlyCamera side = fly_camera(CameraSpec{});
    const Vec3 from = side.place;
    fly(side, {1e-4, 0, 0}, *hole);
    CHECK(side.r == doctest::Approx(15.0).epsilon(1e-8));
    const double proper_scale = (15.0 - 1.0) / std::sqrt(1.0 - 1.0 / 15.0);  // of the radial step: dr / sqrt(A)
    CHECK(angle_between(from, side.place) * 15.0 == doctest::Approx(1e-4 * proper_scale).epsilon(1e-6));
}

TEST_CASE("nothing jumps at a pole") {
    const auto hole = spacetime("schwarzschild");
    CameraSpec spec;
    spec.theta = 0.05, spec.phi = 0.4, spec.roll = 0.3;
    spec.velocity = {0.1, -0.3, 0.2};
    double nearest = spec.theta;
    // The unrolled camera's up is north: over the pole, through the angles at every step as the viewer does.
    for (int i = 0; i < 60; ++i) {
        const FlyCamera before = fly_camera(spec);
        FlyCamera camera = before;
        const Vec3 north = transposed(before.world_from_camera) * Vec3{-std::cos(0.4), -std::sin(0.4), 0.0};
        fly(camera, 0.002 * north, *hole);
        write_spec(camera, spec);
        nearest = std::min(nearest, spec.theta);
        check_same_view(fly_camera(spec), before, 0.01);
        CHECK(difference(fly_camera(spec).world_from_camera, before.world_from_camera) < kOrientation);
        CHECK(length(spec.velocity) == doctest::Approx(std::sqrt(0.14)).epsilon(1e-12));
        CHECK(spec.velocity.x == doctest::Approx(0.1).epsilon(1e-9));  // outward stays outward
    }
    CHECK(nearest < 0.002);
    CHECK(std::fabs(std::remainder(spec.phi - 0.4, 2.0 * kPi)) > 3.0);  // on the other side
}

TEST_CASE("speeds that a static observer knows") {
    const auto hole = spacetime("schwarzschild");
    CHECK(free_fall_speed(*hole, 4.0) == doctest::Approx(0.5).epsilon(1e-14));  // sqrt(r_s/r)
    CHECK(*circular_orbit_speed(*hole, 3.0) ==
          doctest::Approx(0.5).epsilon(1e-14));  // sqrt(M/(r - 2M)): c/2 at the ISCO
    CHECK(*circular_orbit_speed(*hole, 6.0) == doctest::Approx(std::sqrt(0.1)).epsilon(1e-14));
    CHECK_FALSE(circular_orbit_speed(*hole, 1.5).has_value());  // light's own orbit
    CHECK_FALSE(circular_orbit_speed(*hole, 1.2).has_value());
    const auto flat = spacetime("minkowski");
    CHECK(free_fall_speed(*flat, 4.0) == 0.0);
    CHECK_FALSE(circular_orbit_speed(*flat, 4.0).has_value());
}
