// Point stars about a rotating hole: the images that the mesh of rays finds, and their light in the picture, against the reference's,
// which Newton's steps on its own rays settle; next to no spin against the images of a hole without.
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
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

constexpr double kPlace_px = 0.05;  // the promise for any image
constexpr double kLight = 0.01;
constexpr double kWorthIt = 1e-3;  // of its star's own light: dimmer images may be off or missing

Scene star_scene(double spin, double r, double theta, int stars) {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", spin}}};
    scene.camera.observer = ObserverKind::kZamo;
    scene.camera.r = r, scene.camera.theta = theta;
    scene.camera.width = 96, scene.camera.height = 64;
    scene.camera.plane_width = 1.4;
    scene.sky.kind = SkyKind::kPoints;
    scene.sky.uniform_stars = stars;
    scene.sky.magnitude_limit = -5.0;
    return scene;
}

struct KerrStarsView {
    const char* name;
    Scene scene;
};

std::vector<KerrStarsView> views() {
    std::vector<KerrStarsView> list{{"zamo, a = 0.95", star_scene(0.95, 12, 1.2, 150)},
                                    {"moving, a = 0.998", star_scene(0.998, 5, 1.5, 150)},
                                    {"rain, a = 0.6", star_scene(0.6, 7, 0.6, 150)}};
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
    std::vector<std::vector<reference::StarImage>> exact;  // by star
    std::vector<MeshImage> mesh;
};

constexpr double kQuickOff_px = 1.0;    // an image that is farther off is not found
constexpr double kQuickPart = 1.0 / 4;  // of the whole search's time; measured 1/5.8
constexpr double kQuickOverRays = 8.0;  // of what its rays alone take; measured 4, the whole search 25

// By star.
std::vector<std::vector<reference::StarImage>> exact_images(const reference::FrameTracer& tracer, const Scene& scene,
                                                            const std::vector<PointStar>& stars) {
    struct Found {
        std::size_t star;
        reference::StarImage image;
    };
    const auto found = ReferenceMemory::of_this_run().answer<Found>(question_of("images of stars", scene), [&] {
        std::vector<Found> all;
        const auto images = reference::images_of(tracer, scene);
        for (std::size_t i = 0; i < stars.size(); ++i)
            for (const auto& image : images(stars[i].direction)) all.push_back({i, image});
        return all;
    });
    std::vector<std::vector<reference::StarImage>> images(stars.size());
    for (const Found& one : found) images[one.star].push_back(one.image);
    return images;
}

Both both_of(const Scene& scene) {
    Both both;
    const auto stars = point_stars(scene.sky, assets_directory());
    REQUIRE(stars);
    both.stars = *stars;
    auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    both.tracer = std::move(*tracer);
    both.exact = exact_images(*both.tracer, scene, both.stars);
    FrameTables tables;
    REQUIRE(tables.update(scene));
    const StarMesh mesh(both.stars, false);
    both.mesh = mesh.images(tables.core_input(), mesh_area(scene.camera, kPointMargin_px), {true, true, -1e9});
    return both;
}

// Computed once for both tests: some seconds a view.
const Both& both_of_view(std::size_t i) {
    static std::array<std::optional<Both>, 3> known;
    if (!known[i]) known[i] = both_of(views()[i].scene);
    return *known[i];
}

TEST_CASE("kerr point stars: every image worth a thousandth of its star is the reference's, place, area and g" *
          test::costly()) {
    const std::vector<KerrStarsView> all = views();
    const std::size_t measured = by_depth(std::size_t{1}, all.size(), all.size());
    for (std::size_t v = 0; v < measured; ++v) {
        const KerrStarsView& view = all[v];
        CAPTURE(std::string(view.name));
        const Scene& scene = view.scene;
        const Both& both = both_of_view(v);
        const double middle_x = 0.5 * scene.camera.width, middle_y = 0.5 * scene.camera.height;
        int found = 0, magnified = 0, more = 0;
        double place = 0, area = 0, g = 0;
        for (std::size_t i = 0; i < both.stars.size(); ++i)
            for (const auto& one : both.exact[i]) {
                const double x = one.x - middle_x, y = middle_y - one.y,
                             worth = own_area(scene, x, y) / one.solid_angle;
                if (std::fabs(x) > middle_x + kPointMargin_px - 1 || std::fabs(y) > middle_y + kPointMargin_px - 1)
                    continue;
                const MeshImage* best = nullptr;
                for (const MeshImage& image : both.mesh)
                    if (image.star == static_cast<int>(i) &&
                        (best == nullptr ||
                         std::hypot(image.x - x, image.y - y) < std::hypot(best->x - x, best->y - y)))
                        best = &image;
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
                place = std::max(place, off), area = std::max(area, std::fabs(best->area / one.solid_angle - 1)),
                g = std::max(g, std::fabs(best->g / one.g - 1));
            }
        CHECK(g <= 1e-3);
        CHECK(found > 60);
        int invented = 0, closer = 0;
        for (const MeshImage& image : both.mesh) {
            double off = 1e9;
            for (const auto& one : both.exact[static_cast<std::size_t>(image.star)])
                off = std::min(off, std::hypot(one.x - middle_x - image.x, middle_y - one.y - image.y));
            if (off <= kPlace_px || own_area(scene, image.x, image.y) / image.area < kWorthIt) continue;
            // The reference has not looked so close to the shadow: is its ray there the star's?
            const auto ray = both.tracer->ray(middle_x + image.x, middle_y - image.y);
            if (ray->fate() == Fate::kEscaped &&
                length(ray->end_direction() - both.stars[static_cast<std::size_t>(image.star)].direction) <=
                    kPlace_px * std::sqrt(image.area))
                ++closer;
            else
                ++invented;
        }
        CHECK(invented == 0);
        fmt::print(
            "{}: {} images ({} brighter than their star; besides {} dimmer than {} and {} at the shadow), off by "
            "{:.2g} px, area {:.2g}, g {:.2g} at most\n",
            view.name, found, magnified, more, kWorthIt, closer, place, area, g);
    }
}

struct Spot {
    double x, y;       // px: column, row from the top
    double light;      // green
    double worth = 0;  // over its star's own
};

// Of the light above nothing in the square of pixels about a place: its sum and its middle.
Spot spot_about(const Image<float>& picture, double x, double y, int reach) {
    Spot spot{};
    for (int row = static_cast<int>(y) - reach; row <= static_cast<int>(y) + reach; ++row)
        for (int column = static_cast<int>(x) - reach; column <= static_cast<int>(x) + reach; ++column) {
            const double light = picture.at(column, row)[1];
            spot.light += light, spot.x += light * (column + 0.5), spot.y += light * (row + 0.5);
        }
    return {spot.x / spot.light, spot.y / spot.light, spot.light, 0};
}

// Their green light as sky/point_stars.h spreads it.
Image<float> painted(const std::vector<Spot>& spots, int width, int height) {
    Image<float> picture(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (const Spot& one : spots) {
                const double dx = x + 0.5 - one.x, dy = y + 0.5 - one.y;
                sum +=
                    one.light * point_peak() * std::exp(-(dx * dx + dy * dy) / (2 * kPointSigma_px * kPointSigma_px));
            }
            picture.at(x, y)[1] = static_cast<float>(sum);
        }
    return picture;
}

TEST_CASE(
    "kerr point stars: in the picture every image has the reference's light and place, and every pixel its light") {
    constexpr int kReach = 4;
    // Of its star's light: beside dimmer ones, at the shadow, there are others that no witness has found.
    constexpr double kShown = 0.1;
    const std::vector<KerrStarsView> all = views();
    on_one_context([&](GpuSession& session) {
        int found = 0;
        double light = 0, place = 0, whole = 0;
        const std::size_t measured = by_depth(std::size_t{1}, all.size(), all.size());
        for (std::size_t v = 0; v < measured; ++v) {
            CAPTURE(std::string(all[v].name));
            Scene scene = all[v].scene;
            const Both& both = both_of_view(v);
            const Image<float> picture = picture_of(session, scene);
            const double middle_x = 0.5 * picture.width, middle_y = 0.5 * picture.height;
            std::vector<Spot> spots;
            for (std::size_t i = 0; i < both.stars.size(); ++i)
                for (const auto& image : both.exact[i])
                    spots.push_back({image.x, image.y,
                                     reference::star_light(both.stars[i], image.g, scene.light).y / image.solid_angle,
                                     own_area(scene, image.x - middle_x, image.y - middle_y) / image.solid_angle});
            const Image<float> exact = painted(spots, picture.width, picture.height);
            double sum = 0, difference = 0;
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x)
                    sum += exact.at(x, y)[1], difference += std::fabs(picture.at(x, y)[1] - exact.at(x, y)[1]);
            whole = std::max(whole, difference / sum);
            for (const Spot& one : spots) {
                if (!(one.worth > kShown && one.x > kReach + 1 && one.y > kReach + 1 &&
                      one.x < picture.width - kReach - 1 && one.y < picture.height - kReach - 1))
                    continue;
                CAPTURE(one.x);
                CAPTURE(one.y);
                CAPTURE(one.light);
                const Spot here = spot_about(picture, one.x, one.y, kReach),
                           there = spot_about(exact, one.x, one.y, kReach);
                const double off = std::hypot(here.x - there.x, here.y - there.y),
                             error = std::fabs(here.light / there.light - 1);
                CHECK(error <= kLight);
                CHECK(off <= kPlace_px);
                ++found, light = std::max(light, error), place = std::max(place, off);
            }
        }
        fmt::print(
            "{}: about {} images light within {:.2g}, its middle {:.2g} px; pixel by pixel {:.2g} of a picture's "
            "light\n",
            session.context->kind(), found, light, place, whole);
        CHECK(found > 7 * static_cast<int>(measured));
        CHECK(whole <= kLight);
    });
}

TEST_CASE("kerr point stars: next to no spin they are those of a hole without, which a lens in one dimension places" *
          test::costly()) {
    // Of the light, pixel by pixel: images within a tenth of a pixel of the ring, and beside the shadow.
    constexpr double kMean = 0.01;
    on_one_context([&](GpuSession& session) {
        Scene scene = star_scene(0, 12, 1.2, 2000);
        scene.camera.observer = ObserverKind::kStatic;
        scene.camera.width = 320, scene.camera.height = 200;
        scene.sky.magnitude_limit = 4.0;
        REQUIRE(session.renderer->prepare(scene));
        CHECK(session.renderer->tables().effects().contains(Effect::kLensing));
        const Image<float> without = session.renderer->picture();
        const auto difference = [&](const Image<float>& with) {
            double off = 0, sum = 0;
            for (std::size_t i = 0; i < with.data.size(); ++i)
                off += std::fabs(with.data[i] - without.data[i]), sum += without.data[i];
            return off / sum;
        };
        scene.spacetime.parameters["spin"] = 1e-9;
        REQUIRE(session.renderer->prepare(scene));
        CHECK(session.renderer->tables().effects().contains(Effect::kSpin));
        const double mean = difference(session.renderer->picture());
        fmt::print("{}: pixels of 2000 stars differ by {:.2g} of their light\n", session.context->kind(), mean);
        CHECK(mean <= kMean);
        scene.camera.yaw = 0.1 * scene.camera.plane_width / scene.camera.width;  // a tenth of a pixel is seen
        REQUIRE(session.renderer->prepare(scene));
        CHECK(difference(session.renderer->picture()) > kMean);
    });
}

Scene all_stars() {
    Scene scene = star_scene(0.95, 15, 1.48, 0);
    scene.camera.width = 1280, scene.camera.height = 720;
    scene.sky.magnitude_limit = 20.0;
    scene.sky.brightness =
        0.4 / 3.0;  // what the bounds below were measured with: fainter images are searched less well
    return scene;
}

TEST_CASE("kerr point stars: the whole catalogue's images, the same every time" * test::costly()) {
    const Scene scene = all_stars();
    const auto stars = point_stars(scene.sky, assets_directory());
    REQUIRE(stars);
    FrameTables tables;
    REQUIRE(tables.update(scene));
    const CoreInput input = tables.core_input();
    const StarMesh mesh(*stars, false);
    const StarMesh::Seeing seeing{true, true, std::log2(kFaintestPoint / point_peak())};
    const auto start = std::chrono::steady_clock::now();
    const auto images = mesh.images(input, mesh_area(scene.camera, kPointMargin_px), seeing);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{} images of {} stars in {:.2f} s\n", images.size(), stars->size(), seconds);
    CHECK(images.size() > 10000);
    const auto again = mesh.images(input, mesh_area(scene.camera, kPointMargin_px), seeing);
    REQUIRE(again.size() == images.size());
    bool same = true;
    for (std::size_t i = 0; i < images.size(); ++i)
        same = same && again[i].star == images[i].star && again[i].x == images[i].x && again[i].y == images[i].y &&
               again[i].area == images[i].area;
    CHECK(same);
}

// What a camera in flight shows of a new view until the whole search has ended.
TEST_CASE(
    "kerr point stars: a quick search takes a fifth of the time and finds nearly all, and a search can be given up" *
    test::costly()) {
    const Scene scene = all_stars();
    const auto stars = point_stars(scene.sky, assets_directory());
    REQUIRE(stars);
    FrameTables tables;
    REQUIRE(tables.update(scene));
    const CoreInput input = tables.core_input();
    const StarMesh mesh(*stars, false);
    const auto search = [&](bool quick, const std::function<bool()>& give_up) {
        const std::clock_t start = std::clock();
        auto images = mesh.images(input, mesh_area(scene.camera, kPointMargin_px),
                                  {true, true, std::log2(kFaintestPoint / point_peak()), quick}, give_up);
        return std::pair(std::move(images), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    };
    const auto never = [] { return false; };
    const auto [whole, whole_s] = search(false, never);
    const auto [quick, quick_s] = search(true, never);
    int found = 0;
    double light = 0, found_light = 0;
    std::vector<double> off_px;
    for (const MeshImage& one : whole) {
        double nearest = INFINITY;
        const auto first = std::lower_bound(quick.begin(), quick.end(), one.star,
                                            [](const MeshImage& image, int star) { return image.star < star; });
        for (auto image = first; image != quick.end() && image->star == one.star; ++image)
            nearest = std::min(nearest, std::hypot(image->x - one.x, image->y - one.y));
        const double flux = std::exp2(mesh.light(one.star).light) / one.area;
        light += flux;
        if (nearest > kQuickOff_px) continue;
        off_px.push_back(nearest);
        ++found, found_light += flux;
    }
    REQUIRE(found > 0);
    std::sort(off_px.begin(), off_px.end());
    const double share = static_cast<double>(found) / static_cast<double>(whole.size());
    fmt::print(
        "quick search: {:.3f} core-s of {:.3f}; {:.4f} of the images, {:.5f} of the light, 99 % within {:.4f} px\n",
        quick_s, whole_s, share, found_light / light, off_px[off_px.size() * 99 / 100]);
    CHECK(quick_s < kQuickPart * whole_s);
    // And little more than its rays cost where nothing is looked for among them.
    const MeshArea area = mesh_area(scene.camera, kPointMargin_px);
    const std::clock_t start = std::clock();
    int seen = 0;
    for (int i = 0; i < kQuickCells; ++i)
        seen += trace_core64(input, (i % 200 - 99.5) * 0.01 * area.right, (i / 200 - 99.5) * 0.01 * area.top).fate ==
                Fate::kEscaped;
    const double rays_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    fmt::print("{} rays, of which {} escape: {:.3f} core-s\n", kQuickCells, seen, rays_s);
    CHECK(quick_s < kQuickOverRays * rays_s);
    CHECK(whole_s > kQuickOverRays * rays_s);  // that the check can fail
    CHECK(share > 0.92);
    CHECK(found_light > 0.99 * light);
    CHECK(quick.size() < whole.size());
    CHECK(off_px[off_px.size() * 99 / 100] < 0.3);

    std::atomic<int> asked = 0;
    const auto [none, none_s] = search(false, [&] { return ++asked > 0; });
    CHECK(none.empty());
    CHECK(none_s < 0.1 * quick_s);
}

}  // namespace
