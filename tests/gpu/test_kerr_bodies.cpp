// Solid bodies about a rotating hole: every pixel of many small frames against the reference, which looks for them along its own rays.
#include <cmath>
#include <functional>
#include <vector>

#include "scene/bodies.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

const int kKerrBodiesWidth = by_depth(65, 97, 97), kKerrBodiesHeight = by_depth(37, 55, 55);
const double kOf1080 = 1080.0 / kKerrBodiesHeight;  // a pixel of these frames in those of 1080p
constexpr double kKerrBodiesScreenError_px = 0.05;  // the project's promise, px of 1080p

struct KerrBodiesCase {
    const char* name;
    std::function<void(Scene&)> set;
};

void spin(Scene& s, double spin) { s.spacetime.parameters["spin"] = spin; }
void ball(Scene& s, Vec3 at, double radius) {
    add<BallSpec>(s).position = at, first_shape<BallSpec>(s)->radius = radius;
}
void thick_disc(Scene& s, double inner, double outer, double height) {
    add<CylinderSpec>(s).inner = inner, first_shape<CylinderSpec>(s)->outer = outer,
    first_shape<CylinderSpec>(s)->height = height;
}
void torus(Scene& s) {
    add<SurfaceSpec>(s).shape = "(length(x, y) - 4)^2 + z^2 - 0.5", first_shape<SurfaceSpec>(s)->bound = 5;
}
void looks(Scene& s, double r, double theta) { s.camera.r = r, s.camera.theta = theta; }

const std::vector<KerrBodiesCase>& kerr_bodies_cases() {
    static const std::vector<KerrBodiesCase> all = {
        {"ball in front",
         [](Scene& s) {
             ball(s, {3, 1, 0.5}, 0.7);
         }},
        {"ball behind",
         [](Scene& s) {
             ball(s, {-4, 0.3, 0.2}, 1.0);
         }},
        {"ball next to the horizon, spin 0.998",
         [](Scene& s) {
             spin(s, 0.998), ball(s, {0.2, -1.0, 0}, 0.3);
         }},
        {"ball over the pole",
         [](Scene& s) {
             ball(s, {0, 0, 2}, 0.6);
         }},
        {"sphere outside of all photon orbits", [](Scene& s) { add<SphereSpec>(s).radius = 2.5; }},
        {"sphere next to the horizon", [](Scene& s) { spin(s, 0.998), add<SphereSpec>(s).radius = 0.6; }},
        {"thick disc", [](Scene& s) { thick_disc(s, 3, 6, 0.4); }},
        {"thick disc down to the horizon, spin 0.998", [](Scene& s) { spin(s, 0.998), thick_disc(s, 0.7, 4, 0.2); }},
        {"thin thick disc, from the side", [](Scene& s) { thick_disc(s, 3, 6, 0.05), looks(s, 15, 1.5); }},
        {"torus", torus},
        {"torus, from the axis", [](Scene& s) { torus(s), looks(s, 12, 0.01); }},
        {"ball before and behind a disc",
         [](Scene& s) {
             ball(s, {3, 0, 1.2}, 0.8), s.disc.emplace().inner = 2, s.disc->outer = 7;
         }},
        {"ball and thick disc, far camera",
         [](Scene& s) {
             ball(s, {-2, 2, 1}, 0.9), thick_disc(s, 4, 6, 0.2), looks(s, 500, 1.3), s.camera.plane_width = 0.03;
         }},
        {"orbiting ball, light delayed",
         [](Scene& s) {
             ball(s, {3, 0, 0}, 0.5), first_shape<BallSpec>(s)->motion = BallMotion::kOrbit, s.time = 40;
         }},
        {"pulsing sphere, light delayed",
         [](Scene& s) {
             add<SphereSpec>(s).radius = 2, first_shape<SphereSpec>(s)->amplitude = 0.2,
             first_shape<SphereSpec>(s)->period = 20, s.time = 3;
         }},
        {"boosted camera, ball",
         [](Scene& s) {
             ball(s, {3, 1, 0.5}, 2.0), s.camera.observer = ObserverKind::kZamo, s.camera.velocity = {0.3, 0.4, -0.2};
         }},
        {"falling camera, ball",
         [](Scene& s) {
             ball(s, {2.5, 1, 0.5}, 0.7), looks(s, 4, 1.3), s.camera.observer = ObserverKind::kRain;
         }},
        {"falling camera inside the horizon, ball",
         [](Scene& s) {
             ball(s, {2.5, 1, 0.5}, 0.9), looks(s, 0.6, 1.3), s.camera.observer = ObserverKind::kRain,
                                                              s.camera.yaw = M_PI;
         }},
        {"almost no spin",
         [](Scene& s) {
             spin(s, 1e-6), ball(s, {-3, 1, 0.5}, 0.7), thick_disc(s, 4, 6, 0.3);
         }},
    };
    return all;
}

TEST_CASE("kerr bodies: hits, places and fates are the reference's at every pixel" * test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        Selection selection(4);
        for (const KerrBodiesCase& c : kerr_bodies_cases()) {
            if (!selection.takes_next()) continue;
            const std::string name = c.name;
            CAPTURE(name);
            Scene scene;
            scene.spacetime = {"kerr", {{"spin", 0.9}}};
            scene.sky.kind = SkyKind::kBlack;
            scene.camera.width = kKerrBodiesWidth;
            scene.camera.height = kKerrBodiesHeight;
            looks(scene, 10, 1.3);
            c.set(scene);
            const RayFrame frame = gl_ray_data(session, scene);
            if (measured.known(name, frame)) continue;
            const RayMeasures m = measure_rays(frame, scene.camera, reference_trace(scene));
            fmt::print("{:<7} {:<45} screen {:.4f}, place {:.4f} px of 1080p; {} hits, fate errors {}, forgiven {}\n",
                       session.context->kind(), c.name, kOf1080 * m.sky_px.max, kOf1080 * m.place_px.max,
                       m.place_px.count, m.fate_errors, m.forgiven);
            CHECK(m.not_finite == 0);
            CHECK(m.fate_errors == 0);
            CHECK(m.place_px.count > 0);
            CHECK(kOf1080 * m.sky_px.max <= kKerrBodiesScreenError_px);
            CHECK(kOf1080 * m.place_px.max <= kKerrBodiesScreenError_px);
        }
    });
}

}  // namespace
