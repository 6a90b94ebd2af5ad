// Through the horizon as OpenGL draws it: the shadow of observers that fall, and a plunge without a seam or a jump.
#include <cmath>

#include "jumps.h"
#include "shadow_edge.h"
#include "support/draft.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Looks aside: hole, rim and sky, and the disc, are all in the picture.
Scene falling_at(double r, bool disc) {
    Draft draft;
    draft.sky(SkyKind::kBlack).place(r, 1.2).by(ObserverKind::kRain).yaw(100 * M_PI / 180);
    draft.size(24, 14).plane(2 * std::tan(65 * M_PI / 180));
    draft.scene.name = "plunge";
    if (disc) draft.scene.disc.emplace();
    return draft;
}

// What a step may add: twice the error of a direction, float and straight lines (docs/accuracy.md: 2e-6 rad), where the sky turns ten times
// as fast as the pixel.
constexpr double kPlungeJump = 4e-5;  // measured 1e-5

TEST_CASE("plunge: from 3 r_s to 0.01 r_s no ray jumps by more than the reference's, and none has another fate" *
          test::costly()) {
    on_one_context([](GpuSession& session) {
        const int steps = by_depth(400, 2000, 2000);
        for (const bool disc : {false, true}) {
            const Jumps jumps = jumps_of(session, steps, disc ? 10 : 1, disc, [&](int i) {
                return falling_at(3.0 * std::pow(0.01 / 3.0, static_cast<double>(i) / steps), disc);
            });
            fmt::print(
                "{:<7} {}{} steps: {} directions, largest jump beyond the reference's {:.1e} rad; other fates {}\n",
                session.context->kind(), disc ? "with a disc, " : "", steps, jumps.judged, jumps.most, jumps.fates);
            CHECK(jumps.most < kPlungeJump);
            CHECK(jumps.skies > 50 * steps / (disc ? 20 : 1));
        }
        // That it can fail: the frame of another radius.
        CHECK(planted_jump(session, falling_at(1.0, false), falling_at(1.001, false)) > kPlungeJump);
    });
}

// The edge of the shadow on a row of pixels through the picture's middle, in px from it; the camera looks at where it should be.
double edge_off_px(GpuSession& session, double r, double half_angle) {
    constexpr double kPixel4K_rad = 60.0 / 3840 * M_PI / 180;  // 4K over 60 degrees
    constexpr double kWidth_px = 0.04;
    return furthest_wrong_px(gl_ray_data(session, Draft()
                                                      .sky(SkyKind::kBlack)
                                                      .r(r)
                                                      .by(ObserverKind::kRain)
                                                      .yaw(half_angle)
                                                      .size(kColumns, 1)
                                                      .plane(kWidth_px * kPixel4K_rad)),
                             kWidth_px / kColumns, 1);
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
