// Every method of tracing in its default form against the reference. The method tells where a ray goes; its verdict, escaped or
// captured, is the same for all, so no method may have a fate error.
#include "shaderlib/method.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

struct Bound {
    const char* method;
    double screen_px;  // largest over the cameras below
};

// Measured with llvmpipe where a pixel spans 1.8e-3 rad: 7.3e-4 px for the first three (single precision at the photon ring),
// 7.0e-3 px for the integrator, close to the horizon; times 2.7.
constexpr Bound kBounds[] = {{"strip", 0.002}, {"table", 0.002}, {"closed-form", 0.002}, {"integrate", 0.02}};

Scene camera_at(double r, double yaw) {
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.width = 640;
    scene.camera.height = 360;
    scene.camera.r = r;
    scene.camera.yaw = yaw;
    return scene;
}

TEST_CASE("method bounds: each stays within its screen error and none has a fate error" * test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        for (const auto& [r, yaw] : {std::pair{15.0, 0.0}, {3.0, 0.6}, {1.2, M_PI}}) {
            CAPTURE(r);
            const Scene scene = camera_at(r, yaw);
            const ExactTrace trace = remembered(reference_trace(scene));
            for (const Bound& bound : kBounds) {
                const std::string name = bound.method;
                CAPTURE(name);
                const auto method = parse_method(name);
                REQUIRE(static_cast<bool>(method));
                session.renderer->set_method(*method);
                const RayFrame frame = gl_ray_data(session, scene);
                if (measured.known(fmt::format("{} {}", name, r), frame)) continue;
                const RayMeasures m = measure_rays(frame, scene.camera, trace);
                fmt::print("{:<7} {:<12} r {:<4} screen {} px (max / 99.9 % / median), fate errors {}, forgiven {}\n",
                           session.context->kind(), name, r, spread_text(m.sky_px), m.fate_errors, m.forgiven);
                CHECK(m.sky_px.max <= bound.screen_px);
                CHECK(m.fate_errors == 0);
                CHECK(m.not_finite == 0);
            }
        }
    });
}

}  // namespace
