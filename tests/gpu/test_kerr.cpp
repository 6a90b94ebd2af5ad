// A rotating hole, as the driver draws it: the shadow's edge where Bardeen (1973) has it, rays against the reference, and without
// spin the same picture as the table's.
#include <cmath>

#include "against_reference.h"
#include "shadow_edge.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Draft spinning(double spin) { return Draft().metric("kerr", {{"spin", spin}}).by(ObserverKind::kZamo); }

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
    std::vector<FrameCase> cases;
    for (const auto& [spin, r, theta, yaw, fov, velocity] : views)
        for (const bool disc : {false, true}) {
            Draft draft = spinning(spin)
                              .place(r, theta)
                              .yaw(yaw)
                              .plane(2 * std::tan(fov / 2))
                              .moving(velocity)
                              .size(by_depth(64, 96, 96), by_depth(36, 54, 54));
            disc ? draft.disc(1.0, 7.0) : draft.sky(SkyKind::kGrid);  // painted: rays know nothing of it
            cases.push_back({fmt::format("a = {:<6} r = {:<5} {}", spin, r, disc ? "disc" : "sky"), draft});
        }
    // Pixels of a 1080p frame: errors in those of this one are 20 times smaller.
    AgainstReference judge("kerr", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920});
    on_one_context([&](GpuSession& session) { judge.frames(session, Selection(3), cases); });
}

TEST_CASE("kerr: next to no spin is no spin, pixel for pixel within the errors of both; none is the table") {
    on_every_context([](GpuSession& session) {
        Draft still = spinning(0).r(9).size(160, 90);
        still.scene.disc = DiscSpec{};
        const RayFrame table = gl_ray_data(session, still);
        CHECK(session.renderer->tables().path().family() != nullptr);
        CHECK(session.renderer->tables().effects().contains(Effect::kLensing));
        const RayFrame steps = gl_ray_data(session, Draft(still).spin(1e-9));
        CHECK(session.renderer->tables().path().family() == nullptr);
        CHECK_FALSE(session.renderer->tables().effects().contains(Effect::kLensing));
        const Apart slow = apart(table, steps, still.scene.camera),
                    fast = apart(table, gl_ray_data(session, Draft(still).spin(0.1)), still.scene.camera);
        fmt::print("{:<7} spin 1e-9 against the table: {:.4f} px of 1080p, {} fates\n", session.context->kind(),
                   slow.most_px, slow.fates);
        CHECK(slow.most_px <= kEveryRay_px);
        CHECK(slow.fates == 0);
        CHECK(fast.most_px > kEveryRay_px);  // the check can fail
    });
}

}  // namespace
