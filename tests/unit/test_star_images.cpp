// Images of point stars as the reference finds them: their rays end at the star, and their light is the Jacobian of the frame's ray map.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/frame_tracer.h"
#include "reference/star_images.h"
#include "scene/scene.h"

using namespace nullscope;

namespace {

// By differences of eighth order.
Vec3 slope_of(const reference::FrameTracer& tracer, double x, double y, double dx, double dy) {
    constexpr std::array<double, 4> kWeights{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    Vec3 sum{0, 0, 0};
    for (int n = 1; n <= 4; ++n)
        sum = sum + kWeights[static_cast<std::size_t>(n - 1)] * (tracer.ray(x + n * dx, y + n * dy)->end_direction() -
                                                                 tracer.ray(x - n * dx, y - n * dy)->end_direction());
    return sum / std::hypot(dx, dy);
}

Scene stars_about(const std::string& metric, const std::string& formula, double r, ObserverKind observer) {
    Scene scene;
    scene.spacetime.metric = metric;
    if (!formula.empty()) scene.spacetime.parameters.formulas["A"] = formula;
    scene.sky.kind = SkyKind::kPoints;
    scene.camera.r = r, scene.camera.theta = 1.4, scene.camera.phi = 0.3;
    scene.camera.width = 2048, scene.camera.height = 2048;
    scene.camera.observer = observer;
    return scene;
}

}  // namespace

TEST_CASE("star images: their rays end at the star, and each has the light of the ray map there") {
    constexpr double kPlace_px = 1e-9, kLight = 1e-7;
    struct Case {
        std::string metric, formula;
        double r;
        ObserverKind observer;
    };
    for (const Case& c : {Case{"schwarzschild", "", 30, ObserverKind::kStatic},
                          {"schwarzschild", "", 4, ObserverKind::kFall},
                          {"reissner-nordstrom", "", 12, ObserverKind::kStatic},
                          {"formula", "1 - r^2/(r^3 + 0.35^2)", 20, ObserverKind::kStatic}}) {
        CAPTURE(c.metric);
        const Scene scene = stars_about(c.metric, c.formula, c.r, c.observer);
        const auto tracer = reference::FrameTracer::make(scene);
        REQUIRE_MESSAGE(tracer, tracer.error().message());
        const reference::StarImages images(*tracer, scene, 4);
        std::array<int, 4> found{};
        double place = 0, light = 0;
        for (int i = 0; i < 60; ++i) {
            const double z = -0.97 + 0.0328 * i, angle = 2.4 * i, across = std::sqrt(1 - z * z);
            const Vec3 star{across * std::cos(angle), across * std::sin(angle), z};
            for (const reference::StarImage& image : images.of(star, 0)) {
                const double step = 1e-3 * std::exp(-2.0 * image.order);  // px: images crowd at the shadow's edge
                const Vec3 by_x = slope_of(*tracer, image.x, image.y, step, 0),
                           by_y = slope_of(*tracer, image.x, image.y, 0, step);
                const double most = std::max(length(by_x), length(by_y));
                ++found[static_cast<std::size_t>(image.order)];
                place = std::max(place, length(tracer->ray(image.x, image.y)->end_direction() - star) / most);
                if (image.order < 2)
                    light = std::max(light, std::abs(image.solid_angle / length(cross(by_x, by_y)) - 1));
            }
        }
        fmt::print("star images, {} from r = {}: {}, {}, {}, {}; off by {:.1e} px, light by {:.1e}\n", c.metric, c.r,
                   found[0], found[1], found[2], found[3], place, light);
        CHECK(place < kPlace_px);
        CHECK(light < kLight);
        CHECK(found[1] + found[2] + found[3] > 100);
    }
}
