// Pixels on edges with more rays: against the reference and against pictures with 16 x 16 rays a pixel; in tiles, in bands and whole.
#include <algorithm>
#include <cmath>
#include <vector>

#include "scenefile/scene_file.h"
#include "sky/sky.h"
#include "support/exact_pixels.h"
#include "support/gpu_session.h"
#include "support/picture_off.h"

using namespace nullscope;
using test::Off;
using test::off_between;
using test::picked;

namespace {

Scene sized_refined(const char* name, int width, int height) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    scene->camera.width = width, scene->camera.height = height;
    scene->picture.bloom = 0.0, scene->picture.auto_exposure = false, scene->picture.dither = false;
    return *scene;
}

Image<unsigned char> drawn_refined(Renderer& renderer, Scene scene, bool refine, int samples = 1) {
    scene.picture.refine = refine;
    scene.picture.samples = samples;
    REQUIRE(renderer.prepare(scene));
    return renderer.picture8();
}

TEST_CASE("refine: edges are those of 16 x 16 rays a pixel of the reference" * test::costly()) {
    constexpr double kMean = 2.0, kThousandth = 24.0;
    const Scene scene = sized_refined("first-light", 960, 540);
    test::Places places;  // a tenth of a million
    for (int y = 2; y < scene.camera.height; y += test::by_depth(5, 5, 1))
        for (int x = 0; x < scene.camera.width; ++x) places.push_back({x, y});
    const Image<unsigned char> exact = test::ExactPixels(scene, 2048).shown(scene, test::by_depth(6, 16, 16), places);
    test::on_one_context([&](test::GpuSession& session) {
        const Off one = off_between(picked(drawn_refined(*session.renderer, scene, false), places), exact),
                  many = off_between(picked(drawn_refined(*session.renderer, scene, true), places), exact);
        fmt::print("{}: off by {:.3f} of 255, a thousandth by {}; with one ray {:.3f}, {}; {:.1f} % of the pixels\n",
                   session.context->kind(), many.mean, many.thousandth, one.mean, one.thousandth,
                   100.0 * session.renderer->refined_share());
        CHECK(many.mean < kMean);
        CHECK(many.thousandth <= kThousandth);
        CHECK(one.thousandth > kThousandth);
    });
}

TEST_CASE("refine: the same in tiles and in bands, and nothing changes where there is no edge" * test::costly()) {
    test::Selection selection(2);
    for (const char* name : {"first-light", "earth", "kerr", "accretion"}) {
        if (!selection.takes_next()) continue;
        CAPTURE(std::string(name));
        const Scene scene = sized_refined(name, 190, 108);
        Scene dark = scene;
        dark.sky.kind = SkyKind::kBlack;  // a sky is filtered otherwise where edges are refined
        test::on_one_context([&](test::GpuSession& session) {
            Renderer& renderer = *session.renderer;
            renderer.limit_tiles(Tiles::kNone);
            const auto plain = drawn_refined(renderer, dark, false), edges = drawn_refined(renderer, dark, true);
            const double share = renderer.refined_share();
            CHECK(share > 0.005);
            CHECK(share < 0.4);
            int changed = 0;
            for (std::size_t i = 0; i < edges.data.size(); i += 3)
                changed += !std::equal(&edges.data[i], &edges.data[i] + 3, &plain.data[i],
                                       [](int a, int b) { return std::abs(a - b) <= 1; });
            CHECK(changed > 0);
            CHECK(3.0 * changed <= share * static_cast<double>(edges.data.size()) * 1.0001);
            const auto whole = drawn_refined(renderer, scene, true);
            renderer.limit_tiles(Tiles::kTraced);
            CHECK(off_between(drawn_refined(renderer, scene, true), whole).thousandth <= 1.0);
            CHECK(off_between(test::drawn_in_pieces(renderer, 190, 108, {0, 8, 33, 34, 64, 108}), whole).most <= 1);
            renderer.limit_tiles(Tiles::kBodies);
        });
    }
}

// Left and right of all other images a disc seen from its side is thinner than a pixel: whether a row's middle meets it says nothing.
TEST_CASE("refine: a disc seen from its side" * test::costly()) {
    constexpr double kLight =
        0.3;  // of what is there: a tenth to a quarter of a pixel, which six rows of rays meet or miss
    constexpr int kRays = 32;
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.disc.emplace().inner = 3.2, scene.disc->outer = 7.0;
    scene.camera.r = 20.0, scene.camera.width = 160, scene.camera.height = 90;
    const auto image = load_disc_image(*scene.disc);
    REQUIRE(image);
    test::Places sides;
    for (int y = 0; y < scene.camera.height; ++y)
        for (const int middle : {40, 120})
            for (int x = middle - 6; x < middle + 6; ++x) sides.push_back({x, y});
    test::Selection selection(2);  // each metric once, on either side of the plane
    for (const double degrees : {90.15, 89.9})
        for (const char* metric : {"schwarzschild", "kerr", "minkowski"}) {
            if (!selection.takes_next()) continue;
            scene.spacetime.metric = metric;
            scene.camera.theta = degrees * M_PI / 180;
            const auto sky = build_sky(scene.sky, {}, 16);
            REQUIRE(sky);
            const auto exact = reference::render_pixels(scene, *sky, &image->image, kRays, sides, nullptr);
            REQUIRE(exact);
            double there = 0;
            for (const reference::PixelLight& pixel : *exact) there += pixel.light.x;
            test::on_one_context([&](test::GpuSession& session) {
                REQUIRE(session.renderer->prepare(scene));
                const Image<float> picture = session.renderer->picture();
                double drawn = 0;
                for (const auto& [x, y] : sides) drawn += static_cast<double>(picture.at(x, y)[0]);
                fmt::print("{}: {}, {} degrees: light at the sides {:.4f} of the reference's {:.3g}\n",
                           session.context->kind(), metric, degrees, drawn / there, there);
                CHECK(there > 0);
                CHECK(std::fabs(drawn / there - 1) < kLight);
            });
        }
}

}  // namespace
