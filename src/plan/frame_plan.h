// What a frame is made of: decided once from its scene, then handed down to tables, uniforms, shader texts and passes.
#pragma once
#include <memory>
#include <vector>

#include "base/result.h"
#include "observer/observer.h"
#include "observer/ring_view.h"
#include "plan/effects.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct FramePlan {
    Scene scene;                              // of a zoom, with the camera that shows the same as it
    std::optional<RingView> ring;             // of a zoom
    std::shared_ptr<const Spacetime> matter;  // the scene's: observers, and the matter that light comes from
    std::shared_ptr<const Spacetime> light;   // what rays follow: flat where light.lensing is off, else the same
    Observer observer;
    std::vector<EffectReason> reasons;  // what the scene calls for
    EffectSet effects;                  // what is compiled and built: those, and light times if they were wished for
    int passed = 0;                     // crossings of the disc's plane that a ray makes before the disc counts
    bool straight() const { return matter != light; }  // light that a metric would bend runs straight
};

// The scene's time, less the camera's r where light takes time: from this the shader takes the delays of places (FrameData::delay). From afar
// floats have no digits left for the difference of the two. r_s/c.
inline double late_time(const FramePlan& plan) {
    return plan.scene.time - (plan.effects.contains(Effect::kDelay) ? plan.scene.camera.r : 0.0);
}

// light_times: how long light takes is known also where nothing is seen late; what is seen does not depend on it. last: its spacetimes are kept where they are the
// same. Errors: unknown metric, no such observer at camera.r, parts of light or objects that the metric does not have.
Result<FramePlan> plan_frame(const Scene& scene, bool light_times = false, const FramePlan* last = nullptr);

}  // namespace nullscope
