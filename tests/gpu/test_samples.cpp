// Several rays a pixel: against the reference with as many, in tiles and without, in bands and whole.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/assets.h"
#include "image/image_file.h"
#include "render/display.h"
#include "scenefile/scene_file.h"
#include "sky/sky.h"
#include "support/gpu_session.h"
#include "support/picture_off.h"

using namespace nullscope;
using test::Off;
using test::off_between;

namespace {

constexpr int kSamples = 4;

Scene small(const char* name, int width, int height) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    scene->camera.width = width, scene->camera.height = height;
    return *scene;
}

Image<unsigned char> drawn(Renderer& renderer, Scene scene, int samples) {
    scene.picture.samples = samples;
    REQUIRE(renderer.prepare(scene));
    return renderer.picture8();
}

TEST_CASE("samples: 4 x 4 rays a pixel are the reference's picture, one is not" * test::costly()) {
    constexpr double kMean = 0.5, kThousandth = 32.0;  // measured 0.34 and 23
    const Scene scene = small("first-light", 240, 135);
    const auto sky = build_sky(scene.sky, assets_directory(), 2048);
    const auto disc = load_disc_image(*scene.disc);
    REQUIRE((sky && disc));
    const reference::Pictures pictures(&disc->image);
    const auto light = reference::render_frame(scene, *sky, pictures, 2 * kSamples, {}, nullptr, {});
    REQUIRE(light);
    const Image<unsigned char> exact = display_encoded(*light, scene.camera.exposure_ev, scene.picture);
    test::on_one_context([&](test::GpuSession& session) {
        const Off one = off_between(drawn(*session.renderer, scene, 1), exact),
                  many = off_between(drawn(*session.renderer, scene, kSamples), exact);
        fmt::print("{}: off by {:.3f} of 255, a thousandth by {}; with one ray {:.3f}, {}\n", session.context->kind(),
                   many.mean, many.thousandth, one.mean, one.thousandth);
        CHECK(many.mean < kMean);
        CHECK(many.thousandth < kThousandth);
        CHECK(one.mean > 2.0 * many.mean);
    });
}

TEST_CASE("samples: the same in tiles, in bands and for a rotating hole, one ray is the picture without" *
          test::costly()) {
    test::Selection selection(2);
    for (const char* name : {"first-light", "earth", "kerr", "accretion"}) {
        if (!selection.takes_next()) continue;
        CAPTURE(std::string(name));
        const Scene scene = small(name, 190, 108);
        test::on_one_context([&](test::GpuSession& session) {
            Renderer& renderer = *session.renderer;
            renderer.limit_tiles(Tiles::kNone);
            const auto whole = drawn(renderer, scene, 3), plain = drawn(renderer, scene, 1);
            renderer.limit_tiles(Tiles::kInterpolated);
            CHECK(off_between(drawn(renderer, scene, 3), whole).thousandth <= 1.0);
            CHECK(off_between(test::drawn_in_pieces(renderer, 190, 108, {0, 33, 64, 108}), whole).most <= 1);
            CHECK(off_between(plain, whole).mean > 0.1);  // they are not the same picture
            renderer.limit_tiles(Tiles::kBodies);
        });
    }
}

}  // namespace
