// A rotating hole, as the driver draws it: the shadow's edge where Bardeen (1973) has it, rays against the reference, and without
// spin the same picture as the table's.
#include <algorithm>
#include <cmath>

#include "reference/frame_tracer.h"
#include "shadow_edge.h"
#include "support/gpu_session.h"
#include "support/metrics.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kRays_px = 0.05;  // what is promised of every ray

Scene spinning(double spin) {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", spin}}};
    scene.camera.observer = ObserverKind::kZamo;
    return scene;
}

TEST_CASE("kerr: the shadow of an equatorial observer far away, to 0.02 px of a frame that it fills") {
    const std::tuple<double, double, double> kShadows[] = {{0.5, 4.096266658713868, 6.13815572471545},
                                                           {0.998, 2.110887794552831, 6.996666271399961}};
    on_every_context([&](GpuSession& session) {
        for (const auto& [spin, prograde, retrograde] : kShadows) {
            const Edge edges[] = {{prograde, 0, false, -1}, {-retrograde, 0, false, 1}, {-2 * spin, 27, true, 1}};
            for (const Edge& edge : edges) {
                const double off = edge_off_px(session, spinning(spin), edge, 0);
                fmt::print("{:<7} a = {:<5} lambda {:9.5f} eta {:2}: edge off by {:.5f} px at most\n",
                           session.context->kind(), spin, edge.lambda, edge.eta, off);
                CHECK(off <= kEdge_px);
                CHECK(edge_off_px(session, spinning(spin), edge, 1.5 * kEdge_px) > kEdge_px);  // a shifted edge is seen
            }
        }
    });
}

TEST_CASE("kerr: frames near and far are the reference's, disc and all" * test::costly()) {
    struct View {
        double spin, r, theta, yaw, fov;
        Vec3 velocity;
    };
    const View views[] = {
        {0.9, 5, 1.3, 0, 1.6, {}},      {0.998, 3, 1.5, 0.4, 1.6, {}},     {0.9999, 15, 1.4, 0, 0.8, {0.2, 0, 0.3}},
        {0.5, 50, 0.4, 0, 0.3, {}},     {0.998, 1.25, 1.2, 1.2, 1.9, {}},  {0.7, 8, 0, 0.2, 1.2, {}},
        {0.9, 1.0, M_PI / 2, 2, 2, {}}, {0.95, 6, 3.0, 0, 1, {-0.6, 0, 0}}};
    on_one_context([&](GpuSession& session) {
        Selection selection(3);
        for (const View& view : views) {
            for (const bool disc : {false, true}) {
                if (!selection.takes_next()) continue;
                Scene scene = spinning(view.spin);
                scene.camera.r = view.r, scene.camera.theta = view.theta, scene.camera.yaw = view.yaw;
                scene.camera.plane_width = 2 * std::tan(view.fov / 2), scene.camera.width = by_depth(64, 96, 96),
                scene.camera.height = by_depth(36, 54, 54);
                scene.camera.velocity = view.velocity;
                if (disc) scene.disc = DiscSpec{}, scene.disc->inner = 1.0, scene.disc->outer = 7.0;
                if (!disc) scene.sky.kind = SkyKind::kGrid;  // painted: rays know nothing of it
                // Pixels of a 1080p frame: errors in those of this one are 20 times smaller.
                const RayMeasures m = measure_rays(gl_ray_data(session, scene), scene.camera, reference_trace(scene));
                const double finer = 1920.0 / scene.camera.width;
                fmt::print("a = {:<6} r = {:<5} {:<5}: sky {:.4f}, disc {:.4f}, g {:.4f} px of 1080p; fate errors {}\n",
                           view.spin, view.r, disc ? "disc" : "sky", m.sky_px.max * finer, m.place_px.max * finer,
                           m.g_px.max * finer, m.fate_errors);
                CHECK(m.sky_px.max * finer <= kRays_px);
                CHECK(m.place_px.max * finer <= kRays_px);
                CHECK(m.fate_errors == 0);
                CHECK(m.not_finite == 0);
            }
        }
    });
}

TEST_CASE("kerr: next to no spin is no spin, pixel for pixel within the errors of both; none is the table") {
    on_every_context([](GpuSession& session) {
        Scene still = spinning(0);
        still.camera.r = 9, still.camera.width = 160, still.camera.height = 90;
        still.disc = DiscSpec{};
        const RayFrame table = gl_ray_data(session, still);
        CHECK(session.renderer->tables().path().family() != nullptr);
        CHECK(session.renderer->tables().effects().contains(Effect::kLensing));
        Scene slow = still;
        slow.spacetime.parameters["spin"] = 1e-9;
        const RayFrame steps = gl_ray_data(session, slow);
        CHECK(session.renderer->tables().path().family() == nullptr);
        CHECK_FALSE(session.renderer->tables().effects().contains(Effect::kLensing));
        Scene fast = still;
        fast.spacetime.parameters["spin"] = 0.1;
        const RayFrame other = gl_ray_data(session, fast);
        const double pixel = still.camera.plane_width / 1920;
        const auto furthest = [&](const RayFrame& frame) {
            double most = 0;
            int fates = 0;
            for (int y = 1; y + 1 < frame.height; ++y)
                for (int x = 1; x + 1 < frame.width; ++x) {
                    const RayPixel &a = table.at(x, y), &b = frame.at(x, y), &right = table.at(x + 1, y),
                                   &down = table.at(x, y + 1);
                    fates += a.fate != b.fate;
                    if (a.fate != Fate::kEscaped || b.fate != a.fate || right.fate != a.fate || down.fate != a.fate)
                        continue;
                    const double sway = std::max(
                        {length(right.sky - a.sky) / (12 * pixel), length(down.sky - a.sky) / (12 * pixel), 1.0});
                    most = std::max(most, length(a.sky - b.sky) / sway / pixel);
                }
            return std::pair{most, fates};
        };
        const auto [off, fates] = furthest(steps);
        fmt::print("{:<7} spin 1e-9 against the table: {:.4f} px of 1080p, {} fates\n", session.context->kind(), off,
                   fates);
        CHECK(off <= kRays_px);
        CHECK(fates == 0);
        CHECK(furthest(other).first > kRays_px);  // the check can fail
    });
}

}  // namespace
