// Bodies on both sides of a wormhole: every pixel of many small frames against the reference, which finds them along its own orbits.
#include <cmath>
#include <functional>
#include <vector>

#include "scene/bodies.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kSidesScreenError_px = 0.05;  // the project's promise

struct SidesCase {
    const char* name;
    std::function<void(Scene&)> set;
};

void film(Scene& s, double length = 0.01, double width = 0.05) {
    s.spacetime = {"dneg-wormhole", {{"throat", 1.0}, {"length", length}, {"lensing_width", width}}};
}
void near_ball(Scene& s) { add<BallSpec>(s).position = {4, 2, -0.5}, first_shape<BallSpec>(s)->radius = 1; }
void far_ball(Scene& s, Vec3 at = {-4, 1, 0.5}) {
    add<BallSpec>(s).position = at, first_shape<BallSpec>(s)->radius = 1.5, first_body<BallSpec>(s)->far = true;
}
void far_ring(Scene& s) {
    add<CylinderSpec>(s).inner = 2, first_shape<CylinderSpec>(s)->outer = 4, first_shape<CylinderSpec>(s)->height = 0.3,
    first_body<CylinderSpec>(s)->far = true;
}

const std::vector<SidesCase>& sides_cases() {
    static const std::vector<SidesCase> all = {
        {"ellis: ball near", near_ball},
        {"ellis: ball behind the throat, near",
         [](Scene& s) {
             add<BallSpec>(s).position = {-4, 0.3, 0}, first_shape<BallSpec>(s)->radius = 1.5;
         }},
        {"ellis: ball far, behind", [](Scene& s) { far_ball(s); }},
        {"ellis: ball far, in front",
         [](Scene& s) {
             far_ball(s, {5, 1, 0});
         }},
        {"ellis: ball far, next to the throat",
         [](Scene& s) {
             far_ball(s, {-1.6, 0, 0.2});
         }},
        {"ellis: ring far", far_ring},
        {"ellis: ring near, ball far",
         [](Scene& s) {
             far_ball(s), add<CylinderSpec>(s).inner = 2, first_shape<CylinderSpec>(s)->outer = 3,
                          first_shape<CylinderSpec>(s)->height = 0.2;
         }},
        {"ellis: ball near, surface far",
         [](Scene& s) {
             near_ball(s), add<SurfaceSpec>(s).shape = "length(x + 4, y, z) - 1.5",
                           first_shape<SurfaceSpec>(s)->bound = 6, first_body<SurfaceSpec>(s)->far = true;
         }},
        {"ellis: camera far, ball near", [](Scene& s) { near_ball(s), s.camera.r = -5, s.camera.yaw = M_PI; }},
        {"ellis: camera in the throat, ball far",
         [](Scene& s) {
             far_ball(s, {5, 1, 0}), s.camera.r = 0;
         }},
        {"ellis: camera in the throat, ball near", [](Scene& s) { near_ball(s), s.camera.r = 0, s.camera.yaw = M_PI; }},
        {"ellis: ball far, fast camera",
         [](Scene& s) {
             far_ball(s), s.camera.velocity = {0.3, 0.2, 0.1};
         }},
        {"ellis: wide throat, ball far",
         [](Scene& s) {
             s.spacetime.parameters = {{"throat", 5.0}}, far_ball(s, {-12, 2, 1}), s.camera.r = 20;
         }},
        {"film's: ball near", [](Scene& s) { film(s), near_ball(s); }},
        {"film's: ball far", [](Scene& s) { film(s), far_ball(s); }},
        {"film's: ring far, ball near", [](Scene& s) { film(s), near_ball(s), far_ring(s); }},
        {"film's: camera in the tube, ball far",
         [](Scene& s) {
             film(s), far_ball(s, {5, 1, 0}), s.camera.r = 0.001;
         }},
        {"longest tube, widest lens: ball far", [](Scene& s) { film(s, 0.5, 2.0), far_ball(s); }},
        {"no tube, narrowest lens: ball far",
         [](Scene& s) {
             film(s, 0, 0.02), far_ball(s, {5, 1, 0}), s.camera.r = 4;
         }},
    };
    return all;
}

TEST_CASE("sides: hits, places and fates are the reference's at every pixel" * test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        Selection selection(12);  // none of the film's wormhole, whose table takes ten seconds: unit tests have it
        for (const SidesCase& c : sides_cases()) {
            if (!selection.takes_next()) continue;
            const std::string name = c.name;
            CAPTURE(name);
            Scene scene;
            scene.spacetime.metric = "ellis";
            scene.sky.kind = scene.far_sky.kind = SkyKind::kBlack;
            scene.camera.r = 8;
            scene.camera.width = 97;
            scene.camera.height = 55;
            c.set(scene);
            if (scene.spacetime.metric != "ellis")
                scene.camera.width = by_depth(27, 43, 65),
                scene.camera.height = by_depth(17, 25, 37);  // the reference takes milliseconds a ray
            const RayFrame frame = gl_ray_data(session, scene);
            if (measured.known(name, frame)) continue;
            const RayMeasures m = measure_rays(frame, scene.camera, reference_trace(scene));
            fmt::print(
                "{:<7} {:<40} screen {:.1e}, place {:.1e}, swept {:.1e} px; {} hits, fate errors {}, forgiven {}\n",
                session.context->kind(), c.name, m.sky_px.max, m.place_px.max, m.angle_px.max, m.place_px.count,
                m.fate_errors, m.forgiven);
            CHECK(m.not_finite == 0);
            CHECK(m.fate_errors == 0);
            CHECK(m.place_px.count > 0);
            CHECK(m.sky_px.max <= kSidesScreenError_px);
            CHECK(m.place_px.max <= kSidesScreenError_px);
            CHECK(m.angle_px.max <= kSidesScreenError_px);
        }
    });
}

}  // namespace
