// The shadow's size: a static camera at rho = r / r_s sees the edge at the half-angle a with
// sin^2 a = (27/4) (rho - 1) / rho^3 (Synge 1966), obtuse inside the photon sphere, rho < 3/2.
#include <algorithm>
#include <cmath>

#include "shadow_edge.h"
#include "support/draft.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// A 4K frame over 60 degrees, the smaller of the two usual ones.
constexpr double kShadowPixel_rad = 60.0 / 3840 * M_PI / 180;
constexpr double kTolerance_px = 0.01;                 // the promise of the project for edges
constexpr double kShadowWidth_px = 4 * kTolerance_px;  // steps of 1e-4 px, below a float's rounding

double shadow_half_angle(double rho) {
    const double sine = std::sqrt(27.0 / 4 * (rho - 1)) / std::pow(rho, 1.5);
    const double acute = std::asin(std::min(sine, 1.0));
    return rho < 1.5 ? M_PI - acute : acute;
}

// A strip across the expected edge, seen by a camera turned to it.
Scene strip_at(double rho, double angle, bool horizontal) {
    Draft draft = Draft().sky(SkyKind::kBlack).r(rho).size(horizontal ? kColumns : 1, horizontal ? 1 : kColumns);
    (horizontal ? draft.scene.camera.yaw : draft.scene.camera.pitch) = angle;
    return draft.plane(kShadowWidth_px * kShadowPixel_rad * (horizontal ? 1.0 : 1.0 / kColumns));
}

TEST_CASE("shadow: half-angle of a static camera to 0.01 px of a 4K frame") {
    on_every_context([](GpuSession& session) {
        for (const double rho : {1.05, 1.5, 2.0, 3.0, 5.0, 11.0, 15.0, 100.0}) {
            const double angle = shadow_half_angle(rho);
            CAPTURE(rho);
            double worst = 0;
            for (const bool horizontal : {true, false})
                for (const int side : {1, -1}) {
                    // On the other side of the hole the edge is crossed the other way round.
                    const RayFrame frame = gl_ray_data(session, strip_at(rho, side * angle, horizontal));
                    worst = std::max(worst, furthest_wrong_px(frame, kShadowWidth_px / kColumns, side));
                }
            fmt::print("{:<7} rho {:<6} half-angle {:.9f} rad, edge off by {:.5f} px at most\n",
                       session.context->kind(), rho, angle, worst);
            CHECK(worst <= kTolerance_px);
        }
    });
}

TEST_CASE("shadow: the formula's own values") {
    CHECK(shadow_half_angle(1.5) == doctest::Approx(M_PI / 2).epsilon(1e-7));
    CHECK(shadow_half_angle(3) == doctest::Approx(M_PI / 4).epsilon(1e-12));  // sin^2 = 1/2
    CHECK(shadow_half_angle(1.05) > M_PI / 2);
}

}  // namespace
