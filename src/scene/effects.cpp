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

bool bends_light(const SpacetimeSpec& spec) {
    const auto spacetime = make_spacetime(spec.metric, spec.parameters);
    return spacetime && (*spacetime)->bends_light();
}

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
    if (bends_light(scene.spacetime)) {
        reasons.push_back({Effect::kLensing, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    }
    const Vec3 v = scene.camera.velocity;
    if (v.x != 0.0 || v.y != 0.0 || v.z != 0.0) {
        reasons.push_back({Effect::kAberration, fmt::format("camera.velocity = [{}, {}, {}]", v.x, v.y, v.z)});
    }
    if (scene.disc) {
        reasons.push_back({Effect::kDisc, fmt::format("[disc] from {} to {}", scene.disc->inner, scene.disc->outer)});
        const bool thermal = scene.disc->emission == DiscEmission::kThermal;
        if (!scene.disc->image.empty()) {
            reasons.push_back({Effect::kDiscImage, fmt::format("disc.image = \"{}\"", scene.disc->image.filename().string())});
        } else if (!thermal) {
            reasons.push_back({Effect::kDiscImage, "disc.emission = \"image\", the one that ships"});
        }
        if (scene.disc->opacity < 1.0) {
            reasons.push_back({Effect::kTranslucentDisc, fmt::format("disc.opacity = {}", scene.disc->opacity)});
        } else if (scene.disc->edge > 0.0) {
            reasons.push_back({Effect::kTranslucentDisc, fmt::format("disc.edge = {}", scene.disc->edge)});
        }
        if (thermal) {
            const char* heat = "disc.emission = \"thermal\"";
            reasons.push_back({Effect::kThermalDisc, heat});
            if (scene.light.shift) reasons.push_back({Effect::kShift, heat});
            if (scene.light.beaming) reasons.push_back({Effect::kBeaming, heat});
        }
    }
    if (scene.sky.kind != SkyKind::kBlack) {
        const bool stars = scene.sky.kind == SkyKind::kStars;
        reasons.push_back({Effect::kSky, fmt::format("sky.kind = \"{}\"", stars ? "stars" : "image")});
    }
    return reasons;
}

EffectSet effect_set(const std::vector<EffectReason>& reasons) {
    EffectSet set;
    for (const EffectReason& reason : reasons) set.insert(reason.effect);
    return set;
}

}  // namespace nullscope
