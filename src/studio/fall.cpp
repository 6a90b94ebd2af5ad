#include "studio/fall.h"

#include <algorithm>
#include <cmath>

#include "spacetime/registry.h"

namespace nullscope::viewer {
namespace {

constexpr double kLongest = 1e5;       // r_s/c: of an orbit, which does not end
constexpr double kFreeFalls = 4.0;     // of a worldline from afar: from rest at r it takes pi/2 r^(3/2) to the hole
constexpr double kWhole_s = 20.0;      // of a fall
constexpr double kSlowestFall = 0.25;  // r_s/c a second, where it ends

// A camera at another's place, moving and looking as that does; its own lens and size.
CameraSpec at_place_of(CameraSpec there, const CameraSpec& own) {
    there.plane_width = own.plane_width, there.focal_distance = own.focal_distance;
    there.width = own.width, there.height = own.height, there.exposure_ev = own.exposure_ev;
    return there;
}

// Of d(left)/dt = -(least + slowing left), from `whole` to 0 in kWhole_s: log(1 + slowing whole/least) = slowing kWhole_s.
double slowing_of(double whole, double least) {
    constexpr int kIterations = 60;
    if (whole <= least * kWhole_s) return 0.0;
    double slowing = 10.0;  // 1/s, more than any
    for (int i = 0; i < kIterations; ++i) slowing = std::log1p(slowing * whole / least) / kWhole_s;
    return slowing;
}

}  // namespace

Status Fall::let_go(const Scene& scene) {
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    const double longest = std::max(kLongest, kFreeFalls * std::pow(std::fabs(scene.camera.r), 1.5));
    TRY(line, Worldline::make(*spacetime, scene.camera, longest));
    line_ = std::move(*line);
    tau_ = 0.0;
    runs_ = true;
    shown_ = scene.camera;
    start_time_ = shown_time_ = scene.time;
    const bool ends = line_->end() != WorldlineEnd::kOpen;
    least_ = ends ? std::min(line_->last() / kWhole_s, kSlowestFall) : 1.0;
    slowing_ = ends ? slowing_of(line_->last(), least_) : 0.0;
    return Done{};
}

void Fall::seek(Scene& scene, double tau) {
    tau_ = std::clamp(tau, 0.0, line_->last());
    scene.camera = shown_ = at_place_of(line_->at(tau_), scene.camera);
    start_time_ += scene.time - shown_time_;  // who set the clock sets it for the whole fall
    scene.time = shown_time_ = start_time_ + line_->clock(tau_);
}

bool Fall::step(Scene& scene, double dt_s) {
    if (!active() || !runs_) return false;
    if (scene.camera != at_place_of(shown_, scene.camera)) {
        const double least = least_, slowing = slowing_;
        if (!let_go(scene)) return stop(), false;
        least_ = least, slowing_ = slowing;  // else who turns all the time would never be there
    }
    const double before = tau_, passed = haste * dt_s;
    seek(scene,
         tau_ + (slowing_ > 0.0 ? (left() + least_ / slowing_) * -std::expm1(-slowing_ * passed) : least_ * passed));
    if (tau_ >= line_->last()) runs_ = false;
    return tau_ != before;
}

}  // namespace nullscope::viewer
