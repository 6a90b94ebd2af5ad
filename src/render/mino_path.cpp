#include "render/mino_path.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "observer/spin_forms.h"
#include "observer/spin_ring.h"
#include "render/frame_numbers.h"
#include "spacetime/tortoise.h"

namespace nullscope {
namespace {

constexpr double kFarBelow = -1e30;           // every zeta
constexpr double kLeastMinoFrequency = 1e-6;  // as the shaders have it

}  // namespace

// Along (e_r, e_theta, e_phi) of the observer's own frame.
LightPath::Start MinoPath::start(const FramePlan&, const Mat3&) const { return {Mat3{}, RadialFrame{}}; }

RayNumbers MinoPath::ray_numbers(const FramePlan& plan, double theta, double phi, Vec3 n) const {
    const Vec3 ahead = plan.observer.turn * n;
    RayNumbers ray;
    ray.start = {std::sin(theta), plane_height(theta), std::cos(phi), std::sin(phi)};
    ray.ray = {direction_without_rounding(ahead), 0};
    if (plan.effects.contains(Effect::kSpinRing))
        ray.radial.x = RingOfRays(*metric_, plan.scene.camera, plan.observer).of(ahead).peak;
    return ray;
}

// shaders/mino/disc.glsl, disc_g: the photon has the ray's constants with the other sign.
double MinoPath::ray_g(const FramePlan& plan, const FrameData& frame, const RayNumbers& ray,
                       const ListedRay::Crossing& met, Vec3 u) const {
    const auto of = [&](const FrameVector& form) { return form.x + form.y * ray.ray.x + form.z * ray.ray.z; };
    const bool leans = plan.effects.contains(Effect::kDiscLean);
    const double energy = -of(frame.spin_energy), momentum = leans ? met.climb : -of(frame.spin_across) * ray.start.x;
    const double frequency = energy * u.x - momentum * u.y - met.climb * u.z;
    return 1.0 / (frequency < kLeastMinoFrequency ? kLeastMinoFrequency : frequency);
}

// The root of Carter's constant in the plane: p_theta^2 + cos^2(theta) (L^2/sin^2(theta) - a^2 E^2). A ray that has left upward comes down first.
PolarisedPhoton MinoPath::photon_of(const FrameData& frame, const RayNumbers& ray, const ListedRay::Crossing& met,
                                    int number) const {
    const auto of = [&](const FrameVector& form) { return form.x + form.y * ray.ray.x + form.z * ray.ray.z; };
    const double energy = -of(frame.spin_energy), across = -of(frame.spin_across),
                 p_theta = frame.spin_energy.w * ray.ray.y, cosine = ray.start.y, a = metric_->a();
    const double square = p_theta * p_theta + cosine * cosine * (across * across - a * a * energy * energy);
    const bool above = cosine != 0.0 ? cosine > 0.0 : ray.ray.y < 0.0, down = above == (number % 2 == 1);
    return {energy, across * ray.start.x, met.climb, std::sqrt(std::fmax(square, 0.0)) * (down ? -1.0 : 1.0)};
}

void MinoPath::write(const FramePlan& plan, FrameData& frame) const {
    const CameraSpec& camera = plan.scene.camera;
    const SpinForms forms = spin_forms(spin_place(*metric_, camera.r, camera.theta),
                                       {plan.observer.frame, plan.observer.azimuthal_velocity});
    const double a = metric_->a(), outer = metric_->outer_horizon(), inner = metric_->inner_horizon();
    frame.spin_hole = {a, a * a, outer, inner};
    frame.spin_energy = {forms.energy.constant, forms.energy.radial, forms.energy.around, forms.p_theta};
    frame.spin_across = {forms.across.constant, forms.across.radial, forms.across.around, forms.carter};
    frame.spin_climb = {forms.climb.constant, forms.climb.radial, forms.climb.around, forms.carter_slope};
    frame.spin_place = {std::sin(camera.theta), plane_height(camera.theta), std::cos(camera.phi), std::sin(camera.phi)};
    frame.spin_turn = {camera.r > outer ? metric_->azimuth_ahead(camera.r) : 0.0, a / (outer - inner),
                       metric_->charge2(), outer - inner};
    if (plan.effects.contains(Effect::kSpinRing)) write_ring(plan, frame);
    if (plan.effects.contains(Effect::kSpinNear)) write_near(plan, frame);
    // r_* of the camera, or r where its clock is v - r: what T less r_* of a place is delayed by, and r (late_time()). From afar T is told less
    // 2 r_* of the camera, mino/kerr.glsl.
    constexpr double kAfar = 1e3;
    const bool afar = camera.r > kAfar;
    const double ahead = camera.r > outer ? time_ahead(*metric_, camera.r) : 0.0;
    frame.delay = {falls(camera) ? 2.0 * ahead : ahead, afar ? 1.0 : 0.0,
                   2.0 * camera.r + (falls(camera) ? 0.0 : ahead), 2.0 * (camera.r + ahead)};
}

void MinoPath::write_near(const FramePlan& plan, FrameData& frame) const {
    const double r = plan.scene.camera.r, outer = metric_->outer_horizon(), inner = metric_->inner_horizon();
    const SpinPlace place = spin_place(*metric_, r, plan.scene.camera.theta);
    const SpinFrame seen{plan.observer.frame, plan.observer.azimuthal_velocity};
    const SpinForms forms = spin_forms(place, seen);
    const SpinForm form = horizon_form(*metric_, place, seen);
    const double horizon = static_cast<float>(1.0 / outer);
    frame.spin_near = {form.constant, form.radial, form.around, (outer - inner) / outer};
    frame.spin_near_2 = {horizon, 1.0 / outer - horizon, (r - outer) / r, kFarBelow};
    frame.spin_near_3 = {forms.energy.of(-1, 0), forms.across.of(-1, 0), forms.climb.of(-1, 0), form.of(-1, 0)};
}

void MinoPath::write_ring(const FramePlan& plan, FrameData& frame) const {
    const auto form = peak_form(*metric_, plan.scene.camera, plan.observer, plan.scene.light);
    std::array<double, 10> c{};
    if (form) c = form->c;
    if (plan.ring) {
        c[0] = 0.0;  // the middle is on the critical curve
        frame.ring = {plan.ring->azimuth, plan.ring->lag, 2.0 * plan.ring->turns, 0};
    }
    frame.ring_peak = {c[0], c[1], c[2], c[3]};
    frame.ring_peak_2 = {c[4], c[5], c[6], c[7]};
    frame.ring_peak_3 = {c[8], c[9], form ? 1.0 : 0.0, kFarBelow};
}

void MinoPath::give(const FramePlan& plan, CoreInput& input) const {
    input.lensing = false;
    input.spin = true;
    input.spin_ring = plan.effects.contains(Effect::kSpinRing);
    input.spin_near = plan.effects.contains(Effect::kSpinNear);
    input.spin_fall = falls(plan.scene.camera);
    input.spin_delay = plan.effects.contains(Effect::kLightTimes);
}

Status MinoPath::check(const Method& method, const FramePlan& plan) const {
    const EffectSet& effects = plan.effects;
    const bool sky_alone = !falls(plan.scene.camera) && !effects.contains(Effect::kLightTimes) &&
                           !effects.contains(Effect::kDisc) && !has_solids(effects);
    const bool whole = method == Method{} || (method.kind == MethodKind::kMino && method.order == 6);
    if (whole || (counts_steps(method) && sky_alone)) return Done{};
    return bad_input(fmt::format("method {} does not work for this scene with a rotating hole", method_name(method)),
                     "auto, mino[:6[:STEP]], or without [disc], bodies, delays and falling cameras mino:4[:STEP] and "
                     "kerr-schild:STEP");
}

}  // namespace nullscope
