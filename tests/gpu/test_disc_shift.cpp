// The frequency ratio g of the disc's light as the GPU draws it: bolometric brightness is g^4 of what it is without beaming.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Scene bolometric_scene(double r, double theta_deg) {
    Scene scene;
    scene.camera.r = r;
    scene.camera.theta = theta_deg * M_PI / 180;
    scene.camera.width = 640;
    scene.camera.height = 360;
    scene.camera.focal_distance = 1;
    scene.camera.plane_width = 2 * 16 / r;
    scene.sky.kind = SkyKind::kBlack;
    DiscSpec& disc = scene.disc.emplace();
    disc.emission = DiscEmission::kThermal;
    disc.inner = 1.4;   // matter falls inside of 3 r_s, and shines no more
    disc.outer = 14;
    scene.light.bolometric = true;
    return scene;
}

TEST_CASE("disc: g as the GPU draws it is the reference's") {
    constexpr double kTolerance = 1e-5;   // what the project promises
    on_every_context([&](GpuSession& session) {
        double worst = 0;
        int pixels = 0;
        for (const double theta : {5.0, 60.0, 80.0, 120.0})
            for (const Vec3 velocity : {Vec3{0, 0, 0}, Vec3{0.2, 0.3, -0.1}}) {
                Scene scene = bolometric_scene(40, theta);
                scene.camera.velocity = velocity;
                REQUIRE(session.renderer->prepare(scene));
                const Image<float> picture = session.renderer->picture();
                Scene unbeamed = scene;
                unbeamed.light.beaming = false;
                REQUIRE(session.renderer->prepare(unbeamed));
                const Image<float> own = session.renderer->picture();
                const auto tracer = reference::FrameTracer::make(scene);
                REQUIRE(tracer);
                const reference::DiscLight light(tracer->metric(), *scene.disc, scene.light);
                std::mt19937 random(3);
                for (int i = 0; i < 1500; ++i) {
                    const int x = static_cast<int>(random() % 640), y = static_cast<int>(random() % 360);
                    const reference::CameraRay ray = tracer->ray(x + 0.5, y + 0.5);
                    const auto hits = tracer->disc_hits(ray, 1);
                    if (hits.empty()) continue;
                    const double r = std::hypot(hits[0].x, hits[0].y);
                    if (r < 3.05 || r > 13.9) continue;   // dark; the rim
                    bool whole = true;                   // no rim within the pixel
                    for (const auto& [dx, dy] : {std::pair{-1.5, 0.0}, {1.5, 0.0}, {0.0, -1.5}, {0.0, 1.5}}) {
                        const auto beside = tracer->disc_hits(tracer->ray(x + 0.5 + dx, y + 0.5 + dy), 1);
                        whole = whole && !beside.empty() && std::abs(beside[0].angle - hits[0].angle) < 0.3;
                    }
                    if (!whole) continue;
                    const double expected = ray.g * light.g_infinity({r, ray.l_z, hits[0].outward, ray.l2});
                    const auto brightness = [&](const Image<float>& image) {
                        const float* p = image.at(x, y);
                        return 0.2126390059 * p[0] + 0.7151686788 * p[1] + 0.0721923154 * p[2];
                    };
                    const double found = std::pow(brightness(picture) / brightness(own), 0.25), error = std::abs(found / expected - 1);
                    CAPTURE(theta);
                    CAPTURE(r);
                    CAPTURE(x);
                    CAPTURE(y);
                    CHECK(error <= kTolerance);
                    worst = std::max(worst, error);
                    ++pixels;
                }
            }
        fmt::print("g of the disc in {} pixels: within {:.2g} of the reference's\n", pixels, worst);
        CHECK(pixels > 500);
    });
}

}  // namespace
