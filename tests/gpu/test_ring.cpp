// The first and the second image of the disc, light that has been once and twice about the hole: all of it is there, and nowhere along them a gap.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/vec.h"
#include "scenefile/scene_file.h"
#include "support/depth.h"
#include "support/gpu_session.h"

using namespace nullscope;

namespace {

// A bright disc about a hole of this spin (of M), and nothing else.
Scene ring(double spin, int width, int height) {
    auto scene = load_scene(spin == 0.0 ? "first-light" : "kerr");
    REQUIRE(scene);
    scene->camera.width = width, scene->camera.height = height;
    if (spin != 0.0) scene->spacetime.parameters["spin"] = spin;
    scene->picture.bloom = 0.0, scene->picture.auto_exposure = false, scene->picture.dither = false;
    scene->sky.kind = SkyKind::kBlack;
    scene->disc->material.texture = TextureKind::kPlain;
    scene->disc->image.clear();
    scene->disc->emission = DiscEmission::kImage;
    scene->disc->edge = 0.0, scene->disc->brightness = 1.0;
    return *scene;
}

Image<float> ring_drawn(Renderer& renderer, Scene scene, bool refine, int samples = 1) {
    scene.picture.refine = refine;
    scene.picture.samples = samples;
    REQUIRE(renderer.prepare(scene));
    return renderer.picture();
}

double light_of(const Image<float>& picture) { return std::accumulate(picture.data.begin(), picture.data.end(), 0.0); }

TEST_CASE("ring: images of the disc of first and of second order have their light" * test::costly()) {
    constexpr double kLight = 0.01;  // of all of it
    test::on_one_context([&](test::GpuSession& session) {
        test::Selection selection(5);  // the first image at rest, the second at the largest spin
        for (const double spin : {0.0, 0.9, 0.998})
            for (const int order : {1, 2}) {
                if (!selection.takes_next()) continue;
                CAPTURE(spin);
                CAPTURE(order);
                Renderer& renderer = *session.renderer;
                const Scene scene = ring(spin, 480, 270);
                renderer.pass_crossings(order);  // images of this order and higher; the direct one has order 0
                const double all = light_of(ring_drawn(renderer, scene, false, test::by_depth(8, 16, 16))),
                             refined = light_of(ring_drawn(renderer, scene, true)),
                             one = light_of(ring_drawn(renderer, scene, false));
                fmt::print(
                    "{}: spin {}, order {} and higher: light over that of many rays a pixel {:.4f}, with one ray "
                    "{:.4f}\n",
                    session.context->kind(), spin, order, refined / all, one / all);
                CHECK(std::abs(refined / all - 1.0) < kLight);
            }
    });
}

// Light across the ring, at so many places along it: summed over the picture, each pixel shared out between the two places next to it.
std::vector<double> along_ring(const Image<float>& picture, int places) {
    double sum = 0, x0 = 0, y0 = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double light = picture.at(x, y)[1];
            sum += light, x0 += light * x, y0 += light * y;
        }
    std::vector<double> found(static_cast<std::size_t>(places));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double at = (std::atan2(y - y0 / sum, x - x0 / sum) / (2 * M_PI) + 0.5) * places,
                         floor = std::floor(at);
            const auto first = static_cast<std::size_t>(floor) % found.size();
            found[first] += (1 - (at - floor)) * picture.at(x, y)[1];
            found[(first + 1) % found.size()] += (at - floor) * picture.at(x, y)[1];
        }
    return found;
}

// The least light over the median of its neighbours.
double least_along(const std::vector<double>& light) {
    constexpr int kBeside = 6;
    double least = INFINITY;
    const int n = static_cast<int>(light.size());
    for (int i = 0; i < n; ++i) {
        std::vector<double> beside;
        for (int k = -kBeside; k <= kBeside; ++k)
            if (k != 0) beside.push_back(light[static_cast<std::size_t>((i + k + n) % n)]);
        std::nth_element(beside.begin(), beside.begin() + kBeside, beside.end());
        if (beside[kBeside] > 0) least = std::min(least, light[static_cast<std::size_t>(i)] / beside[kBeside]);
    }
    return least;
}

TEST_CASE("ring: no gap along the second image" * test::costly()) {
    constexpr double kLeast = 0.5;  // of the median of the neighbours: less is seen as a gap
    constexpr int kPlaces = 240;    // some 4 px of the ring each
    test::on_one_context([&](test::GpuSession& session) {
        for (const double spin : {0.0, 0.9, 0.998}) {
            CAPTURE(spin);
            const Scene scene = ring(spin, 1280, 720);
            session.renderer->pass_crossings(2);
            const double refined = least_along(along_ring(ring_drawn(*session.renderer, scene, true), kPlaces)),
                         one = least_along(along_ring(ring_drawn(*session.renderer, scene, false), kPlaces));
            fmt::print(
                "{}: spin {}: least light along the ring over the median beside it {:.2f}, with one ray {:.2f}\n",
                session.context->kind(), spin, refined, one);
            CHECK(refined >= kLeast);
        }
    });
}

}  // namespace
