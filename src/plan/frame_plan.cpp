#include "plan/frame_plan.h"

#include <fmt/format.h>

#include "plan/glow.h"
#include "plan/medium.h"
#include "plan/sides.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

Status check_objects(const FramePlan& plan) {
    if (Status sides = check_sides(*plan.matter, plan.scene); !sides) return sides.error();
    if (Status glow = check_glow(*plan.matter, plan.scene); !glow) return glow.error();
    if (Status medium = check_medium(*plan.matter, plan.scene); !medium) return medium.error();
    if ((plan.effects.contains(Effect::kDisc) && !plan.matter->can_have_disc()) ||
        (has_solids(plan.effects) && !plan.matter->can_have_bodies()))
        return bad_input(fmt::format("metric \"{}\" has neither discs nor bodies", plan.scene.spacetime.metric),
                         "a scene without them");
    return Done{};
}

// Light times where they are wished for, as far as the shader can tell them. Whether things are seen late is the scene's.
void settle_light_times(FramePlan& plan, bool wanted) {
    if (wanted) plan.effects.insert(Effect::kLightTimes);
    if (!plan.light->knows_light_time())
        for (const Effect effect : {Effect::kDelay, Effect::kLightTimes}) plan.effects.erase(effect);
    if (plan.effects.contains(Effect::kLightTimes) && plan.effects.contains(Effect::kLensing) &&
        plan.light->spherical()->has_inner_root())
        plan.effects.insert(Effect::kInnerHorizon);
}

}  // namespace

Result<FramePlan> plan_frame(const Scene& scene, bool light_times, const FramePlan* last) {
    FramePlan plan;
    plan.scene = scene;
    if (last != nullptr && last->scene.spacetime == scene.spacetime) {
        plan.matter = last->matter;
    } else {
        TRY(made, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
        plan.matter = *made;
    }
    if (scene.light.lensing)
        plan.light = plan.matter;
    else
        plan.light = last != nullptr && last->straight() ? last->light : *make_spacetime("minkowski", {});
    TRY(observer, observer_of(*plan.matter, scene.camera));
    plan.observer = *observer;
    if (!scene.light.aberration) plan.observer.turn = Mat3{};  // the view directions of one at rest
    if (Status parts = check_light_parts(*plan.matter, scene); !parts) return parts.error();
    if (scene.camera.zoom) {
        TRY(view, ring_view(*plan.matter, scene.camera, scene.light));
        plan.scene.camera = view->camera;
        plan.ring = *view;
    }
    plan.reasons = required_effects(scene, &*plan.matter, &plan.observer);
    plan.effects = effect_set(plan.reasons);
    if (Status objects = check_objects(plan); !objects) return objects.error();
    settle_light_times(plan, light_times);
    return plan;
}

}  // namespace nullscope
