// Pictures of an open shutter: a mean of sub-frames that is displayed as a picture's own light is, drawn in parts as at once, and which 16
// sub-frames show as well as 256.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "observer/path.h"
#include "plan/shutter.h"
#include "render/picture_bands.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kFrame = 5.0;

Scene scene_of(const std::string& text) {
    auto scene = parse_scene(text, "scene.toml", {});
    const std::string reason = scene ? "" : scene.error().message();
    REQUIRE_MESSAGE(scene, reason);
    return std::move(*scene);
}

// In the middle of its path, or at time 5.
Exposure exposed(const Scene& scene) {
    std::optional<CameraPath> path;
    if (scene.path) {
        auto made = CameraPath::make(scene);
        REQUIRE(made);
        path = std::move(*made);
    }
    return exposure_of(
        [&](double frame) {
            Scene now = scene;
            now.time = frame;
            if (path) now.camera = path->at(frame);
            return now;
        },
        static_cast<int>(kFrame));
}

// A camera that turns by 2 degrees, 8 px; a disc that flows and a ball on its orbit, in half of a time r_s/c.
const std::string kTurns =
    "[disc]\n[picture]\nshutter = 0.5\n[path]\nkind = \"keys\"\n"
    "[[path.key]]\nyaw = -20\n[[path.key]]\nframe = 10\nyaw = 20\n[camera]\nr = 15\n";
const std::string kMoves =
    "[disc]\nflow = \"kepler\"\nouter = 9\n[ball]\nposition = [6, 0, 1]\nmotion = \"orbit\"\n"
    "texture = \"checker\"\n[picture]\nshutter = 0.5\n[camera]\nr = 20\ntheta = 75\n";

TEST_CASE("shutter: 16 sub-frames are within a hundredth of 256") {
    if (depth() == Depth::kQuick) return;
    on_one_context([&](GpuSession& session) {
        for (const auto& [name, text] : {std::pair{"a camera that turns", &kTurns}, {"disc and ball", &kMoves}}) {
            Scene scene = scene_of(*text + "size = [160, 90]\n");
            const auto light = [&](int sub_frames) {
                scene.picture.sub_frames = sub_frames;
                const Exposure shown = exposed(scene);
                CHECK(static_cast<int>(shown.sub_frames.size()) == sub_frames);
                CHECK(smooth_sub_frames(shown) <= 16);
                auto drawn = draw_picture(*session.renderer, shown);
                REQUIRE(drawn);
                return std::move(*drawn);
            };
            const Image<float> few = light(16), many = light(256);
            double mean = 0, off = 0, square = 0, most = 0;
            for (std::size_t i = 0; i < many.data.size(); ++i) {
                const double apart = std::fabs(static_cast<double>(few.data[i]) - many.data[i]);
                mean += many.data[i], off += apart, square += apart * apart, most = std::max(most, apart);
            }
            const auto count = static_cast<double>(many.data.size());
            mean /= count;
            fmt::print("{:<20} of the mean light: rms {:.4f}, mean {:.4f}, most {:.3f}\n", name,
                       std::sqrt(square / count) / mean, off / count / mean, most / mean);
            CHECK(std::sqrt(square / count) / mean < 0.01);
        }
    });
}

TEST_CASE("shutter: the mean is displayed as a picture's own light" * test::costly()) {
    const std::string eye[] = {"", "bloom = 0.3\n", "auto_exposure = \"on\"\ndither = \"on\"\n",
                               "bloom = 0.1\nauto_exposure = \"on\"\ntone = \"film\"\n", "samples = 2\n"};
    on_one_context([&](GpuSession& session) {
        for (const std::string& keys : eye) {
            const Scene scene =
                scene_of("[disc]\n[camera]\nr = 15\nsize = [90, 61]\n[picture]\nrefine = \"off\"\n" + keys);
            REQUIRE(session.renderer->prepare(scene));
            const Image<unsigned char> own = session.renderer->picture8(),
                                       again = session.renderer->displayed(session.renderer->picture()),
                                       after = session.renderer->picture8();
            int most = 0;
            for (std::size_t i = 0; i < own.data.size(); ++i)
                most = std::max(most, std::abs(own.data[i] - again.data[i]));
            CAPTURE(keys);
            CHECK(most <= 1);  // its own light is half floats; by them other pixels would be refined
            CHECK(own.data == after.data);
            Exposure twice(scene);
            twice.sub_frames = {{0.5, scene}, {0.5, scene}};
            CHECK(draw_picture8(*session.renderer, twice)->data == again.data);
        }
    });
}

TEST_CASE("shutter: in parts as at once, bit by bit" * test::costly()) {
    on_one_context([&](GpuSession& session) {
        Scene scene = scene_of(kTurns + "size = [100, 61]\n");
        scene.picture.sub_frames = 3, scene.picture.dither = true;
        const Exposure shown = exposed(scene);
        const auto whole = draw_picture(*session.renderer, shown);
        const auto whole8 = draw_picture8(*session.renderer, shown);
        REQUIRE(whole);
        REQUIRE(whole8);
        for (const PictureBand& band : picture_bands(scene.camera, 100 * 24)) {
            const auto rows = draw_band(*session.renderer, shown, band, 48);
            const auto rows8 = draw_band8(*session.renderer, shown, band, 48);
            REQUIRE(rows);
            REQUIRE(rows8);
            CHECK(std::ranges::equal(rows->data, std::span(whole->data).subspan(300 * band.top, rows->data.size())));
            CHECK(std::ranges::equal(rows8->data, std::span(whole8->data).subspan(300 * band.top, rows8->data.size())));
        }
    });
}

}  // namespace
