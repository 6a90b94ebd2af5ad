// Depths of layers against the reference: the integral of r^2 dphi along its closed forms, or of |x|^2 along its steps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observer/pose.h"
#include "reference/frame_tracer.h"
#include "reference/kerr_ray.h"
#include "reference/plane_ray.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kDepthError = 1e-4;  // r_s, and of the depth: floats, and quadrature between the table's places
constexpr double kPlaceError_px = 0.01;

// Simpson's rule; value(part) of [0, 1].
template <class Value>
double mean(int parts, const Value& value) {
    double sum = 0;
    for (int i = 0; i <= parts; ++i)
        sum += value(static_cast<double>(i) / parts) * (i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2);
    return sum / parts / 3;
}

// About a rotating hole: the ray once more, and the square of the distance along its own parameter.
double integrated_depth(const Scene& scene, double x, double y, double along) {
    const CameraSpec& camera = scene.camera;
    REQUIRE(camera.observer == ObserverKind::kZamo);
    REQUIRE(length(camera.velocity) == 0.0);
    const auto& parameters = scene.spacetime.parameters;
    const reference::KerrHole hole(parameters.at("spin"),
                                   parameters.contains("charge") ? parameters.at("charge") : 0.0);
    const Vec3 direction = normalized(static_from_camera(camera) * pixel_direction(camera, x, y));
    double depth = 0;
    reference::trace_kerr(
        hole, {camera.r, camera.theta, camera.phi, direction}, 0, [&](const reference::KerrStep& step) {
            const double width = std::min(step.to, along) - step.from;
            if (!(width > 0)) return;
            depth += width * mean(20, [&](double part) {
                         const reference::KerrPlace place = step.at(step.from + part * width);
                         return std::pow(reference::kerr_distance(hole, place.r, std::sin(place.theta)), 2);
                     });
        });
    return std::isfinite(along) ? depth : kNotANumber;
}

double affine_depth(const Scene& scene, double x, double y, const reference::TracedRay& ray, double along) {
    const reference::PlaneRay* plane = ray.in_plane();
    if (plane == nullptr) return integrated_depth(scene, x, y, along);
    return ray.shift.gravity * ray.shift.doppler / plane->photon().l * along *
           mean(400, [&](double part) { return std::pow(plane->radius_at(along * part), 2); });
}

TEST_CASE("ray depth: the affine parameter to discs and bodies is the reference's" * test::costly()) {
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
