// A rotating hole with charge as the driver draws it: the shadow's edge by the spherical photon orbits, and frames with everything
// that a rotating hole can have against the reference.
#include <cmath>

#include "against_reference.h"
#include "shadow_edge.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kSpin = 0.6, kCharge = 0.6;

Draft charged() {
    return Draft().metric("kerr-newman", {{"spin", kSpin}, {"charge", kCharge}}).by(ObserverKind::kZamo);
}

struct Constants {
    double lambda, eta;  // L/E and Q/E^2 of the photon orbit at constant r, M = 1
};
// With X = r^2 + a^2 - a lambda: X^2 = Delta K and 4 r X = Delta' K, so X = 4 r Delta/Delta' and K = 16 r^2 Delta/Delta'^2.
Constants spherical_orbit(double r) {
    const double delta = r * r - 2 * r + kSpin * kSpin + kCharge * kCharge, slope = 2 * r - 2;
    const double lambda = (r * r + kSpin * kSpin - 4 * r * delta / slope) / kSpin,
                 k = 16 * r * r * delta / (slope * slope);
    return {lambda, k - (lambda - kSpin) * (lambda - kSpin)};
}

// Where eta vanishes between two radii.
double equatorial(double low, double high) {
    const bool sign = spherical_orbit(low).eta > 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        ((spherical_orbit(middle).eta > 0) == sign ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Edge edge_at(double r, bool vertical, int outside) {
    const Constants of = spherical_orbit(r);
    return {of.lambda, of.eta, vertical, outside};
}

TEST_CASE(
    "kerr-newman: the shadow's edge is the critical curve of the spherical photon orbits, a = Q = 0.6 M, to 0.02 px") {
    const double prograde = equatorial(1.6, 2.8), retrograde = equatorial(2.8, 4);
    REQUIRE(std::abs(spherical_orbit(prograde).eta) < 1e-9);
    REQUIRE(std::abs(spherical_orbit(retrograde).eta) < 1e-9);
    on_every_context([&](GpuSession& session) {
        for (const Edge& edge :
             {edge_at(prograde, false, -1), edge_at(retrograde, false, 1),
              edge_at(0.5 * (prograde + retrograde), true, 1), edge_at(0.7 * prograde + 0.3 * retrograde, true, 1)}) {
            const double off = edge_off_px(session, charged(), edge, 0);
            fmt::print("{:<7} kerr-newman: lambda {:8.5f} M, eta {:8.5f} M^2: edge off by {:.5f} px at most\n",
                       session.context->kind(), edge.lambda, edge.eta, off);
            CHECK(off <= kEdge_px);
            CHECK(edge_off_px(session, charged(), edge, 1.5 * kEdge_px) > kEdge_px);  // a shifted edge is seen
        }
    });
}

TEST_CASE("kerr-newman: frames with disc, bodies, light times and falling cameras are the reference's" *
          test::costly()) {
    const auto view = [] { return charged().sky(SkyKind::kBlack).place(8, 1.3).yaw(0.1).plane(1.4).size(64, 36); };
    const BallSpec planet{.position = {4, 0, 0}, .radius = 0.7, .motion = BallMotion::kOrbit};
    const double usual = DiscSpec{}.outer;
    Draft late = view().disc(1.0, usual);
    late.scene.disc->flow = DiscFlowKind::kKepler;
    const std::vector<FrameCase> cases = {
        {"sky", view()},
        {"disc", view().disc(1.0, 7.0)},
        {"disc, light times", late},
        {"ball and cylinder", view().ball({3, 2, 0.5}, 0.8).cylinder(2, 5, 0.2)},
        {"planet", view().body(planet).at_time(20)},
        {"rain outside", view().by(ObserverKind::kRain).r(2.0)},
        // Horizons at 0.765 and 0.235 r_s.
        {"rain inside", view().by(ObserverKind::kRain).r(0.6).yaw(2.5).disc(1.2, usual)},
        {"moving", view().moving({0.3, 0.2, -0.4})}};
    AgainstReference judge("kerr-newman", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920});
    on_one_context([&](GpuSession& session) { judge.frames(session, Selection(1), cases); });
}

}  // namespace
