// 4K frames over 90 degrees against the reference: screen error and fate. Every pixel at depth everything (some minutes), else those of
// every few rows, of which alone rays are drawn.
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kFrame4kScreenError_px = 0.05;  // the project's promise at every pixel
constexpr double kSweptError_px = 0.05;          // the same for the swept angle, which objects are placed by
constexpr double kFrequency_px = 0.05;           // and for g

Scene frame_4k(double r, double yaw_deg) {
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;  // ray data needs no sky
    scene.camera.width = 3840;
    scene.camera.height = 2160;
    scene.camera.plane_width = 2;  // 90 degrees
    scene.camera.r = r;
    scene.camera.yaw = yaw_deg * M_PI / 180;
    return scene;
}

void check_measures(const std::string& what, const RayMeasures& m) {
    fmt::print(
        "{}: screen {} px, forward {} rad, swept {} px, g {} px (max / 99.9 % / median); fate errors {}, forgiven {}, "
        "not finite {}\n",
        what, spread_text(m.sky_px), spread_text(m.forward_rad), spread_text(m.angle_px), spread_text(m.g_px),
        m.fate_errors, m.forgiven, m.not_finite);
    CHECK(m.sky_px.max <= kFrame4kScreenError_px);
    CHECK(m.angle_px.max <= kSweptError_px);
    CHECK(m.g_px.max <= kFrequency_px);
    CHECK(m.fate_errors == 0);
    CHECK(m.not_finite == 0);
}

void check_camera(double r, double yaw_deg, int row_step) {
    const Scene scene = frame_4k(r, yaw_deg);
    const std::string where = fmt::format("r {:<5} yaw {:<4}", r, yaw_deg);
    CAPTURE(where);
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        const RayFrame frame = gl_ray_data(session, scene, row_step);
        if (measured.known(where, frame)) {
            fmt::print("{} {}: the same bits\n", where, session.context->kind());
            return;
        }
        check_measures(fmt::format("{} {}", where, session.context->kind()),
                       measure_rays(frame, scene.camera, reference_trace(scene), row_step));
    });
}

const int kEveryRow = by_depth(121, 23, 1);
const int kTurnedRowStep = by_depth(241, 45, 3);  // the edge and its rings once more, aside of the picture's middle
// Views without the shadow's edge or its rings have no place for an error to hide in.
const int kSmoothRowStep = by_depth(181, 40, 8);

TEST_CASE("4K: cameras that look at the hole" * test::costly()) {
    for (const double r : {1.1, 1.5, 2.0, 5.0, 20.0, 1000.0}) check_camera(r, 0, kEveryRow);
}

TEST_CASE("4K: cameras turned by 60 degrees" * test::costly()) {
    for (const double r : {1.1, 1.5, 2.0, 5.0}) check_camera(r, 60, kTurnedRowStep);
    for (const double r : {20.0, 1000.0}) check_camera(r, 60, kSmoothRowStep);  // the hole is out of sight
}

TEST_CASE("4K: cameras that look away from the hole" * test::costly()) {
    check_camera(1.1, 180, kEveryRow);  // the edge is ahead
    for (const double r : {1.5, 2.0, 5.0, 20.0, 1000.0}) check_camera(r, 180, kSmoothRowStep);
}

}  // namespace
