// A camera that turns slowly: no pixel of a ring or an edge flickers more than the sampling of the reference makes it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "scenefile/scene_file.h"
#include "support/exact_pixels.h"
#include "support/gpu_session.h"

using namespace nullscope;

namespace {

constexpr int kFlickerWidth = 1280, kFlickerHeight = 720;
constexpr double kPan_px = 0.05;  // from frame to frame

Scene frame(Scene scene, int number) {
    scene.camera.yaw += number * kPan_px * scene.camera.pixel();
    return scene;
}

// Of a pixel's displayed luminance over the frames: the largest change of the change from one to the next.
struct Flicker {
    double before = 0, last = 0, most = 0;
    int frames = 0;
    void add(const unsigned char* rgb) {
        const double shown = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        if (frames++ >= 2) most = std::max(most, std::abs(shown - 2 * last + before));
        before = last, last = shown;
    }
};

TEST_CASE("flicker: edges and rings of a slow pan flicker at most twice as much as the reference's" * test::costly()) {
    constexpr double kMost = 2.0, kShare = 0.99;  // of the pixels that flicker most
    constexpr double kStep = 16.0;                // of 255: one ray of 4 x 4
    auto scene = load_scene("first-light");
    REQUIRE(scene);
    scene->camera.width = kFlickerWidth, scene->camera.height = kFlickerHeight;
    scene->picture.dither = false;
    scene->sky.kind = SkyKind::kBlack;
    const int frames = test::by_depth(12, 120, 120);
    const test::ExactPixels reference(*scene, 256);
    test::on_one_context([&](test::GpuSession& session) {
        std::vector<Flicker> all(static_cast<std::size_t>(kFlickerWidth) * kFlickerHeight);
        for (int i = 0; i < frames; ++i) {
            REQUIRE(session.renderer->prepare(frame(*scene, i)));
            const Image<unsigned char> shown = session.renderer->picture8();
            for (std::size_t k = 0; k < all.size(); ++k) all[k].add(&shown.data[3 * k]);
        }
        // The reference at those that flicker most.
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[k].most > 0) order.push_back(k);
        std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return all[a].most > all[b].most; });
        REQUIRE(!order.empty());
        order.resize(std::min<std::size_t>(order.size(), 1000));
        test::Places places;
        for (const std::size_t k : order)
            places.push_back({static_cast<int>(k % kFlickerWidth), static_cast<int>(k / kFlickerWidth)});
        std::vector<Flicker> exact(order.size());
        for (int i = 0; i < frames; ++i) {
            const auto shown = reference.shown(frame(*scene, i), 16, places);
            for (std::size_t k = 0; k < places.size(); ++k) exact[k].add(&shown.data[3 * k]);
        }
        std::vector<double> over;
        double most = 0, most_exact = 0;
        for (std::size_t k = 0; k < order.size(); ++k) {
            most = std::max(most, all[order[k]].most), most_exact = std::max(most_exact, exact[k].most);
            over.push_back((all[order[k]].most - kStep) / std::max(1.0, exact[k].most));
        }
        std::ranges::sort(over);
        fmt::print(
            "{}: {} frames, flicker of {} pixels at most {:.0f} of 255, the reference's {:.0f}; over it {:.2f} at "
            "most, median "
            "{:.2f}\n",
            session.context->kind(), frames, order.size(), most, most_exact, over.back(), over[over.size() / 2]);
        CHECK(over[static_cast<std::size_t>(kShare * static_cast<double>(over.size()))] <= kMost);
    });
}

}  // namespace
