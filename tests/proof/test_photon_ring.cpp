// What every half orbit does to light next to a photon orbit, spacetime/photon_shell.h, against traced rays: by how much successive
// images of a circle of the disc's plane are nearer to the critical direction, and their light later and turned.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/photon_ring.h"
#include "spacetime/photon_shell.h"
#include "spacetime/registry.h"
#include "support/depth.h"

namespace {

using namespace nullscope;

constexpr double kSame = 1e-5;  // of gamma; of delay and azimuth over their size

struct PhotonRingWorst {
    double gamma = 0, delay = 0, azimuth = 0;
};

Scene scene_of(const char* metric, const MetricParameters& parameters, double theta, double r,
               ObserverKind observer = ObserverKind::kStatic) {
    Scene scene;
    scene.spacetime = {metric, parameters};
    scene.camera.theta = theta, scene.camera.r = r, scene.camera.observer = observer;
    return scene;
}

// By images of the circle at r.
void measure(const Scene& scene, double psi, double r, PhotonRingWorst& worst) {
    const auto ring = reference::PhotonRing::make(scene);
    REQUIRE(ring);
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto orbit = photon_orbit(**spacetime, scene.camera.theta, psi);
    REQUIRE(orbit);
    const auto place = ring->place(psi);
    const auto measured = ring->half_orbit(place, r);
    REQUIRE(measured);
    CAPTURE(scene.spacetime.metric);
    CAPTURE(scene.camera.theta);
    CAPTURE(psi);
    const double off = std::fabs(measured->gamma - orbit->gamma),
                 late = std::fabs(measured->delay / orbit->delay - 1.0),
                 turned = std::fabs(std::remainder(measured->azimuth - orbit->azimuth, 2.0 * M_PI) / orbit->azimuth);
    CHECK(off <= kSame);
    CHECK(std::isfinite(late) == ((*spacetime)->axial() != nullptr || (*spacetime)->orbit_equation() != nullptr));
    CHECK(!(late > kSame));
    CHECK(turned <= kSame);
    worst.gamma = std::max(worst.gamma, off), worst.delay = std::fmax(worst.delay, late);
    worst.azimuth = std::max(worst.azimuth, turned);
}

void report(const char* what, const PhotonRingWorst& worst) {
    fmt::print("photon ring, {}: gamma off by {:.1e}, delay and azimuth by {:.1e} and {:.1e} of them at most\n", what,
               worst.gamma, worst.delay, worst.azimuth);
}

TEST_CASE("photon ring: half orbits of traced rays without spin") {
    MetricParameters kottler;
    kottler.formulas["A"] = "1 - 1/r - 0.0005*r^2";
    PhotonRingWorst worst;
    test::Selection selection(7);  // the formula, whose rays take a hundred times longer, is left to --all
    for (const Scene& scene :
         {scene_of("schwarzschild", {}, 1.0, 15.0), scene_of("schwarzschild", {}, 0.2, 1.3),
          scene_of("schwarzschild", {}, 1.0, 4.0, ObserverKind::kRain),
          scene_of("reissner-nordstrom", {{"charge", 0.9}}, 1.0, 15.0),
          scene_of("reissner-nordstrom", {{"charge", 1.04}}, 1.0, 15.0),
          scene_of("neutron-star", {{"radius", 1.3}}, 1.0, 15.0), scene_of("janis-newman-winicour", {}, 1.0, 15.0),
          scene_of("ellis", {}, 1.0, 15.0), scene_of("formula", kottler, 1.0, 15.0)})
        for (const double psi : {0.0, 0.5 * M_PI, 2.5})
            if (selection.takes_next()) measure(scene, psi, 5.0, worst);
    report("without spin", worst);
}

TEST_CASE("photon ring: half orbits of traced rays about rotating holes") {
    PhotonRingWorst worst;
    test::Selection selection(17);
    for (const Scene& scene :
         {scene_of("kerr", {{"spin", 0.9}}, 1.3, 15.0, ObserverKind::kZamo),
          scene_of("kerr", {{"spin", 0.5}}, 0.3, 15.0), scene_of("kerr", {{"spin", 1e-4}}, 1.0, 15.0),
          scene_of("kerr", {{"spin", 0.9}}, 0.0, 15.0),
          scene_of("kerr", {{"spin", 0.998}}, 1.5, 6.0, ObserverKind::kZamo),
          scene_of("kerr", {{"spin", 0.8}}, 1.0, 5.0, ObserverKind::kRain),
          scene_of("kerr-newman", {{"spin", 0.6}, {"charge", 0.7}}, 1.0, 15.0)})
        for (const double psi : {0.1, 1.0, 1.9, 3.0, -0.7})
            if (selection.takes_next()) measure(scene, psi, 5.0, worst);
    report("rotating", worst);
}

TEST_CASE("photon ring: circles within the orbit of light, and refusals in one line") {
    PhotonRingWorst worst;
    measure(scene_of("schwarzschild", {}, 1.0, 15.0), 1.0, 1.2, worst);
    measure(scene_of("kerr", {{"spin", 0.9}}, 1.3, 15.0), 3.0, 1.3, worst);
    report("within", worst);
    for (const auto& [metric, parameters] :
         {std::pair{"minkowski", MetricParameters{}}, {"neutron-star", MetricParameters{{"radius", 2.5}}}}) {
        const auto ring = reference::PhotonRing::make(scene_of(metric, parameters, 1.0, 15.0));
        REQUIRE(!ring);
        CHECK(ring.error().message().find("photon sphere") != std::string::npos);
    }
}

}  // namespace
