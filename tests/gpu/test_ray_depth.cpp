// Depths of layers against the reference: its own affine parameter, or the integral of r^2 dphi along its closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observer/pose.h"
#include "reference/frame_tracer.h"
#include "reference/kerr_launch.h"
#include "reference/plane_ray.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kDepthError = 1e-4;  // r_s, and of the depth: floats, and quadrature between the table's places
constexpr double kPlaceError_px = 0.01;

// The reference's parameter where a ray about a rotating hole begins: it is 0 abreast of the hole.
double at_camera(const Scene& scene, double x, double y) {
    const CameraSpec& camera = scene.camera;
    REQUIRE(camera.observer == ObserverKind::kZamo);
    REQUIRE(length(camera.velocity) == 0.0);
    const reference::KerrChart chart{
        {scene.spacetime.parameters.at("spin"),
         scene.spacetime.parameters.contains("charge") ? scene.spacetime.parameters.at("charge") : 0.0}};
    const Vec3 direction = normalized(static_from_camera(camera) * pixel_direction(camera, x, y));
    return way_from_abreast(chart, kerr_launch(chart, {camera.r, camera.theta, camera.phi, direction}));
}

// Simpson's rule.
double affine_depth(const Scene& scene, double x, double y, const reference::TracedRay& ray, double along) {
    const reference::PlaneRay* plane = ray.in_plane();
    if (plane == nullptr) return along - at_camera(scene, x, y);
    constexpr int kParts = 400;
    double sum = 0;
    for (int i = 0; i <= kParts; ++i) {
        const double r = plane->radius_at(along * i / kParts);
        sum += r * r * (i == 0 || i == kParts ? 1 : i % 2 == 1 ? 4 : 2);
    }
    return ray.shift.gravity * ray.shift.doppler / plane->photon().l * sum * along / kParts / 3;
}

TEST_CASE("ray depth: the affine parameter to discs and bodies is the reference's") {
    constexpr const char* kScenes[] = {"first-light", "gargantua", "kerr",    "passing-ball", "kerr-planet",
                                       "accretion",   "plunge",    "luminet", "hot-spot",     "kerr-newman"};
    on_one_context([&](GpuSession& session) {
        Selection selection(4);
        for (const char* name : kScenes) {
            if (!selection.takes_next()) continue;
            auto scene = load_scene(name);
            REQUIRE_MESSAGE(scene, name);
            scene->camera.width = 96, scene->camera.height = 54;
            session.renderer->want_delays(true);
            REQUIRE(session.renderer->prepare(*scene));
            const RayFrame rays = session.renderer->ray_data();
            const Renderer::RayDepths depths = session.renderer->ray_depths();
            const auto tracer = reference::FrameTracer::make(*scene);
            REQUIRE(tracer);
            int count = 0;
            double worst = 0;
            for (int y = 0; y < rays.height; y += 3)
                for (int x = 0; x < rays.width; x += 3) {
                    const RayPixel& pixel = rays.at(x, y);
                    if (pixel.hit == 0) continue;
                    const auto depth_at = [&](double across) {
                        const reference::RayPtr ray = tracer->ray(x + 0.5 + across, y + 0.5);
                        double along = kNotANumber;
                        if (pixel.hit == kDiscHit) {
                            const auto hits = tracer->disc_hits(*ray, 1);
                            if (!hits.empty()) along = hits.front().along;
                        } else if (const auto body = ray->first_hit()) {
                            along = body->along;
                        }
                        return affine_depth(*scene, x + 0.5 + across, y + 0.5, *ray, along);
                    };
                    const double exact = depth_at(0.0), off = depths.depth[rays.index(x, y)] - exact;
                    if (!std::isfinite(exact)) continue;  // at a rim
                    // In thin images of the disc a depth is as exact as the place in the picture.
                    const double beside = std::abs(depth_at(kPlaceError_px) - exact);
                    worst = std::max(worst, std::max(0.0, std::abs(off) - (std::isfinite(beside) ? beside : 0.0)) /
                                                std::max(1.0, exact));
                    ++count;
                }
            fmt::print("{:<13} {} depths, off by {:.1e} at most\n", name, count, worst);
            CHECK(count > 20);
            CHECK(worst < kDepthError);
        }
    });
}

}  // namespace
