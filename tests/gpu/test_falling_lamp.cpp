// A lamp that falls radially into a hole, between the hole and the camera: the light that it sent round the hole, as the driver draws it against the
// reference.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/assets.h"
#include "reference/reference.h"
#include "support/depth.h"
#include "support/draft.h"
#include "support/gpu_session.h"

using namespace nullscope;
using namespace nullscope::test;

namespace {

constexpr double kCamera = 20, kTurn = 16.3241942781;  // r_s; r_s/c: 3 sqrt(3) pi, of light next to the photon sphere
constexpr int kPixels = 2048;
const double kEdge = std::asin(1.5 * std::sqrt(3.0) * std::sqrt(1 - 1 / kCamera) / kCamera);  // of the shadow, rad

// A row of pixels across the shadow's edge.
Scene row_of(double time, double width) {
    Draft draft;
    draft.metric("schwarzschild").place(kCamera, M_PI / 2).size(kPixels, 1).yaw(kEdge).plane(width);
    draft.sky(SkyKind::kBlack).at_time(time);
    draft.body(BallSpec{.position = {6, 0, 0}, .radius = 0.4, .motion = BallMotion::kGeodesic});
    Scene scene = draft;
    scene.light.bolometric = true, scene.picture.refine = false;
    scene.bodies.front().material.temperature_K = 6000, scene.bodies.front().material.colour = {1, 1, 1};
    return scene;
}

// Over the sphere of view directions: the picture is round about the line to the hole.
double flux_of(const Image<float>& row, double width) {
    double sum = 0;
    for (int x = 0; x < kPixels; ++x) {
        const double pixel = width / kPixels, u = (x + 0.5 - 0.5 * kPixels) * pixel;
        const float* rgb = row.at(x, 0);
        const double light = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        sum += light * 2 * M_PI * std::sin(kEdge + std::atan(u)) * pixel / (1 + u * u);
    }
    return sum;
}

// Light that went round the hole once more comes kTurn later, exp(-2 pi) as bright, and in a ring as much nearer to the edge: exp(-t/(3 sqrt(3) M)) (Ames
// and Thorne 1968). At these times the direct image has 1e-10 of its first light, or is not seen any more.
TEST_CASE("falling lamp: its light beside the photon sphere outlives it, and fades by exp(-2 pi) a turn") {
    constexpr double kAlike = 0.01, kFades = 0.01, kFirstFades = 0.06, kFirst = 58, kWidth = 0.0125;
    const auto sky = build_sky(row_of(kFirst, kWidth).sky, assets_directory(), 16);
    REQUIRE(sky);
    on_one_context([&](GpuSession& session) {
        double before = 0;
        for (int n = 0; n < 3; ++n) {
            const double width = kWidth * std::exp(-2 * M_PI * n);
            const Scene scene = row_of(kFirst + n * kTurn, width);
            const auto exact = reference::render_frame(scene, *sky, {}, 1);
            REQUIRE(exact);
            const double flux = flux_of(*exact, width), drawn = flux_of(picture_of(session, scene), width),
                         fades = before > 0 ? flux / before * std::exp(2 * M_PI) : 0;
            fmt::print(
                "falling lamp: turn {}: flux {:.4e}, the driver's {:.5f} of it; over that of a turn before {:.5f} "
                "exp(-2 pi)\n",
                n, flux, drawn / flux, fades);
            CHECK(std::fabs(drawn / flux - 1) < kAlike);
            if (n == 1) CHECK(std::fabs(fades - 1) < kFirstFades);
            if (n == 2) CHECK(std::fabs(fades - 1) < kFades);
            before = flux;
        }
    });
}

// Pixels beside one that shows what left after the lamp was let go, and beside none that shows earlier light: that of a lamp that rises from the past
// horizon has no bound.
std::vector<bool> since_the_start(const Scene& scene) {
    const auto rays = reference::trace_frame(scene);
    REQUIRE(rays);
    const int width = rays->width, height = rays->height;
    const auto beside = [&](int i, bool late) {
        for (int y = std::max(i / width - 1, 0); y <= std::min(i / width + 1, height - 1); ++y)
            for (int x = std::max(i % width - 1, 0); x <= std::min(i % width + 1, width - 1); ++x) {
                const RayPixel& pixel = rays->pixels[static_cast<std::size_t>(y * width + x)];
                if (pixel.hit != 0 && (pixel.delay < scene.time) == late) return true;
            }
        return false;
    };
    std::vector<bool> kept;
    for (int i = 0; i < width * height; ++i) kept.push_back(beside(i, true) && !beside(i, false));
    return kept;
}

// About a rotating hole, whose horizon drags it round.
TEST_CASE("falling lamp: about a rotating hole it has the reference's flux" * test::costly()) {
    constexpr double kSame = 0.01;
    constexpr int kSamples = 4;
    on_one_context([&](GpuSession& session) {
        double first = 0, last = 0;
        for (const double time : {14.0, 20.0, 25.0}) {
            Draft draft;
            draft.metric("kerr", {{"spin", 0.9}}).place(12, 1.2).by(ObserverKind::kZamo).size(48, 36).plane(0.9);
            draft.sky(SkyKind::kBlack).at_time(time);
            draft.body(BallSpec{.position = {3, -3, 1}, .radius = 1.2, .motion = BallMotion::kGeodesic});
            Scene scene = draft;
            scene.light.bolometric = true;
            scene.bodies.front().material.temperature_K = 6000, scene.bodies.front().material.colour = {1, 1, 1};
            const auto sky = build_sky(scene.sky, assets_directory(), 16);
            REQUIRE(sky);
            const std::vector<bool> kept = since_the_start(scene);
            const auto exact = reference::render_frame(scene, *sky, {}, kSamples);
            REQUIRE(exact);
            scene.picture.samples = kSamples;
            const Image<float> drawn = picture_of(session, scene);
            const auto sum = [&](const Image<float>& image) {
                double all = 0;
                for (std::size_t i = 0; i < image.data.size(); ++i) all += kept[i / 3] ? image.data[i] : 0;
                return all;
            };
            last = sum(*exact);
            fmt::print(
                "falling lamp about a rotating hole: t = {}: the driver's flux {:.5f} of the reference's {:.3e}\n",
                time, sum(drawn) / last, last);
            CHECK(std::fabs(sum(drawn) / last - 1) < kSame);
            if (first == 0) first = last;
        }
        CHECK(last < 0.2 * first);
    });
}

}  // namespace
