// Named numbers of spacetimes and cameras, against closed forms (Bardeen, Press and Teukolsky 1972; Synge 1966).
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "observer/landmarks.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"

using namespace nullscope;

namespace {

std::shared_ptr<const Spacetime> spacetime_of(const char* metric, MetricParameters parameters = {}) {
    auto made = make_spacetime(metric, parameters);
    REQUIRE(made);
    return *made;
}

// Innermost stable orbit of Kerr in M, with the rotation or (sense -1) against it.
double kerr_isco(double a, int sense = 1) {
    const double z1 = 1 + std::cbrt(1 - a * a) * (std::cbrt(1 + a) + std::cbrt(1 - a)),
                 z2 = std::sqrt(3 * a * a + z1 * z1);
    return 3 + z2 - sense * std::sqrt((3 - z1) * (3 + z1 + 2 * z2));
}

}  // namespace

TEST_CASE("landmarks: Schwarzschild and Kerr have their textbook radii") {
    const Landmarks flat_hole = landmarks_of(*spacetime_of("schwarzschild"));
    CHECK(flat_hole.horizon.value() == 1.0);
    CHECK(flat_hole.photon_orbit.value() == doctest::Approx(1.5).epsilon(1e-14));
    CHECK(flat_hole.isco.value() == doctest::Approx(3.0).epsilon(1e-12));
    CHECK(flat_hole.critical_impact.value() == doctest::Approx(1.5 * std::sqrt(3.0)).epsilon(1e-14));
    for (const double a : {0.1, 0.9, 0.998}) {
        CAPTURE(a);
        MetricParameters spin;
        spin["spin"] = a;
        const Landmarks hole = landmarks_of(*spacetime_of("kerr", spin));
        CHECK(hole.horizon.value() == doctest::Approx(0.5 * (1 + std::sqrt(1 - a * a))).epsilon(1e-12));
        CHECK(hole.isco.value() == doctest::Approx(0.5 * kerr_isco(a)).epsilon(1e-9));
        CHECK(hole.photon_orbit.value() == doctest::Approx(1 + std::cos(2.0 / 3.0 * std::acos(-a))).epsilon(1e-9));
        CHECK(hole.retrograde_isco.value() == doctest::Approx(0.5 * kerr_isco(a, -1)).epsilon(1e-9));
        CHECK(hole.retrograde_photon_orbit.value() ==
              doctest::Approx(1 + std::cos(2.0 / 3.0 * std::acos(a))).epsilon(1e-9));
        CHECK_FALSE(hole.critical_impact);
    }
    CHECK_FALSE(flat_hole.retrograde_isco);
    const Landmarks nothing = landmarks_of(*spacetime_of("minkowski"));
    CHECK_FALSE(nothing.horizon);
    CHECK_FALSE(nothing.photon_orbit);
    CHECK_FALSE(nothing.isco);
}

TEST_CASE("landmarks: the shadow of a rotating hole is as wide and high as its critical impact parameters say") {
    for (const double a : {0.1, 0.9, 0.998}) {
        CAPTURE(a);
        MetricParameters spin;
        spin["spin"] = a;
        const auto hole = spacetime_of("kerr", spin);
        CameraSpec camera;
        camera.r = 1e6, camera.theta = std::numbers::pi / 2, camera.yaw = 1.0;
        const auto size = camera_numbers(*hole, camera).shadow_size.value();
        // Bardeen 1973: b = 3 sqrt(M r) -+ a of the two orbits in the plane; as high as without spin.
        const double with = 2 + 2 * std::cos(2.0 / 3.0 * std::acos(-a)),
                     against = 2 + 2 * std::cos(2.0 / 3.0 * std::acos(a));
        CHECK(size[0] * camera.r == doctest::Approx(1.5 * (std::sqrt(with) + std::sqrt(against))).epsilon(1e-5));
        CHECK(size[1] * camera.r == doctest::Approx(3 * std::sqrt(3.0)).epsilon(1e-5));
        camera.r = 1.0;
        CHECK_FALSE(camera_numbers(*hole, camera).shadow_size);
    }
    MetricParameters still;
    still["spin"] = 1e-6;
    CameraSpec near;
    near.r = 4.0, near.theta = 1.0;
    const double radius = camera_numbers(*spacetime_of("schwarzschild"), near).shadow.value();
    const auto size = camera_numbers(*spacetime_of("kerr", still), near).shadow_size.value();
    for (const double diameter : size) CHECK(diameter == doctest::Approx(2 * radius).epsilon(1e-5));
}

TEST_CASE("landmarks: clocks, shadow and orbits of a camera") {
    const auto hole = spacetime_of("schwarzschild");
    CameraSpec camera;
    for (const double r : {1.2, 1.5, 3.0, 15.0, 1000.0}) {
        CAPTURE(r);
        camera.r = r;
        const CameraNumbers found = camera_numbers(*hole, camera);
        const double a = std::sqrt(1 - 1 / r), sine = std::fmin(1.5 * std::sqrt(3.0) / r * a, 1.0);
        CHECK(found.lapse.value() == doctest::Approx(a).epsilon(1e-14));
        CHECK(found.clock_rate.value() == doctest::Approx(a).epsilon(1e-14));
        CHECK(found.shadow.value() ==
              doctest::Approx(r < 1.5 ? std::numbers::pi - std::asin(sine) : std::asin(sine)).epsilon(1e-7));
        CHECK(found.orbit_speed.has_value() == (r > 1.5));
        if (r > 1.5) CHECK(found.orbit_speed.value() == doctest::Approx(std::sqrt(0.5 / (r - 1))).epsilon(1e-12));
        if (r > 1.5)
            CHECK(found.orbit_period.value() ==
                  doctest::Approx(2 * std::numbers::pi * std::sqrt(2 * r * r * r)).epsilon(1e-12));
    }
    camera.r = 15.0, camera.velocity = {0, 0.6, 0};
    CHECK(camera_numbers(*hole, camera).clock_rate.value() ==
          doctest::Approx(0.8 * std::sqrt(14.0 / 15.0)).epsilon(1e-14));
    camera.velocity = {}, camera.r = 4.0, camera.observer = ObserverKind::kRain;
    CHECK(camera_numbers(*hole, camera).clock_rate.value() == doctest::Approx(1 - 1 / 4.0).epsilon(1e-14));
    camera.velocity = {0.5, 0, 0};  // of the speed of the fall: at rest
    CHECK(camera_numbers(*hole, camera).clock_rate.value() == doctest::Approx(std::sqrt(0.75)).epsilon(1e-14));
    camera.velocity = {}, camera.observer = ObserverKind::kThrow, camera.energy = 2.0;
    CHECK(camera_numbers(*hole, camera).clock_rate.value() == doctest::Approx(0.375).epsilon(1e-14));
    camera.observer = ObserverKind::kCounterOrbit;
    CHECK(camera_numbers(*hole, camera).clock_rate.value() == doctest::Approx(std::sqrt(1 - 1.5 / 4)).epsilon(1e-14));
    camera.r = 0.5, camera.observer = ObserverKind::kRain;
    CHECK_FALSE(camera_numbers(*hole, camera).clock_rate);
    CHECK_FALSE(camera_numbers(*hole, camera).lapse);
    CHECK_FALSE(camera_numbers(*hole, camera).shadow);
    MetricParameters spin;
    spin["spin"] = 0.9;
    const auto kerr = spacetime_of("kerr", spin);
    camera.r = 2.0, camera.theta = std::numbers::pi / 2, camera.observer = ObserverKind::kZamo;
    CHECK(camera_numbers(*kerr, camera).clock_rate.value() ==
          doctest::Approx(std::sqrt(kerr->lapse_squared(2.0))).epsilon(1e-12));
}

TEST_CASE("landmarks: a star covers what lies within it") {
    CameraSpec camera;
    camera.r = 12.0;
    const auto small = spacetime_of("neutron-star", {{"radius", 1.4}}),
               compact = spacetime_of("neutron-star", {{"radius", 1.6}}),
               large = spacetime_of("neutron-star", {{"radius", 10.0}});
    CHECK(landmarks_of(*small).photon_orbit.value() == doctest::Approx(1.5));
    CHECK(camera_numbers(*small, camera).shadow.has_value());
    for (const auto* star : {&compact, &large}) {
        CHECK_FALSE(landmarks_of(**star).photon_orbit.has_value());
        CHECK_FALSE(landmarks_of(**star).critical_impact.has_value());
        CHECK_FALSE(camera_numbers(**star, camera).shadow.has_value());
    }
}

TEST_CASE("circular orbits: none within an inner horizon") {
    const auto charged = spacetime_of("reissner-nordstrom", {{{"charge", 0.8}}});
    CHECK_FALSE(circular_orbit(*charged, 0.0165));
    CHECK(circular_orbit(*charged, 3.0));
}
