// What the display makes of a picture's light: the GPU's passes against their twin on the host.
#include <fmt/format.h>

#include <cmath>
#include <set>
#include <vector>

#include "render/display.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Half floats (2^-11 of the light), the square roots of srgb_encode (1/22500) and rounding: what is seen of them in 8 bits.
constexpr int kSteps = 2;

int worst_step(const Image<unsigned char>& a, const Image<unsigned char>& b) {
    int worst = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i) worst = std::max(worst, std::abs(a.data[i] - b.data[i]));
    return worst;
}

Scene bright_scene() {
    Scene scene;
    scene.camera.width = 203;  // odd: halves round up
    scene.camera.height = 118;
    scene.camera.r = 12.0;
    scene.disc.emplace().brightness = 12.0;
    return scene;
}

TEST_CASE("display: tone curves, bloom and automatic exposure are those of the host" * test::costly()) {
    on_every_context([&](GpuSession& session) {
        Selection selection(5);  // each tone curve, bloom and exposure in both states
        for (const ToneCurve tone : {ToneCurve::kShoulder, ToneCurve::kFilm, ToneCurve::kNeutral})
            for (const double bloom : {0.0, 0.3})
                for (const bool automatic : {false, true}) {
                    if (!selection.takes_next()) continue;
                    Scene scene = bright_scene();
                    scene.camera.exposure_ev = -0.7;
                    scene.picture = {tone, bloom, automatic, false};
                    scene.picture.refine = false;  // straight to the display, where nothing else works on the light
                    const Image<float> linear = picture_of(session, scene);
                    const int worst = worst_step(session.renderer->picture8(),
                                                 display_encoded(linear, scene.camera.exposure_ev, scene.picture));
                    CAPTURE(static_cast<int>(tone));
                    CAPTURE(bloom);
                    CAPTURE(automatic);
                    CHECK(worst <= kSteps);
                }
    });
}

TEST_CASE("display: bloom moves light and keeps its sum; linear output is without it" * test::costly()) {
    Image<float> spot(200, 120, 3);
    spot.at(97, 61)[1] = 1000.0f;
    const Image<float> spread = with_bloom(spot, 0.4);
    double sum = 0;
    for (const float v : spread.data) sum += v;
    constexpr double kLost = 0.02;  // beyond the frame, and clamped at its edge
    CHECK(std::abs(sum / 1000 - 1) <= kLost);
    CHECK(spread.at(97, 61)[1] < 700.0f);
    CHECK(spread.at(107, 61)[1] > spread.at(137, 61)[1]);
    CHECK(spread.at(137, 61)[1] > 0.0f);
    on_every_context([&](GpuSession& session) {
        Scene scene = bright_scene();
        const Image<float> before = picture_of(session, scene);
        scene.picture = {ToneCurve::kFilm, 0.5, true, true};
        REQUIRE(session.renderer->prepare(scene));
        CHECK(session.renderer->picture().data == before.data);
    });
}

TEST_CASE("display: dithering moves a value by at most a step, keeps means and leaves black alone") {
    on_every_context([&](GpuSession& session) {
        Scene scene = bright_scene();
        scene.sky.kind = SkyKind::kBlack;
        REQUIRE(session.renderer->prepare(scene));
        const Image<unsigned char> plain = session.renderer->picture8();
        scene.picture.dither = true;
        REQUIRE(session.renderer->prepare(scene));
        const Image<unsigned char> noisy = session.renderer->picture8();
        CHECK(worst_step(plain, noisy) == 1);
        double drift = 0;
        for (std::size_t i = 0; i < plain.data.size(); ++i) {
            drift += noisy.data[i] - plain.data[i];
            if (plain.data[i] == 0) CHECK(noisy.data[i] <= 1);
        }
        constexpr double kDrift = 0.01;  // steps, on average
        CHECK(std::abs(drift / static_cast<double>(plain.data.size())) <= kDrift);
    });
}

TEST_CASE("display: exposure adapts by the share it is told and starts at once" * test::costly()) {
    on_every_context([&](GpuSession& session) {
        Scene scene = bright_scene();
        scene.picture.auto_exposure = true;
        REQUIRE(session.renderer->prepare(scene));
        const auto mean = [&] {
            double sum = 0;
            for (const unsigned char v : session.renderer->picture8().data) sum += v;
            return sum;
        };
        const double at_first = mean();
        session.renderer->set_adaptation(0.3);
        scene.disc->brightness = 120.0;
        REQUIRE(session.renderer->prepare(scene));
        const double flash = mean(), later = mean();
        double settled = 0;
        for (int i = 0; i < 40; ++i) settled = mean();
        CHECK(flash > 1.05 * at_first);
        CHECK(later < flash);
        CHECK(std::abs(settled / at_first - 1) < 0.02);
        session.renderer->set_adaptation(1.0);
    });
}

}  // namespace

TEST_CASE("display: pictures of a few pixels, down to one" * test::costly()) {
    constexpr std::pair<int, int> kSizes[] = {{1, 1}, {2, 1}, {1, 2}, {3, 5}, {16, 16}};
    // What draws in more than one pass, or about a point: every shipped scene where all is asked for; at quick depth one
    // of each set of these, by each kind of light path.
    const auto passes = [](const Scene& scene) {
        const EffectSet effects = effect_set(required_effects(scene));
        std::vector<int> list;
        for (const Effect one : {Effect::kBloom, Effect::kAutoExposure, Effect::kPointStars})
            if (effects.contains(one)) list.push_back(static_cast<int>(one));
        if (!list.empty()) list.push_back(static_cast<int>(light_path_kind(effects)));
        return list;
    };
    int drawn = 0;
    on_every_context([&](GpuSession& session) {
        if (session.context->kind() != std::string("egl") && !everything_asked()) return;  // both have one rasteriser
        Selection selection(2);  // five sizes: each scene at two or three of them
        std::set<std::vector<int>> seen;
        for (const SceneInfo& info : shipped_scenes()) {
            auto scene = load_scene(info.path.string());
            REQUIRE(scene);
            const auto has = passes(*scene);
            const bool known = !seen.insert(has).second;
            if ((has.empty() && !everything_asked()) || (known && depth() == Depth::kQuick)) continue;
            for (const auto& size : kSizes) {
                if (!selection.takes_next()) continue;
                const int width = size.first, height = size.second;
                CAPTURE(info.name);
                CAPTURE(width);
                CAPTURE(height);
                scene->camera.width = width, scene->camera.height = height;
                scene->picture.refine = false;  // edges next to the bound are edges in half floats or in floats alone
                REQUIRE(session.renderer->prepare(*scene));
                const Image<float> linear = session.renderer->picture();
                const auto expected = display_encoded(linear, scene->camera.exposure_ev, scene->picture);
                CHECK(worst_step(session.renderer->picture8(), expected) <= kSteps);
                ++drawn;
            }
        }
        fmt::print("pictures of a few pixels: {} of {} sets of passes\n", drawn, seen.size());
    });
    CHECK(drawn >= 10);
}
