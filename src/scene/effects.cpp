#include "scene/effects.h"

#include <fmt/format.h>

#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr bool table_is_in_order() {
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        if (static_cast<std::size_t>(kEffectTable[i].effect) != i) return false;
    }
    return true;
}
static_assert(table_is_in_order(), "row i of kEffectTable describes enumerator i");

const char* name_of(SkyKind kind) { return kind == SkyKind::kStars ? "stars" : "image"; }

}  // namespace

std::vector<Effect> EffectSet::list() const {
    std::vector<Effect> effects;
    for (const EffectRow& row : kEffectTable) {
        if (contains(row.effect)) effects.push_back(row.effect);
    }
    return effects;
}

std::vector<std::string_view> EffectSet::keys() const {
    std::vector<std::string_view> keys;
    for (const Effect effect : list()) keys.push_back(effect_row(effect).key);
    return keys;
}

std::vector<EffectReason> required_effects(const Scene& scene) {
    std::vector<EffectReason> reasons;
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (spacetime && (*spacetime)->bends_light()) {
        reasons.push_back({Effect::kLensing, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    }
    const Vec3 v = scene.camera.velocity;
    if (v.x != 0.0 || v.y != 0.0 || v.z != 0.0) {
        reasons.push_back({Effect::kAberration, fmt::format("camera.velocity = [{}, {}, {}]", v.x, v.y, v.z)});
    }
    if (scene.disc) {
        reasons.push_back({Effect::kDisc, fmt::format("[disc] from {} to {}", scene.disc->inner, scene.disc->outer)});
        if (scene.disc->opacity < 1.0) {
            reasons.push_back({Effect::kTranslucentDisc, fmt::format("disc.opacity = {}", scene.disc->opacity)});
        } else if (scene.disc->edge > 0.0) {
            reasons.push_back({Effect::kTranslucentDisc, fmt::format("disc.edge = {}", scene.disc->edge)});
        }
    }
    if (scene.sky.kind != SkyKind::kBlack) {
        reasons.push_back({Effect::kSky, fmt::format("sky.kind = \"{}\"", name_of(scene.sky.kind))});
    }
    if (spacetime && (*spacetime)->bends_light() && (*spacetime)->inner_end() != InnerEnd::kHorizon)
        reasons.push_back({Effect::kInner, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    if (spacetime && (*spacetime)->inner_end() == InnerEnd::kOtherSky && scene.far_sky.kind != SkyKind::kBlack) {
        reasons.push_back({Effect::kFarSky, fmt::format("spacetime.metric = \"{}\", far_sky.kind = \"{}\"",
                                                        scene.spacetime.metric, name_of(scene.far_sky.kind))});
    }
    if (spacetime && (*spacetime)->inner_end() == InnerEnd::kSurface)
        reasons.push_back({Effect::kStar, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    return reasons;
}

EffectSet effect_set(const std::vector<EffectReason>& reasons) {
    EffectSet set;
    for (const EffectReason& reason : reasons) set.insert(reason.effect);
    return set;
}

}  // namespace nullscope
