// A picture in layers: they add up to it, and their shares to one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/picture_layers.h"
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

TEST_CASE("picture layers: they add up to the picture, shares to one") {
    constexpr const char* kScenes[] = {"first-light", "gargantua", "swarm", "starlight",
                                       "kerr-planet", "hot-spot",  "zoom",  "neutron-star"};
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

}  // namespace
