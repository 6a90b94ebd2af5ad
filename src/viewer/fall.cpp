#include "viewer/fall.h"

#include <algorithm>
#include <tuple>

#include "spacetime/registry.h"

namespace nullscope::viewer {
namespace {

constexpr double kLongest = 1e5;  // r_s/c: of an orbit, which does not end

auto place_of(const CameraSpec& c) {
    return std::tuple(c.r, c.theta, c.phi, c.yaw, c.pitch, c.roll, c.velocity.x, c.velocity.y, c.velocity.z,
                      c.observer);
}

}  // namespace

Status Fall::let_go(const Scene& scene) {
    auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (!spacetime) return spacetime.error();
    auto line = Worldline::make(*spacetime, scene.camera, kLongest);
    if (!line) return line.error();
    line_ = std::move(*line);
    tau_ = 0.0;
    runs_ = true;
    shown_ = scene.camera;
    start_time_ = shown_time_ = scene.time;
    return Done{};
}

void Fall::seek(Scene& scene, double tau) {
    tau_ = std::clamp(tau, 0.0, line_->last());
    const CameraSpec there = line_->at(tau_);
    CameraSpec& camera = scene.camera;
    camera.r = there.r, camera.theta = there.theta, camera.phi = there.phi;
    camera.yaw = there.yaw, camera.pitch = there.pitch, camera.roll = there.roll;
    camera.velocity = there.velocity, camera.observer = there.observer;
    shown_ = camera;
    start_time_ += scene.time - shown_time_;  // who set the clock sets it for the whole fall
    scene.time = shown_time_ = start_time_ + line_->clock(tau_);
}

bool Fall::step(Scene& scene, double dt_s) {
    if (!active() || !runs_) return false;
    if (place_of(scene.camera) != place_of(shown_)) {
        if (!let_go(scene)) {
            stop();
            return false;
        }
    }
    const double before = tau_;
    seek(scene, tau_ + rate * dt_s);
    if (tau_ >= line_->last()) runs_ = false;
    return tau_ != before;
}

}  // namespace nullscope::viewer
