// Point stars about a spinning hole: the images that the mesh of rays finds, and their light in the picture, against the reference's,
// which Newton's steps on its own rays settle; next to no spin against the images of a hole without.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "base/assets.h"
#include "reference/frame_tracer.h"
#include "reference/star_images.h"
#include "render/frame_tables.h"
#include "render/star_mesh.h"
#include "sky/point_stars.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kPlace_px = 0.05;       // the promise for any image
constexpr double kLight = 0.01;
constexpr double kWorthIt = 1e-3;        // of its star's own light: dimmer images may be off or missing

Scene star_scene(double spin, double r, double theta, int stars) {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", spin}}};
    scene.camera.observer = ObserverKind::kZamo;
    scene.camera.r = r, scene.camera.theta = theta;
    scene.camera.width = 96, scene.camera.height = 64;
    scene.camera.plane_width = 1.4;
    scene.sky.kind = SkyKind::kPoints;
    scene.sky.even_stars = stars;
    scene.sky.faintest = 0.0;
    return scene;
}

struct View {
    const char* name;
    Scene scene;
};

std::vector<View> views() {
    std::vector<View> list{{"zamo, a = 0.95", star_scene(0.95, 12, 1.2, 150)}, {"moving, a = 0.998", star_scene(0.998, 5, 1.5, 150)}, {"rain, a = 0.6", star_scene(0.6, 7, 0.6, 150)}};
    list[1].scene.camera.velocity = {0.1, 0.2, -0.4}, list[1].scene.camera.yaw = 0.3;
    list[2].scene.camera.observer = ObserverKind::kRain;
    return list;
}

double own_area(const Scene& scene, double x, double y) {
    const double pixel = scene.camera.plane_width / scene.camera.width, u = x * pixel, v = y * pixel;
    return pixel * pixel / std::pow(1 + u * u + v * v, 1.5);
}

struct Both {
    std::optional<reference::FrameTracer> tracer;
    std::vector<PointStar> stars;
    std::vector<std::vector<reference::StarImage>> exact;   // by star
    std::vector<MeshImage> mesh;
};

Both both_of(const Scene& scene) {
    Both both;
    const auto stars = point_stars(scene.sky, assets_directory());
    REQUIRE(stars);
    both.stars = *stars;
    auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    both.tracer = std::move(*tracer);
    const auto images = reference::images_of(*both.tracer, scene);
    for (const PointStar& star : both.stars) both.exact.push_back(images(star.direction));
    FrameTables tables;
    REQUIRE(tables.update(scene));
    const StarMesh mesh(both.stars, false);
    both.mesh = mesh.images(tables.core_input(scene), scene.camera.width, scene.camera.height, kPointMargin_px, {true, true, -1e9});
    return both;
}

TEST_CASE("kerr point stars: every image worth a thousandth of its star is the reference's, place, area and g") {
    for (const View& view : views()) {
        CAPTURE(view.name);
        const Scene& scene = view.scene;
        const Both both = both_of(scene);
        const double middle_x = 0.5 * scene.camera.width, middle_y = 0.5 * scene.camera.height;
        int found = 0, magnified = 0, more = 0;
        double place = 0, area = 0, g = 0;
        for (std::size_t i = 0; i < both.stars.size(); ++i)
            for (const auto& one : both.exact[i]) {
                const double x = one.x - middle_x, y = middle_y - one.y, worth = own_area(scene, x, y) / one.solid_angle;
                if (std::fabs(x) > middle_x + kPointMargin_px - 1 || std::fabs(y) > middle_y + kPointMargin_px - 1) continue;
                const MeshImage* best = nullptr;
                for (const MeshImage& image : both.mesh)
                    if (image.star == static_cast<int>(i) && (best == nullptr || std::hypot(image.x - x, image.y - y) < std::hypot(best->x - x, best->y - y))) best = &image;
                const double off = best == nullptr ? 1e9 : std::hypot(best->x - x, best->y - y);
                if (worth < kWorthIt) {
                    more += off < kPlace_px;
                    continue;
                }
                CAPTURE(x);
                CAPTURE(y);
                CAPTURE(worth);
                CHECK(off <= kPlace_px);
                if (off > kPlace_px) continue;
                CHECK(std::fabs(best->area / one.solid_angle - 1) <= kLight);
                ++found, magnified += worth > 1;
                place = std::max(place, off), area = std::max(area, std::fabs(best->area / one.solid_angle - 1)), g = std::max(g, std::fabs(best->g / one.g - 1));
            }
        CHECK(g <= 1e-3);
        CHECK(found > 60);
        int invented = 0, closer = 0;
        for (const MeshImage& image : both.mesh) {
            double off = 1e9;
            for (const auto& one : both.exact[static_cast<std::size_t>(image.star)]) off = std::min(off, std::hypot(one.x - middle_x - image.x, middle_y - one.y - image.y));
            if (off <= kPlace_px || own_area(scene, image.x, image.y) / image.area < kWorthIt) continue;
            // The reference has not looked so close to the shadow: is its ray there the star's?
            const auto ray = both.tracer->ray(middle_x + image.x, middle_y - image.y);
            if (ray.fate() == Fate::kEscaped && length(ray.end() - both.stars[static_cast<std::size_t>(image.star)].direction) <= kPlace_px * std::sqrt(image.area)) ++closer;
            else ++invented;
        }
        CHECK(invented == 0);
        fmt::print("{}: {} images ({} brighter than their star; besides {} dimmer than {} and {} at the shadow), off by {:.2g} px, area {:.2g}, g {:.2g} at most\n", view.name, found, magnified,
                   more, kWorthIt, closer, place, area, g);
    }
}

}  // namespace
