#include "render/moving_numbers.h"

#include <array>
#include <cmath>

#include "light/black_body.h"
#include "spacetime/axial_metric.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kCopies = 4096.0;  // DISC_COPIES of shaders/object/disc_flow.glsl

// Of A = (1 - x zeta)(1 - y zeta), by which matter goes round with w^2 = A'/(2 r) = zeta^3 ((x + y)/2 - x y zeta); about a rotating
// hole A = 1 - zeta + charge2 zeta^2 takes its place. In flat space matter rests.
std::array<double, 2> winding(const Spacetime& matter) {
    if (const AxialMetric* axial = matter.axial()) return {0.5, axial->charge2()};
    const LapseRoots roots = matter.spherical()->lapse_roots().value_or(LapseRoots{0, 0});
    return {0.5 * (roots.outer + roots.inner), roots.outer * roots.inner};
}

}  // namespace

void put_moving(FrameData& frame, const FramePlan& plan, const BallPath* ball_path) {
    const Scene& scene = plan.scene;
    const Spacetime& matter = *plan.matter;
    if (scene.disc && scene.disc->flow == DiscFlowKind::kKepler) {
        const auto [first, second] = winding(matter);
        const double lives = scene.time / scene.disc->flow_life;
        frame.disc_winding = {lives - kCopies * std::floor(lives / kCopies), 1.0 / scene.disc->flow_life, first,
                              second};
    }
    if (scene.disc && scene.spot) {
        const SpotSpec& spot = *scene.spot;
        const auto orbit = circular_orbit(matter, spot.r);
        const double omega = orbit ? orbit->omega : 0.0, lapse = std::sqrt(matter.lapse_squared(spot.r));
        frame.spot = {spot.r, std::remainder(spot.phase + omega * scene.time, 2.0 * M_PI), omega,
                      2.0 * M_PI / spot.count};
        frame.spot_look = {spot.size * spot.size, spot.brightness, std::log2(spot.temperature_K),
                           log2_brightness(spot.temperature_K, scene.light.bolometric)};
        // As disc_flow_row: g's two parts, and rays of flat space.
        double u_t = orbit ? orbit->u_t : 1.0 / lapse, u_phi = u_t * omega;
        if (!scene.light.doppler) u_t = 1.0 / lapse, u_phi = 0.0;
        if (!scene.light.gravity) u_t *= lapse, u_phi *= lapse;
        if (!scene.light.lensing) u_phi /= lapse;
        frame.spot_motion = {u_t, u_phi, 0, 0};
    }
    if (ball_path != nullptr)
        frame.ball_path = {ball_path->from, 1.0 / ball_path->step, kBallPathCells, ball_path->speed};
}

}  // namespace nullscope
