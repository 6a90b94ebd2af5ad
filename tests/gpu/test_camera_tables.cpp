// Tables of a camera that moves along the radius, between those at steps, against those that are built for its radius.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "render/frame_tables.h"
#include "support/costly.h"
#include "support/depth.h"

using namespace nullscope;

namespace {

constexpr double kMove = 4e-3;  // of the radius, from frame to frame: an eighth of a step
constexpr int kStart = 5;       // frames until the tables at four steps are there
constexpr double kBeside_px = 1e-3;
constexpr double kMostOff_px = 1e-3;  // measured 4.8e-4, beside the shadow
// Of the delay, and of its change from pixel to pixel. The texels' own rounding: steps half as long change nothing.
constexpr double kDelay = 1e-4, kDelayPerPixel = 1e-3;

double distance(const RayPixel& a, const RayPixel& b) {
    return a.fate == Fate::kHit ? std::hypot(a.u - b.u, a.v - b.v, a.w - b.w) : length(a.sky - b.sky);
}

struct Off {
    double px = 0, delay = 0;  // delay: of what is allowed
    int rays = 0, fates = 0;
};

void compare(const CoreInput& between, const CoreInput& built, const CameraSpec& camera, Off& off) {
    for (int y = 3; y < camera.height; y += 13)
        for (int x = 1; x < camera.width; x += 17) {
            const double px = x + 0.5 - 0.5 * camera.width, py = y + 0.5 - 0.5 * camera.height;
            const RayPixel one = trace_core64(between, px, py), other = trace_core64(built, px, py),
                           right = trace_core64(built, px + kBeside_px, py),
                           above = trace_core64(built, px, py + kBeside_px);
            ++off.rays;
            if (one.fate != other.fate) {  // an edge so near by?
                const Fate left = trace_core64(built, px - kBeside_px, py).fate,
                           below = trace_core64(built, px, py - kBeside_px).fate;
                off.fates += right.fate != one.fate && above.fate != one.fate && left != one.fate && below != one.fate;
            }
            if (one.fate != other.fate || right.fate != other.fate || above.fate != other.fate ||
                other.fate == Fate::kCaptured)
                continue;
            const double a_pixel = std::max(distance(right, other), distance(above, other)) / kBeside_px;
            off.px = std::max(off.px, distance(one, other) / a_pixel);
            const double change = std::max(std::fabs(right.delay - other.delay), std::fabs(above.delay - other.delay));
            const double allowed =
                kDelay * std::max(1.0, std::fabs(other.delay)) + kDelayPerPixel * change / kBeside_px;
            off.delay = std::max(off.delay, std::fabs(one.delay - other.delay) / allowed);
        }
}

TEST_CASE("camera tables: a camera that moves along the radius sees what one sees that was always there" *
          test::costly()) {
    test::Selection selection(5);  // prime to the six radii
    for (const char* metric : {"schwarzschild", "reissner-nordstrom"})
        for (const double r : {2.1, 3.0, 6.0, 12.0, 40.0, 1000.0}) {
            if (!selection.takes_next()) continue;
            Scene scene;
            scene.spacetime.metric = metric;
            if (scene.spacetime.metric == "reissner-nordstrom") scene.spacetime.parameters["charge"] = 0.9;
            scene.camera.r = r, scene.camera.width = 1280, scene.camera.height = 720;
            scene.camera.focal_distance = r < 5.0 ? 0.2 : r > 100.0 ? 30.0 : 1.0;
            scene.disc = DiscSpec{};
            FrameTables moving, still;
            moving.follow_camera();
            moving.want_delays(true), still.want_delays(true);
            Off off;
            for (int i = 0; i < kStart + 9; ++i, scene.camera.r *= 1.0 + kMove) {
                REQUIRE(moving.update(scene));
                if (i < kStart) continue;
                REQUIRE(still.update(scene));
                compare(moving.core_input(), still.core_input(), scene.camera, off);
            }
            fmt::print("{} from {}: {} rays, {} fates, {:.2g} px, delay {:.2g} of its bound\n", metric, r, off.rays,
                       off.fates, off.px, off.delay);
            CHECK(off.fates == 0);
            CHECK(off.px > 0.0);  // other tables
            CHECK(off.px < kMostOff_px);
            CHECK(off.delay < 1.0);
        }
}

TEST_CASE("camera tables: a camera that moves along the radius costs less than a quarter of building them" *
          test::costly()) {
    constexpr int kFrames = 62;        // two steps
    constexpr double kPart = 1.0 / 4;  // measured 0.09
    Scene scene;
    scene.disc = DiscSpec{};
    const auto core_s = [&](bool follows) {
        FrameTables tables;
        if (follows) tables.follow_camera();
        std::clock_t start = 0;
        scene.camera.r = 8.0;
        for (int i = -kStart; i < kFrames; ++i, scene.camera.r *= 1.001) {
            if (i == 0) start = std::clock();
            REQUIRE(tables.update(scene));
        }
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kFrames;
    };
    const double followed = core_s(true), built = core_s(false);
    fmt::print("{:.2f} core-ms a frame, built {:.2f}: {:.2f}\n", 1e3 * followed, 1e3 * built, followed / built);
    CHECK(followed < kPart * built);
}

}  // namespace
