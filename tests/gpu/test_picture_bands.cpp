// Large pictures, drawn in bands and parts: equal to the picture drawn at once, bit by bit, however they are cut.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "render/picture_bands.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

template <class T>
long long different(const Image<T>& whole, const Image<T>& band, int top) {
    const auto first = whole.data.begin() + static_cast<std::ptrdiff_t>(3) * whole.width * top;
    return std::inner_product(band.data.begin(), band.data.end(), first, 0LL, std::plus<>(), std::not_equal_to<>());
}

TEST_CASE("picture bands: a picture in parts is the picture at once, bit by bit" * test::costly()) {
    struct Case {
        const char* scene;
        Projection projection;
    };
    constexpr Case kCases[] = {{"kerr", Projection::kFisheye},        {"swarm", Projection::kCylindrical},
                               {"kerr", Projection::kPinhole},        {"starlight", Projection::kEquirectangular},
                               {"torus", Projection::kPinhole},       {"first-light", Projection::kEquirectangular},
                               {"kerr-planet", Projection::kPinhole}, {"hot-spot", Projection::kFisheye},
                               {"gargantua", Projection::kPinhole},   {"zoom", Projection::kPinhole}};
    constexpr int kWidth = 250, kHeight = 163;  // no multiples of a tile
    on_one_context([&](GpuSession& session) {
        Selection selection(5);
        for (const Case& one : kCases) {
            if (!selection.takes_next()) continue;
            auto scene = load_scene(one.scene);
            REQUIRE(scene);
            CameraSpec& camera = scene->camera;
            if (one.projection != camera.projection) {
                camera.projection = one.projection;
                set_field_of_view(camera, usual_field_of_view(one.projection));
            }
            camera.width = kWidth, camera.height = kHeight;
            scene->picture.bloom = 0.0, scene->picture.auto_exposure = false, scene->picture.dither = true;
            REQUIRE(session.renderer->prepare(*scene));
            const Image<unsigned char> whole8 = session.renderer->picture8();
            const Image<float> whole = session.renderer->picture();
            for (const auto& [most_px, widest] : {std::pair{kWidth * 40, 96}, {kWidth * 64, kWidth}}) {
                const auto bands = picture_bands(camera, most_px);
                CHECK(bands.size() > 2);
                CHECK(bands.front().top == 0);
                CHECK(bands.back().top + bands.back().rows == kHeight);
                long long off = 0, off8 = 0;
                for (const PictureBand& band : bands) {
                    const auto rows = draw_band(*session.renderer, *scene, band, widest);
                    const auto rows8 = draw_band8(*session.renderer, *scene, band, widest);
                    REQUIRE(rows);
                    REQUIRE(rows8);
                    off += different(whole, *rows, band.top), off8 += different(whole8, *rows8, band.top);
                }
                fmt::print("{:<12} {:<15} parts of {} px: {} and {} of {} numbers differ\n", one.scene,
                           projection_name(one.projection), widest, off, off8, whole.data.size());
                CHECK(off == 0);
                CHECK(off8 == 0);
            }
        }
    });
}

}  // namespace
