// The background measurement of a frame's error: the numbers of measure_rays, whole after a cancel and a restart, and no window.
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include <doctest/doctest.h>

#include "compare/heat_map.h"
#include "reference/frame_tracer.h"
#include "reference/reference.h"
#include "studio/error_watch.h"
#include "support/costly.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;
using Clock = std::chrono::steady_clock;

constexpr auto kLongest = std::chrono::seconds(60);  // whatever else the machine does

Scene small_scene(double r, int width, int height) {
    Scene scene;
    scene.camera.r = r;
    scene.camera.width = width;
    scene.camera.height = height;
    scene.disc = DiscSpec{};
    scene.disc->opacity = 0.5;  // sky and disc in one pixel
    return scene;
}

// The exact frame with errors put in: directions and places off by up to `off`, some fates wrong.
RayFrame spoilt_frame(const Scene& scene, double off) {
    auto frame = reference::trace_frame(scene);
    REQUIRE(frame);
    unsigned state = 1;
    for (RayPixel& pixel : frame->pixels) {
        state = state * 1664525u + 1013904223u;
        const double part = off * (state >> 8) / 16777216.0;
        pixel.sky = pixel.fate == Fate::kEscaped ? normalized(pixel.sky + part * Vec3{0.3, 0.5, -0.8}) : pixel.sky;
        pixel.u += pixel.hit != 0 ? 10 * part : 0;
        if (state >> 25 == 0) pixel.fate = pixel.fate == Fate::kEscaped ? Fate::kCaptured : Fate::kEscaped;
    }
    return std::move(*frame);
}

RayMeasures measured_at_once(const Scene& scene, const RayFrame& frame) {
    return measure_rays(frame, scene.camera, [&](const std::vector<std::array<double, 2>>& positions) {
        return *reference::trace_pixels(scene, positions);
    });
}

void wait_for_all(const ErrorWatch& watch) {
    const auto end = Clock::now() + kLongest;
    while (!watch.summary().complete() && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    REQUIRE(watch.summary().complete());
}

bool same(const Spread& a, const Spread& b) {
    return a.max == b.max && a.p999 == b.p999 && a.median == b.median && a.count == b.count;
}

void check_all(ErrorWatch& watch, const Scene& scene, const RayFrame& frame) {
    const RayMeasures all = measured_at_once(scene, frame);
    const ErrorSummary found = watch.summary();
    CHECK(found.measured == static_cast<long long>(all.pixels.size()));
    CHECK(found.fate_errors == all.fate_errors);
    CHECK(found.forgiven == all.forgiven);
    CHECK(same(found.sky_px, all.sky_px));
    CHECK(same(found.place_px, all.place_px));
    const std::vector<PixelErrors> pixels = watch.pixels();
    REQUIRE(pixels.size() == all.pixels.size());
    Image<unsigned char> heat;
    REQUIRE(watch.take_heat(heat));
    long long differing = 0, other_colour = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PixelErrors &a = pixels[i], &b = all.pixels[i];
        differing += a.end != b.end || a.sky_px != b.sky_px || a.place_px != b.place_px || a.angle_px != b.angle_px;
        const auto colour = heat_colour(b.screen_px(), kPixelHeat);
        other_colour +=
            !std::equal(colour.begin(), colour.end(), heat.data.begin() + static_cast<std::ptrdiff_t>(4 * i)) ||
            heat.data[4 * i + 3] != 255;
    }
    CHECK(differing == 0);
    CHECK(other_colour == 0);
    CHECK(!watch.take_heat(heat));  // nothing new since
}

TEST_CASE("errors: a frame measured tile by tile has the numbers of measure_rays") {
    std::atomic<int> news = 0;
    for (const int threads : {1, 3}) {
        const Scene scene = small_scene(12, 150, 101);  // neither is a multiple of anything
        const RayFrame frame = spoilt_frame(scene, 1e-3);
        ErrorWatch watch([&] { ++news; }, threads);
        CHECK(!watch.measuring());
        REQUIRE(watch.start(scene, frame));
        wait_for_all(watch);
        check_all(watch, scene, frame);
        CHECK(watch.summary().fate_errors > 50);
        CHECK(watch.summary().sky_px.max > 0.01);
        CHECK(!watch.measuring());
    }
    CHECK(news >= 2);
}

// With several threads a coarse task can end after the fine one of the same pixels.
TEST_CASE("errors: a coarse pixel that comes late leaves measured pixels as they are") {
    const auto colour_at = [](const ErrorMap& map, int x, int y) {
        const unsigned char* texel = map.heat().data.data() + 4 * (12 * y + x);
        return std::array<int, 4>{texel[0], texel[1], texel[2], texel[3]};
    };
    PixelErrors exact, wrong;
    exact.end = RayEnd::kSame;
    wrong.end = RayEnd::kDiffers;
    ErrorMap map(12, 8);
    map.take({{0, 0, 4, 8}, std::vector(32, exact)}, 0);
    const auto fine = colour_at(map, 3, 3);
    map.take({{4, 4, 5, 5}, {wrong}}, 8);  // its cell reaches from 0 to 8
    CHECK(colour_at(map, 3, 3) == fine);
    CHECK(colour_at(map, 4, 4) != fine);
    CHECK(colour_at(map, 7, 0) == colour_at(map, 4, 4));
    CHECK(colour_at(map, 8, 0)[3] == 0);
    map.take({{2, 2, 3, 3}, {wrong}}, 4);  // measured before
    CHECK(colour_at(map, 2, 2) == fine);
    CHECK(map.counts().measured == 33);
    CHECK(map.counts().fate_errors == 1);
}

TEST_CASE("errors: a frame smaller than the coarse grids is measured as well") {
    const Scene scene = small_scene(5, 3, 2);
    const RayFrame frame = spoilt_frame(scene, 1e-3);
    ErrorWatch watch([] {}, 1);
    REQUIRE(watch.start(scene, frame));
    wait_for_all(watch);
    check_all(watch, scene, frame);
}

// A task at a time: the reference traces many rays in less time each.
TEST_CASE("errors: the rays of a task are asked for at once, some 1.5 a pixel of all tasks" * test::costly()) {
    const Scene scene = small_scene(12, 640, 360);
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const auto frame = reference::trace_frame(scene);
    REQUIRE(frame);
    std::size_t calls = 0, rays = 0;
    const ExactTrace trace = [&](const auto& positions) {
        ++calls, rays += positions.size();
        return tracer->pixels(positions, false);
    };
    const auto tasks = error_tasks(640, 360);
    ErrorMap map(640, 360);
    for (const ErrorTask& task : tasks)
        for (const TileErrors& tile : measure_task(*frame, scene.camera, trace, task)) map.take(tile, task.step);
    CHECK(map.counts().measured == 640 * 360);
    CHECK(map.found().summary().sky_px.max < 1e-5);
    CHECK(calls == tasks.size());  // nothing is in doubt
    CHECK(rays < 1.6 * 640 * 360);
}

TEST_CASE("errors: the first numbers are those of some sixty pixels, wherever the frame is long to measure") {
    const Scene large = small_scene(12, 1280, 720);
    std::atomic<long long> first = 0;
    std::atomic<const ErrorWatch*> watching = nullptr;
    ErrorWatch watch(
        [&] {
            const ErrorWatch* w = watching;
            if (w != nullptr && first == 0) first = w->summary().measured;
        },
        1);
    watching = &watch;
    REQUIRE(watch.start(large, RayFrame{1280, 720, std::vector<RayPixel>(1280 * 720)}));
    const auto end = Clock::now() + kLongest;
    while (first == 0 && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK(first == 64);
}

TEST_CASE("errors: a restart forgets the frame before, a cancel stops it") {
    const Scene before = small_scene(12, 400, 300), after = small_scene(3, 200, 150);
    const RayFrame spoilt = spoilt_frame(before, 0.5), frame = spoilt_frame(after, 1e-4);
    ErrorWatch watch([] {}, 2);
    for (int i = 0; i < 8; ++i) {  // at other moments of the measurement each time
        REQUIRE(watch.start(before, spoilt));
        std::this_thread::sleep_for(std::chrono::milliseconds(3 * i));
        REQUIRE(watch.start(after, frame));
        CHECK(watch.summary().pixels == 200 * 150);
    }
    wait_for_all(watch);
    check_all(watch, after, frame);

    REQUIRE(watch.start(before, spoilt));
    watch.cancel();
    CHECK(!watch.measuring());
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    CHECK(!watch.summary().complete());
    Image<unsigned char> heat;
    watch.take_heat(heat);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    CHECK(!watch.take_heat(heat));  // nothing is measured any more
}

TEST_CASE("errors: cancel and end do not wait for the frame") {
    const Scene large = small_scene(12, 2000, 1500);
    std::atomic<int> news = 0;
    int at_end = 0;
    {
        ErrorWatch watch([&] { ++news; }, 1);
        for (int i = 0; i < 2; ++i) {
            REQUIRE(watch.start(large, RayFrame{2000, 1500, std::vector<RayPixel>(2000 * 1500)}));
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            if (i == 0) watch.cancel();
            CHECK(!watch.summary().complete());
        }
        at_end = news;
    }
    CHECK(news <= at_end + 1);  // the tile that was being measured; a whole frame has news every quarter of a second
}

TEST_CASE("errors: what the tracer refuses is said") {
    Scene scene = small_scene(0.5, 8, 8);
    ErrorWatch watch([] {}, 1);
    CHECK(!watch.start(scene, RayFrame{8, 8, std::vector<RayPixel>(64)}));
    CHECK(!watch.measuring());
}

}  // namespace
