// Through the horizon as OpenGL draws it: the shadow of observers that fall, and a plunge without a seam or a jump.
#include <algorithm>
#include <cmath>

#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kPlungeWidth = 24, kPlungeHeight = 14;

// Looks aside: hole, rim and sky, and the disc, are all in the picture.
Scene falling_at(double r, bool disc) {
    Scene scene;
    scene.name = "plunge";
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.r = r;
    scene.camera.theta = 1.2;
    scene.camera.observer = ObserverKind::kRain;
    scene.camera.yaw = 100 * M_PI / 180;
    scene.camera.width = kPlungeWidth, scene.camera.height = kPlungeHeight;
    scene.camera.plane_width = 2 * std::tan(65 * M_PI / 180);
    if (disc) scene.disc.emplace();
    return scene;
}

struct PlungeJumps {
    double most = 0;  // what OpenGL's directions change by in a step beyond what the reference's do, rad
    int fates = 0;    // pixels of another fate
    int judged = 0, skies = 0;
};

// Rays that wind: a step of the camera turns their sky by more than this, and nothing follows.
constexpr double kPlungeWinds = 0.1;

void plunge_judge(const RayFrame& gl_before, const RayFrame& gl, const RayFrame& exact_before, const RayFrame& exact,
                  PlungeJumps& jumps) {
    for (std::size_t i = 0; i < gl.pixels.size(); ++i) {
        jumps.fates += gl.pixels[i].fate != exact.pixels[i].fate;
        if (gl.pixels[i].fate != Fate::kEscaped || exact.pixels[i].fate != Fate::kEscaped) continue;
        ++jumps.skies;
        if (gl_before.pixels.empty() || gl_before.pixels[i].fate != Fate::kEscaped ||
            exact_before.pixels[i].fate != Fate::kEscaped)
            continue;
        const double step = angle_between(exact.pixels[i].sky, exact_before.pixels[i].sky);
        if (step > kPlungeWinds) continue;
        ++jumps.judged;
        jumps.most = std::max(jumps.most, angle_between(gl.pixels[i].sky, gl_before.pixels[i].sky) - step);
    }
}

// What a step may add: twice the error of a direction, float and straight lines (docs/accuracy.md: 2e-6 rad), where the sky turns ten times
// as fast as the pixel.
constexpr double kPlungeJump = 4e-5;  // measured 1e-5

TEST_CASE("plunge: from 3 r_s to 0.01 r_s no ray jumps by more than the reference's, and none has another fate" *
          test::costly()) {
    on_one_context([](GpuSession& session) {
        const int steps = by_depth(400, 2000, 2000);
        for (const bool disc : {false, true}) {
            PlungeJumps jumps;
            RayFrame gl_before, exact_before;
            for (int i = 0; i <= steps; i += disc ? 10 : 1) {
                const Scene scene = falling_at(3.0 * std::pow(0.01 / 3.0, static_cast<double>(i) / steps), disc);
                RayFrame gl = gl_ray_data(session, scene), exact = reference_frame(scene);
                if (disc) gl_before.pixels.clear();  // ten steps at once: only fates
                plunge_judge(gl_before, gl, exact_before, exact, jumps);
                gl_before = std::move(gl), exact_before = std::move(exact);
            }
            fmt::print(
                "{:<7} {}{} steps: {} directions, largest jump beyond the reference's {:.1e} rad; other fates {}\n",
                session.context->kind(), disc ? "with a disc, " : "", steps, jumps.judged, jumps.most, jumps.fates);
            CHECK(jumps.most < kPlungeJump);
            CHECK(jumps.fates == 0);
            CHECK(jumps.skies > 50 * steps / (disc ? 20 : 1));
        }
        // That it can fail: the frame of another radius.
        PlungeJumps planted;
        const Scene here = falling_at(1.0, false), there = falling_at(1.001, false);
        plunge_judge(gl_ray_data(session, there), gl_ray_data(session, here), reference_frame(here),
                     reference_frame(here), planted);
        CHECK(planted.most > kPlungeJump);
    });
}

// The edge of the shadow on a row of pixels through the picture's middle, in px from it; the camera looks at where it should be.
double edge_off_px(GpuSession& session, double r, double half_angle) {
    constexpr double kPixel_rad = 60.0 / 3840 * M_PI / 180;  // 4K over 60 degrees
    constexpr int kColumns = 401;
    constexpr double kWidth_px = 0.04;
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.r = r;
    scene.camera.observer = ObserverKind::kRain;
    scene.camera.yaw = half_angle;
    scene.camera.width = kColumns, scene.camera.height = 1;
    scene.camera.plane_width = kWidth_px * kPixel_rad;
    const RayFrame frame = gl_ray_data(session, scene);
    double worst = 0;
    for (int i = 0; i < kColumns; ++i) {
        const double from_edge = (i - kColumns / 2) * kWidth_px / kColumns;
        if ((frame.at(i, 0).fate == Fate::kEscaped) != (from_edge > 0)) worst = std::max(worst, std::fabs(from_edge));
    }
    return worst;
}

TEST_CASE("plunge: the shadow of the rain observer to 0.01 px of a 4K frame") {
    static constexpr double kPromised_px = 0.01;
    on_every_context([](GpuSession& session) {
        for (const auto& [r, degrees] :
             {std::pair{1.5, 35.2643896828}, {1.0, 42.1034488707}, {0.5, 53.2702658035}, {0.05, 77.3257155812}}) {
            const double off = edge_off_px(session, r, degrees * M_PI / 180);
            fmt::print("{:<7} r {:<5} half-angle {} deg, edge off by {:.5f} px at most\n", session.context->kind(), r,
                       degrees, off);
            CHECK(off <= kPromised_px);
        }
        CHECK(edge_off_px(session, 1.0, (42.1034488707 + 1e-5) * M_PI / 180) > kPromised_px * 0.05);
    });
}

}  // namespace
