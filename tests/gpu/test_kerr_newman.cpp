// A rotating hole with charge as the driver draws it: the shadow's edge by the spherical photon orbits, and frames with everything
// that a rotating hole can have against the reference.
#include <cmath>

#include "scene/bodies.h"
#include "shadow_edge.h"
#include "support/gpu_session.h"
#include "support/metrics.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kKerrNewmanRays_px = 0.05;  // what is promised of every ray
constexpr double kSpin = 0.6, kCharge = 0.6;

Scene charged() {
    Scene scene;
    scene.spacetime = {"kerr-newman", {{"spin", kSpin}, {"charge", kCharge}}};
    scene.camera.observer = ObserverKind::kZamo;
    return scene;
}

struct Constants {
    double lambda, eta;  // L/E and Q/E^2 of the photon orbit at constant r, M = 1
};
// With X = r^2 + a^2 - a lambda: X^2 = Delta K and 4 r X = Delta' K, so X = 4 r Delta/Delta' and K = 16 r^2 Delta/Delta'^2.
Constants spherical_orbit(double r) {
    const double delta = r * r - 2 * r + kSpin * kSpin + kCharge * kCharge, slope = 2 * r - 2;
    const double lambda = (r * r + kSpin * kSpin - 4 * r * delta / slope) / kSpin,
                 k = 16 * r * r * delta / (slope * slope);
    return {lambda, k - (lambda - kSpin) * (lambda - kSpin)};
}

// Where eta vanishes between two radii.
double equatorial(double low, double high) {
    const bool sign = spherical_orbit(low).eta > 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        ((spherical_orbit(middle).eta > 0) == sign ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Edge edge_at(double r, bool vertical, int outside) {
    const Constants of = spherical_orbit(r);
    return {of.lambda, of.eta, vertical, outside};
}

TEST_CASE(
    "kerr-newman: the shadow's edge is the critical curve of the spherical photon orbits, a = Q = 0.6 M, to 0.02 px") {
    const double prograde = equatorial(1.6, 2.8), retrograde = equatorial(2.8, 4);
    REQUIRE(std::abs(spherical_orbit(prograde).eta) < 1e-9);
    REQUIRE(std::abs(spherical_orbit(retrograde).eta) < 1e-9);
    on_every_context([&](GpuSession& session) {
        for (const Edge& edge :
             {edge_at(prograde, false, -1), edge_at(retrograde, false, 1),
              edge_at(0.5 * (prograde + retrograde), true, 1), edge_at(0.7 * prograde + 0.3 * retrograde, true, 1)}) {
            const double off = edge_off_px(session, charged(), edge, 0);
            fmt::print("{:<7} kerr-newman: lambda {:8.5f} M, eta {:8.5f} M^2: edge off by {:.5f} px at most\n",
                       session.context->kind(), edge.lambda, edge.eta, off);
            CHECK(off <= kEdge_px);
            CHECK(edge_off_px(session, charged(), edge, 1.5 * kEdge_px) > kEdge_px);  // a shifted edge is seen
        }
    });
}

TEST_CASE("kerr-newman: frames with disc, bodies, light times and falling cameras are the reference's" *
          test::costly()) {
    struct View {
        const char* name;
        void (*set)(Scene&);
    };
    const View views[] = {
        {"sky", [](Scene&) {}},
        {"disc", [](Scene& s) { s.disc = DiscSpec{}, s.disc->inner = 1.0, s.disc->outer = 7.0; }},
        {"disc, light times",
         [](Scene& s) { s.disc = DiscSpec{}, s.disc->inner = 1.0, s.disc->flow = DiscFlowKind::kKepler; }},
        {"ball and cylinder",
         [](Scene& s) {
             add<BallSpec>(s).position = {3, 2, 0.5}, first_shape<BallSpec>(s)->radius = 0.8;
             add<CylinderSpec>(s).inner = 2, first_shape<CylinderSpec>(s)->outer = 5,
             first_shape<CylinderSpec>(s)->height = 0.2;
         }},
        {"planet",
         [](Scene& s) {
             add<BallSpec>(s).position = {4, 0, 0}, first_shape<BallSpec>(s)->radius = 0.7;
             first_shape<BallSpec>(s)->motion = BallMotion::kOrbit, s.time = 20;
         }},
        {"rain outside", [](Scene& s) { s.camera.observer = ObserverKind::kRain, s.camera.r = 2.0; }},
        {"rain inside",
         [](Scene& s) {
             s.camera.observer = ObserverKind::kRain, s.camera.r = 0.6;  // horizons at 0.765 and 0.235 r_s
             s.disc = DiscSpec{}, s.disc->inner = 1.2;
         }},
        {"moving", [](Scene& s) {
             s.camera.velocity = {0.3, 0.2, -0.4};
         }}};
    on_one_context([&](GpuSession& session) {
        for (const View& view : views) {
            CAPTURE(view.name);
            Scene scene = charged();
            scene.sky.kind = SkyKind::kBlack;
            scene.camera.r = 8, scene.camera.theta = 1.3, scene.camera.yaw = 0.1;
            scene.camera.plane_width = 1.4, scene.camera.width = 64, scene.camera.height = 36;
            view.set(scene);
            const RayMeasures m = measure_rays(gl_ray_data(session, scene), scene.camera, reference_trace(scene));
            const double finer = 1920.0 / scene.camera.width;
            fmt::print("kerr-newman, {:<18}: sky {:.4f}, places {:.4f}, g {:.4f} px of 1080p; fate errors {}\n",
                       view.name, m.sky_px.max * finer, m.place_px.max * finer, m.g_px.max * finer, m.fate_errors);
            CHECK(m.sky_px.max * finer <= kKerrNewmanRays_px);
            CHECK(m.place_px.max * finer <= kKerrNewmanRays_px);
            CHECK(m.fate_errors == 0);
            CHECK(m.not_finite == 0);
        }
    });
}

}  // namespace
