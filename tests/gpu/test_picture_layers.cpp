// A picture in layers: they add up to it, and their shares to one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command/capture_layers.h"
#include "render/picture_layers.h"
#include "scene/bodies.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kLayerError = 1e-5;  // of the light, and of 1 where there is less: rounding of float sums

double worst_off(const Image<float>& a, const Image<float>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
        most = std::max(most, std::abs(double(a.data[i]) - b.data[i]) / std::max(1.0, std::abs(double(b.data[i]))));
    return most;
}

TEST_CASE("picture layers: they add up to the picture, shares to one" * test::costly()) {
    constexpr const char* kScenes[] = {"first-light", "gargantua",  "swarm",    "starlight",
                                       "kerr-planet", "hot-spot",   "zoom",     "neutron-star",
                                       "soft-disc",   "grid-torus", "hot-flow", "m87-synchrotron"};
    on_one_context([&](GpuSession& session) {
        Selection selection(4);
        for (const char* name : kScenes) {
            if (!selection.takes_next()) continue;
            auto scene = load_scene(name);
            REQUIRE_MESSAGE(scene, name);
            scene->camera.width = 250, scene->camera.height = 163;  // no multiples of a tile
            REQUIRE(session.renderer->prepare(*scene));
            const PictureLayers layers = draw_layers(*session.renderer);
            Image<float> sum(layers.all.width, layers.all.height, 3);
            std::vector<double> shares(layers.covered.size());
            double least = 1, lit = 0;
            for (const LayerImage& layer : layers.each) {
                double light = 0;
                for (std::size_t i = 0; i < sum.data.size(); ++i)
                    sum.data[i] += layer.light.data[i], light += layer.light.data[i];
                for (std::size_t i = 0; i < shares.size(); ++i) {
                    shares[i] += layer.share[i];
                    least = std::min(least, double(layer.share[i]));
                }
                lit += light > 0;
            }
            double most = 0;
            for (const double all : shares) most = std::max(most, all);
            const Image<float> picture = session.renderer->picture();
            const double off = worst_off(sum, layers.all), beside = worst_off(layers.all, picture);
            fmt::print(
                "{:<12} {} layers, {} lit: sum off by {:.1e}, from the picture by {:.1e}; shares {:.6f} to {:.6f}\n",
                name, layers.each.size(), lit, off, beside, least, most);
            CHECK(off < kLayerError);
            CHECK(beside < kLayerError);
            CHECK(least >= 0);
            CHECK(most <= 1 + kLayerError);
        }
    });
}

TEST_CASE("picture layers: a disc that has flowed for thousands of lives hides what it hides, no more") {
    on_one_context([](GpuSession& session) {
        Scene scene;
        scene.camera.width = 64, scene.camera.height = 36, scene.time = 163'834.3;  // 4095.86 lives
        scene.disc.emplace().flow = DiscFlowKind::kKepler;
        add<BallSpec>(scene).position = {0, 0, -5};
        REQUIRE(session.renderer->prepare(scene));
        for (const LayerImage& layer : draw_layers(*session.renderer).each) {
            CAPTURE(layer.name);
            CHECK(*std::ranges::min_element(layer.light.data) >= 0);
            CHECK(*std::ranges::max_element(layer.share) <= 1);
        }
    });
}

// A cloud of this density in the middle of a scene's ball, which is left out.
Scene with_cloud(Scene scene, MediumEmission emission) {
    const Vec3 at = first_shape<BallSpec>(scene)->position;
    scene.bodies.clear();
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kFormula, medium.emission = emission, medium.outer = 9, medium.steps = 256;
    medium.formulas.density = fmt::format("20 * exp(-((x - {})^2 + (y - {})^2 + (z - {})^2) / 0.05)", at.x, at.y, at.z);
    scene.object.mass_suns = 4e6, scene.object.distance_pc = 8000;
    return scene;
}

TEST_CASE("picture layers: matter is hit where its light comes from, and has the depth of what stands there" *
          test::costly()) {
    constexpr double kRadius = 0.4, kPlace = 0.05, kDepth = 0.06;  // r_s: the cloud is 0.16 wide
    on_one_context([&](GpuSession& session) {
        session.renderer->want_delays(true);
        const std::string_view rotating =
            "kerr";  // at quick depth with one of the emission laws, the others with the other
        for (const char* metric : {"minkowski", "schwarzschild", "kerr"})
            for (const MediumEmission emission : {MediumEmission::kBlackBody, MediumEmission::kPowerLaw}) {
                if (depth() == Depth::kQuick && (metric == rotating) != (emission == MediumEmission::kPowerLaw))
                    continue;
                CAPTURE(metric);
                Scene scene;
                scene.spacetime.metric = metric;
                scene.camera.width = 96, scene.camera.height = 54, scene.camera.r = 20, scene.camera.theta = 1.2;
                scene.sky.kind = SkyKind::kBlack;
                BallSpec& ball = add<BallSpec>(scene);
                ball.position = {4, 5, 1}, ball.radius = kRadius;
                const auto solid = cli::capture_layers(session, scene, nullptr);
                const auto cloud = cli::capture_layers(session, with_cloud(scene, emission), nullptr);
                REQUIRE(solid);
                REQUIRE_MESSAGE(cloud, cloud.error().message());
                // Where the ball is met nearest to the camera, in its first image.
                std::size_t nearest = 0;
                for (std::size_t i = 0; i < solid->rays.pixels.size(); ++i) {
                    const float depth = solid->depths.depth[i], least = solid->depths.depth[nearest];
                    if (solid->rays.pixels[i].hit != 0 && (least == 0 || depth < least)) nearest = i;
                }
                const RayPixel& hit = cloud->rays.pixels[nearest];
                const double place = length(Vec3{hit.u, hit.v, hit.w} - ball.position),
                             depth = cloud->depths.depth[nearest] - solid->depths.depth[nearest] - kRadius;
                fmt::print("{}: hit {}, {:.3f} r_s beside the cloud's middle, {:.3f} r_s too deep\n", metric, hit.hit,
                           place, depth);
                CHECK(hit.hit == kMediumHit);
                CHECK(cloud->depths.depth[nearest] == cloud->depths.medium[nearest]);
                CHECK(std::abs(depth) < kDepth + (emission == MediumEmission::kBlackBody ? kRadius : 0.0));
                CHECK(place < kPlace + (emission == MediumEmission::kBlackBody ? kRadius : 0.1));
                // Where there is no matter nothing is hit.
                CHECK(cloud->rays.pixels.front().hit == 0);
                CHECK(cloud->depths.medium.front() == 0.0f);
            }
    });
}

}  // namespace
