// 4K frames over 90 degrees against the reference: screen error and fate. Every pixel at depth everything (some minutes), else those of
// every few rows, of which alone rays are drawn.
#include "against_reference.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

void check_cameras(std::initializer_list<double> radii, double yaw_deg, int row_step) {
    // The project's promise at every pixel; the same for the swept angle, which objects are placed by, and for g.
    AgainstReference judge("4K", {.sky = kEveryRay_px, .swept = kEveryRay_px, .g = kEveryRay_px});
    on_every_context([&](GpuSession& session) {
        for (const double r : radii)
            judge.frame(session, fmt::format("r {:<5} yaw {:<4}", r, yaw_deg),
                        Draft().sky(SkyKind::kBlack).size(3840, 2160).plane(2).r(r).yaw(yaw_deg * M_PI / 180),
                        row_step);
    });
}

const int kEveryRow = by_depth(121, 23, 1);
const int kTurnedRowStep = by_depth(241, 45, 3);  // the edge and its rings once more, aside of the picture's middle
// Views without the shadow's edge or its rings have no place for an error to hide in.
const int kSmoothRowStep = by_depth(181, 40, 8);

TEST_CASE("4K: cameras that look at the hole" * test::costly()) {
    check_cameras({1.1, 1.5, 2.0, 5.0, 20.0, 1000.0}, 0, kEveryRow);
}

TEST_CASE("4K: cameras turned by 60 degrees" * test::costly()) {
    check_cameras({1.1, 1.5, 2.0, 5.0}, 60, kTurnedRowStep);
    check_cameras({20.0, 1000.0}, 60, kSmoothRowStep);  // the hole is out of sight
}

TEST_CASE("4K: cameras that look away from the hole" * test::costly()) {
    check_cameras({1.1}, 180, kEveryRow);  // the edge is ahead
    check_cameras({1.5, 2.0, 5.0, 20.0, 1000.0}, 180, kSmoothRowStep);
}

}  // namespace
