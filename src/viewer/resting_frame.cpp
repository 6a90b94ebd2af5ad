#include "viewer/resting_frame.h"

#include <algorithm>
#include <limits>

#include "plan/effects.h"
#include "plan/moving.h"
#include "viewer/window.h"

namespace nullscope::viewer {
namespace {

constexpr double kRest = 0.2;  // s without a change before rays are asked for

// Colours and brightness apart.
bool same_rays(const Scene& a, const Scene& b) {
    CameraSpec exposed = a.camera;
    exposed.exposure_ev = b.camera.exposure_ev;
    if (exposed != b.camera || a.spacetime != b.spacetime) return false;
    if (effect_set(required_effects(a)) != effect_set(required_effects(b))) return false;
    const auto same_solid = [](const Body& x, const Body& y) { return x.shape == y.shape && x.far == y.far; };
    if (!std::ranges::equal(a.bodies, b.bodies, same_solid)) return false;
    if (a.light.aberration != b.light.aberration || a.light.doppler != b.light.doppler ||
        a.light.gravity != b.light.gravity)
        return false;
    if (changes_with_time(a) && (a.time != b.time || a.light.delay != b.light.delay)) return false;
    if (a.disc.has_value() != b.disc.has_value()) return false;
    return !a.disc ||
           (a.disc->inner == b.disc->inner && a.disc->outer == b.disc->outer && a.disc->lean == b.disc->lean &&
            a.disc->warp == b.disc->warp && (a.disc->opacity < 1.0) == (b.disc->opacity < 1.0));
}

}  // namespace

bool RestingFrame::frame_is(const Scene& scene, const Method& method) {
    if (same_rays(scene, scene_) && method == method_) return false;
    scene_ = scene;
    method_ = method;
    has_rays_ = asks_ = false;
    changed_at_ = seconds();
    return true;
}

void RestingFrame::update(bool wanted, bool moving) {
    wanted_ = wanted;
    asks_ = wanted && !has_rays_ && !moving && seconds() - changed_at_ >= kRest;
}

bool RestingFrame::takes(const Scene& scene) {
    if (!asks_ || !same_rays(scene, scene_)) return false;
    asks_ = false;
    return has_rays_ = true;
}

double RestingFrame::wait() const {
    if (!wanted_ || has_rays_ || asks_) return std::numeric_limits<double>::infinity();
    return std::max(changed_at_ + kRest - seconds(), 0.001);
}

}  // namespace nullscope::viewer
