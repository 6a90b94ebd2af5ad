#include "plan/effects.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <utility>

#include "plan/body_kind.h"
#include "plan/feature.h"
#include "plan/medium_model.h"
#include "scene/projection_table.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

// By the order of the enumerators.
const std::array<const Feature*, kEffectCount>& features() {
    static const auto all = [] {
        std::array<const Feature*, kEffectCount> list{};
        for (const auto group : feature_groups())
            for (const Feature& feature : group) list[static_cast<std::size_t>(feature.effect)] = &feature;
        for (const Feature* feature : list)
            if (feature == nullptr) std::abort();  // an enumerator without a Feature
        return list;
    }();
    return all;
}

// What a pixel and the one beside it see may be far apart: at a cube's and a mesh's edges.
bool has_edges(const EffectSet& effects) {
    const auto has_faces = [](Projection projection) { return projection_row(projection).faces; };
    return effects.contains(Effect::kWarp) || std::ranges::any_of(projections_of(effects), has_faces);
}

// Rays outside of the horizon, to one sky, that turn smoothly with the pixel.
bool ends_are_plain(const EffectSet& effects) {
    if (has_medium(effects) || has_edges(effects)) return false;
    for (const Effect effect :
         {Effect::kSpinFall, Effect::kSides, Effect::kInner, Effect::kBounce, Effect::kFarSky, Effect::kStar})
        if (effects.contains(effect)) return false;
    return effects.contains(Effect::kLensing) || effects.contains(Effect::kSpin);
}

}  // namespace

std::vector<std::span<const Feature>> feature_groups() {
    return {light_features(),  disc_features(),    polarisation_features(), bodies_features(),
            medium_features(), picture_features(), projection_features()};
}
const Feature& feature_of(Effect effect) { return *features()[static_cast<std::size_t>(effect)]; }
const EffectRow& effect_row(Effect effect) { return feature_of(effect); }
std::vector<const EffectRow*> effect_rows() { return {features().begin(), features().end()}; }

std::string_view kept(std::string text) {
    static std::deque<std::string> texts;
    return texts.emplace_back(std::move(text));
}

std::vector<Effect> EffectSet::list() const {
    std::vector<Effect> effects;
    for (std::size_t i = 0; i < kEffectCount; ++i)
        if (bits_.test(i)) effects.push_back(static_cast<Effect>(i));
    return effects;
}

std::vector<std::string_view> EffectSet::keys() const {
    std::vector<std::string_view> keys;
    for (const Effect effect : list()) keys.push_back(effect_row(effect).key);
    return keys;
}

LightPathKind light_path_kind(const EffectSet& effects) {
    return effects.contains(Effect::kSpin) ? LightPathKind::kMino : LightPathKind::kPlanar;
}

bool has_marched(const EffectSet& effects) {
    if (effects.contains(Effect::kPulse)) return true;
    for (const BodyKind* kind : body_kinds())
        if (effects.contains(kind->effect.effect) &&
            (kind != &kSphereKind || light_path_kind(effects) == LightPathKind::kMino))
            return true;
    return false;
}
const MediumModel* model_of(const EffectSet& effects) {
    for (const MediumModel* model : medium_models())
        if (effects.contains(model->effect.effect)) return model;
    return nullptr;
}
bool polarises(const EffectSet& effects) {
    return effects.contains(Effect::kPolarisation) || effects.contains(Effect::kMediumPolarisation);
}

bool has_medium(const EffectSet& effects) { return model_of(effects) != nullptr; }
bool has_tiles(const EffectSet& effects) {
    if (has_medium(effects)) return false;  // nor do they of matter
    // Rays of tiles know nothing of the swings that a zoom leaves out.
    if (effects.contains(Effect::kSpinRing) && effects.contains(Effect::kZoom)) return false;
    if (has_edges(effects)) return false;
    return has_marched(effects) && !effects.contains(Effect::kSides) && !effects.contains(Effect::kSpinFall);
}
bool tiles_classify_disc(const EffectSet& effects) {
    return effects.contains(Effect::kDisc) && !effects.contains(Effect::kDiscWarp) && ends_are_plain(effects);
}
bool tiles_classify_full_disc(const EffectSet& effects) {
    return tiles_classify_disc(effects) && light_path_kind(effects) == LightPathKind::kPlanar;
}
bool interpolates(const EffectSet& effects) {
    return light_path_kind(effects) == LightPathKind::kMino && ends_are_plain(effects);
}
bool interpolates_disc(const EffectSet& effects) {
    if (!interpolates(effects) || !tiles_classify_disc(effects)) return false;
    constexpr Effect kOthers[] = {Effect::kDiscLean, Effect::kPolarisation, Effect::kZoom};
    return std::ranges::none_of(kOthers, [&](Effect effect) { return effects.contains(effect); });
}
bool interpolates_matter(const EffectSet& effects) {
    constexpr Effect kOthers[] = {Effect::kDisc, Effect::kStar, Effect::kFarSky, Effect::kZoom, Effect::kWarp};
    return has_medium(effects) && !has_solids(effects) && projections_of(effects).empty() &&
           std::ranges::none_of(kOthers, [&](Effect effect) { return effects.contains(effect); });
}
std::vector<Projection> projections_of(const EffectSet& effects) {
    std::vector<Projection> found;
    for (int i = 1; i < kProjections; ++i)
        if (const auto one = static_cast<Projection>(i); effects.contains(projection_effect(one))) found.push_back(one);
    return found;
}
bool has_solids(const EffectSet& effects) { return effects.contains(Effect::kSphere) || has_marched(effects); }
bool uses_black_body(const EffectSet& effects) {
    return effects.contains(Effect::kThermalDisc) || effects.contains(Effect::kSpot) ||
           effects.contains(Effect::kGlow) || effects.contains(medium_effect(MediumKind::kGas)) ||
           effects.contains(Effect::kMediumBlackBody) ||
           (effects.contains(Effect::kSkyShift) && effects.contains(Effect::kAberration));
}
bool takes_samples(const EffectSet& effects) {
    return effects.contains(Effect::kSamples) || effects.contains(Effect::kRefine);
}
EffectSet with_one_ray(EffectSet effects) {
    for (const Effect effect : {Effect::kSamples, Effect::kRefine, Effect::kNarrowDisc}) effects.erase(effect);
    return effects;
}
bool meets_objects(const EffectSet& effects) {
    return effects.contains(Effect::kDisc) || has_solids(effects) || has_medium(effects);
}

bool moves(const EffectSet& effects) {
    return effects.contains(Effect::kBallPath) || effects.contains(Effect::kPulse) ||
           effects.contains(Effect::kSphereTurn);
}

bool motion_is_seen(const Spacetime& spacetime, const Observer& observer, const Scene& scene) {
    if (!scene.light.aberration && !scene.light.doppler) return false;
    // What falls, or is about a rotating hole, sees the sky's light shifted differently all over the sky, as what is boosted does.
    const bool shifted = (falls(scene.camera) || !spacetime.planar_rays()) && scene.sky.temperature_K &&
                         (scene.light.shift || scene.light.beaming);
    return !(observer.velocity == Vec3{}) || shifted;
}

std::vector<EffectReason> required_effects(const Scene& scene) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (!spacetime) return required_effects(scene, nullptr, nullptr);
    const auto observer = observer_of(**spacetime, scene.camera);
    return required_effects(scene, &**spacetime, observer ? &*observer : nullptr);
}

namespace {

bool body_glows(const Scene& scene) {
    return std::ranges::any_of(scene.bodies, [](const Body& body) { return body.material.temperature_K.has_value(); });
}

FrameFacts facts_of(const Scene& scene, const Spacetime* spacetime, const Observer* observer) {
    const LightSpec& light = scene.light;
    FrameFacts f{scene, spacetime, observer, spacetime != nullptr && spacetime->planar_rays(), false, false,
                 false, nullptr,   {}};
    f.moves = observer != nullptr && motion_is_seen(*spacetime, *observer, scene);
    f.sky_light = !is_procedural(scene.sky.kind) && scene.sky.kind != SkyKind::kBlack && scene.sky.uniform_stars == 0;
    const bool other_g = (f.moves && light.doppler) ||
                         (light.gravity && spacetime != nullptr && spacetime->lapse_squared(scene.camera.r) != 1.0);
    f.sky_shift = f.sky_light && scene.sky.temperature_K && other_g && (light.shift || light.beaming);
    f.heat = f.spot()                                     ? "[spot]"
             : f.points()                                 ? "sky.kind = \"points\""
             : f.thermal()                                ? "disc.emission = \"thermal\""
             : f.gas()                                    ? "medium.kind = \"gas\""
             : f.has_emission(MediumEmission::kBlackBody) ? "medium.emission = \"black-body\""
             : body_glows(scene)                          ? "a body's temperature"
             : f.sky_shift                                ? "sky.temperature"
                                                          : nullptr;
    return f;
}

}  // namespace

std::vector<EffectReason> required_effects(const Scene& scene, const Spacetime* spacetime, const Observer* observer) {
    FrameFacts facts = facts_of(scene, spacetime, observer);
    std::vector<EffectReason> reasons;
    for (const Feature* feature : features())
        if (auto reason = feature->calls(facts)) {
            reasons.push_back({feature->effect, std::move(*reason)});
            facts.so_far.insert(feature->effect);
        }
    return reasons;
}

std::optional<Scene> without_effect(const Scene& scene, Effect effect) {
    const Feature& feature = feature_of(effect);
    Scene less = scene;
    if (feature.without == nullptr || (feature.alone != nullptr && !feature.alone(scene))) return std::nullopt;
    feature.without(less);
    return less;
}

EffectSet effect_set(const std::vector<EffectReason>& reasons) {
    EffectSet set;
    for (const EffectReason& reason : reasons) set.insert(reason.effect);
    return set;
}

}  // namespace nullscope
