// Warp meshes: the shader's directions against the closed form of the mesh in pictures of 8192 px, rays against the reference about holes,
// a mesh of identity against no mesh, and pictures in parts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "against_reference.h"
#include "base/assets.h"
#include "observer/pose.h"
#include "render/picture_bands.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "sky/point_stars.h"
#include "sky/sky.h"
#include "support/large_picture.h"
#include "support/warp_files.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// A smooth map of the screen to the picture, as of a mirror; both half heights.
std::array<long double, 2> bent(long double x, long double y) {
    return {0.8L * x + 0.06L * std::sin(2 * y) * x + 0.03L * y * y, 0.75L * y + 0.05L * std::cos(1.5L * x) - 0.1L};
}

// Its mesh for a square picture; moved: the nodes are not on a grid of the screen.
std::string bent_text(int nodes, bool moved) {
    return warp_text(nodes, nodes, 1.0, [&](WarpNode& n) {
        if (moved) n.x += 0.02 * std::sin(7 * n.y), n.y += 0.02 * std::sin(6 * n.x);
        const auto at = bent(n.x, n.y);
        n.u = static_cast<double>(0.5L * at[0] + 0.5L), n.v = static_cast<double>(0.5L * at[1] + 0.5L);
    });
}

TEST_CASE("warp: directions in a picture of 8192 px are those of the mesh's closed form to 0.1 px" * test::costly()) {
    constexpr double kMost_px = 0.1;
    constexpr int kSide = 8192, kNodes = 257;
    const TemporaryFolder folder("warp");
    on_every_context([&](GpuSession& session) {
        for (const bool moved : {false, true}) {
            Scene scene;
            scene.spacetime = {"minkowski", {}};
            scene.sky.kind = SkyKind::kPlain;
            CameraSpec whole = scene.camera;
            whole.projection = Projection::kFisheye;
            set_field_of_view(whole, M_PI);
            whole.width = whole.height = kSide;
            whole.theta = 0.7, whole.phi = 0.3, whole.yaw = 0.4, whole.pitch = 0.2;
            whole.warp = folder.path / (moved ? "moved.data" : "grid.data");
            write_warp(whole.warp, bent_text(kNodes, moved));
            const Mat3 axes = world_from_static(whole.theta, whole.phi) * static_from_camera(whole);
            double most = 0.0, most_of_triangles = 0.0;
            int rays = 0, dark = 0, wrongly_dark = 0;
            scene.camera = whole;
            each_ray_of_squares(session, scene, [&](const RayPixel& ray, int column, int row) {
                const long double half = 0.5L * kSide;
                const auto at = bent((column + 0.5L - half) / half, (half - row - 0.5L) / half);
                const long double angle = std::hypot(at[0], at[1]) * (M_PIl / 2), bearing = std::atan2(at[1], at[0]);
                if (ray.fate != Fate::kEscaped) {
                    ++dark;
                    wrongly_dark += shows(whole, column + 0.5, row + 0.5);
                    return;
                }
                const Vec3 exact = axes * Vec3{static_cast<double>(std::sin(angle) * std::cos(bearing)),
                                               static_cast<double>(std::sin(angle) * std::sin(bearing)),
                                               static_cast<double>(-std::cos(angle))};
                const Vec3 of_triangles = axes * pixel_direction(whole, column + 0.5, row + 0.5);
                most = std::max(most, length(ray.sky - exact) / whole.pixel());
                most_of_triangles = std::max(most_of_triangles, length(ray.sky - of_triangles) / whole.pixel());
                ++rays;
            });
            fmt::print(
                "{}, 8192x8192, {}x{} nodes: {} rays off by {:.2g} px at most, from the mesh's triangles by {:.2g} "
                "px\n",
                moved ? "nodes moved" : "nodes on a grid", kNodes, kNodes, rays, most, most_of_triangles);
            CHECK(most < kMost_px);
            CHECK(most_of_triangles < 0.01);
            CHECK(rays > 200000);
            CHECK(dark > 0);
            CHECK(wrongly_dark == 0);
        }
    });
}

Scene scene_of(const char* name, Projection projection, int width, int height) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    CameraSpec& camera = scene->camera;
    if (projection != camera.projection) {
        camera.projection = projection;
        set_field_of_view(camera, usual_field_of_view(projection));
    }
    camera.width = width, camera.height = height;
    scene->picture.bloom = 0.0, scene->picture.auto_exposure = false;
    return std::move(*scene);
}

TEST_CASE("warp: a mesh of identity is no mesh, bit by bit; with half the light half of it is left" * test::costly()) {
    const TemporaryFolder folder("warp");
    on_one_context([&](GpuSession& session) {
        Selection selection(2);
        struct Case {
            const char* scene;
            Projection projection;
            int width, height;
        };
        for (const Case& one : {Case{"first-light", Projection::kFisheye, 96, 96},
                                {"kerr", Projection::kPinhole, 128, 64},
                                {"hot-spot", Projection::kCylindrical, 128, 64},
                                {"torus", Projection::kEquirectangular, 128, 64}}) {
            if (!selection.takes_next()) continue;
            Scene scene = scene_of(one.scene, one.projection, one.width, one.height);
            const Image<float> plain = picture_of(session, scene);
            scene.camera.warp = folder.path / fmt::format("{}.data", one.scene);
            const double aspect = static_cast<double>(one.width) / one.height;
            write_warp(scene.camera.warp, warp_text(9, 5, aspect, [](WarpNode&) {}));
            const Image<float> warped = picture_of(session, scene);
            write_warp(scene.camera.warp, warp_text(9, 5, aspect, [](WarpNode& n) { n.light = 0.5; }));
            scene.picture.refine = false;  // it looks at light as it is displayed
            const Image<float> dimmed = picture_of(session, scene);
            scene.camera.warp.clear();
            const Image<float> rough = picture_of(session, scene);
            long long off = 0;
            float most = 0.0f, brightest = 0.0f, dim = 0.0f;
            for (std::size_t i = 0; i < plain.data.size(); ++i) {
                off += plain.data[i] != warped.data[i];
                most = std::max(most, std::fabs(plain.data[i] - warped.data[i]));
                brightest = std::max(brightest, plain.data[i]);
                dim = std::max(dim, std::fabs(0.5f * rough.data[i] - dimmed.data[i]));
            }
            fmt::print(
                "{:<12} {:<15} {} of {} numbers differ, by {:.2g} at most of {:.2g}; half of the light by {:.2g}\n",
                one.scene, projection_name(one.projection), off, plain.data.size(), most, brightest, dim);
            CHECK(off == 0);
            CHECK(dim <= 1e-6f * brightest);
            CHECK(brightest > 0.1f);
        }
    });
}

TEST_CASE("warp: rays are the reference's about every kind of hole, and pictures in parts are the picture at once" *
          test::costly()) {
    // Of 2048 px across, as without a mesh (test_projections.cpp).
    AgainstReference judge("warp", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 2048, .least_skies = 501});
    const TemporaryFolder folder("warp");
    const auto file = folder.path / "bent.data";
    write_warp(file, bent_text(33, true));
    on_one_context([&](GpuSession& session) {
        Selection selection(2);
        struct Case {
            const char* metric;
            MetricParameters parameters;
            ObserverKind observer;
            double r;
            Vec3 velocity;
            Projection projection;
        };
        const Case cases[] = {
            {"schwarzschild", {}, ObserverKind::kStatic, 6.0, {0.1, 0.0, 0.2}, Projection::kFisheye},
            {"kerr", {{"spin", 0.9}}, ObserverKind::kRain, 9.0, {}, Projection::kPinhole},
            {"kerr", {{"spin", 0.7}}, ObserverKind::kStatic, 6.0, {0.0, 0.2, 0.0}, Projection::kEquirectangular},
            {"ellis", {{"throat", 1.0}}, ObserverKind::kStatic, 2.0, {}, Projection::kCylindrical}};
        for (const Case& one : cases) {
            if (!selection.takes_next()) continue;
            Draft draft;
            draft.metric(one.metric, one.parameters).by(one.observer).place(one.r, 1.2).moving(one.velocity);
            CameraSpec& camera = draft.yaw(0.2).scene.camera;
            camera.pitch = 0.1, camera.projection = one.projection, camera.warp = file;
            set_field_of_view(camera, usual_field_of_view(one.projection));
            if (one.metric != std::string("ellis")) draft.disc(1.5, 4.0);
            judge.frame(session, fmt::format("{} {}", projection_name(one.projection), one.metric), draft.size(64, 64));
        }
        Scene scene = scene_of("kerr", Projection::kFisheye, 150, 101);
        scene.camera.warp = file;
        const Image<float> whole = picture_of(session, scene);
        long long off = 0;
        for (const PictureBand& band : picture_bands(scene.camera, 150 * 40)) {
            const auto rows = draw_band(*session.renderer, scene, band, 64);
            REQUIRE(rows);
            for (std::size_t i = 0; i < rows->data.size(); ++i)
                off += rows->data[i] != whole.data[static_cast<std::size_t>(band.top) * 450 + i];
        }
        fmt::print("in parts: {} of {} numbers differ\n", off, whole.data.size());
        CHECK(off == 0);
    });
}

TEST_CASE("warp: point stars are where the mesh has them, and as bright as their pixels are wide" * test::costly()) {
    constexpr double kPeak = 0.05;   // of the brightest pixel: no others are compared
    constexpr double kLight = 0.02;  // the driver's half floats and the cut tails of point spreads
    constexpr double kBeside =
        0.02;  // of the pixels: stars on two triangles, whose light the reference takes from the one
    const TemporaryFolder folder("warp");
    Scene scene;
    scene.sky.kind = SkyKind::kPoints, scene.sky.uniform_stars = 300, scene.sky.magnitude_limit = -2.0;
    scene.picture.refine = false;
    CameraSpec& camera = scene.camera;
    camera.r = 10.0, camera.pitch = 0.5;
    camera.projection = Projection::kFisheye;
    set_field_of_view(camera, M_PI);
    camera.width = camera.height = 96;
    const auto identity = folder.path / "identity.data", dimmed = folder.path / "dimmed.data";
    write_warp(identity, warp_text(5, 5, 1.0, [](WarpNode&) {}));
    write_warp(dimmed, warp_text(33, 33, 1.0, [](WarpNode& n) {
                   const auto at = bent(n.x, n.y);
                   n.light = 1.0 - 0.3 * n.x;
                   n.u = static_cast<double>(0.5L * at[0] + 0.5L), n.v = static_cast<double>(0.5L * at[1] + 0.5L);
               }));
    on_one_context([&](GpuSession& session) {
        for (const bool rotating : {false, true}) {
            scene.spacetime = {rotating ? "kerr" : "schwarzschild", {}};
            camera.warp.clear();
            const Image<float> plain = picture_of(session, scene);
            camera.warp = identity;
            const Image<float> same = picture_of(session, scene);
            long long off = 0;
            for (int y = 8; y < camera.height - 8; ++y)  // those beside the picture are not in the mesh
                for (int x = 8; x < camera.width - 8; ++x) off += plain.at(x, y)[1] != same.at(x, y)[1];
            CHECK(off == 0);
        }
        scene.spacetime = {"schwarzschild", {}};
        camera.warp = dimmed;
        const Image<float> drawn = picture_of(session, scene);
        const auto sky = build_sky(scene.sky, assets_directory(), 16);
        const auto stars = point_stars(scene.sky, assets_directory());
        REQUIRE(sky);
        REQUIRE(stars);
        const auto exact = reference::render_frame(scene, *sky, {}, 1, {}, nullptr, *stars);
        REQUIRE(exact);
        const float most = *std::ranges::max_element(exact->data);
        std::vector<double> ratios;
        for (std::size_t i = 0; i < exact->data.size(); ++i)
            if (exact->data[i] > kPeak * most) ratios.push_back(drawn.data[i] / exact->data[i]);
        const auto good = std::ranges::count_if(ratios, [&](double r) { return std::fabs(r - 1.0) < kLight; });
        fmt::print("{} of {} bright numbers are the reference's within {}\n", good, ratios.size(), kLight);
        CHECK(ratios.size() > 300);
        CHECK(static_cast<double>(ratios.size()) - static_cast<double>(good) <=
              kBeside * static_cast<double>(ratios.size()));
    });
}

}  // namespace
