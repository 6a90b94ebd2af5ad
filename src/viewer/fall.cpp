#include "viewer/fall.h"

#include <algorithm>

#include "spacetime/registry.h"

namespace nullscope::viewer {
namespace {

constexpr double kLongest = 1e5;  // r_s/c: of an orbit, which does not end

// A camera at another's place, moving and looking as that does; its own lens and size.
CameraSpec at_place_of(CameraSpec there, const CameraSpec& own) {
    there.plane_width = own.plane_width, there.focal_distance = own.focal_distance;
    there.width = own.width, there.height = own.height, there.exposure_ev = own.exposure_ev;
    return there;
}

}  // namespace

Status Fall::let_go(const Scene& scene) {
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    TRY(line, Worldline::make(*spacetime, scene.camera, kLongest));
    line_ = std::move(*line);
    tau_ = 0.0;
    runs_ = true;
    shown_ = scene.camera;
    start_time_ = shown_time_ = scene.time;
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
    if (scene.camera != at_place_of(shown_, scene.camera) && !let_go(scene)) {
        stop();
        return false;
    }
    const double before = tau_;
    seek(scene, tau_ + rate * dt_s);
    if (tau_ >= line_->last()) runs_ = false;
    return tau_ != before;
}

}  // namespace nullscope::viewer
