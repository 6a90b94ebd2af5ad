#include "scene/effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "scene/moving.h"
#include "scene/named_surface.h"
#include "scene/observer.h"
#include "spacetime/axial_metric.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr bool table_is_in_order() {
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        if (static_cast<std::size_t>(kEffectTable[i].effect) != i) return false;
    }
    return true;
}
static_assert(table_is_in_order(), "row i of kEffectTable describes enumerator i");

const char* name_of(SkyKind kind) { return kSkyKindNames[static_cast<int>(kind)]; }

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

LightPathKind light_path_kind(const EffectSet& effects) {
    return effects.contains(Effect::kSpin) ? LightPathKind::kMino : LightPathKind::kPlanar;
}

bool has_marched(const EffectSet& effects) {
    return effects.contains(Effect::kCylinder) || effects.contains(Effect::kBall) ||
           effects.contains(Effect::kSurface) || effects.contains(Effect::kPulse) ||
           (effects.contains(Effect::kSphere) && light_path_kind(effects) == LightPathKind::kMino);
}
bool has_solids(const EffectSet& effects) { return effects.contains(Effect::kSphere) || has_marched(effects); }
bool shades_heat(const EffectSet& effects) {
    return effects.contains(Effect::kThermalDisc) || effects.contains(Effect::kSpot) ||
           (effects.contains(Effect::kSkyShift) && effects.contains(Effect::kAberration));
}
bool meets_objects(const EffectSet& effects) { return effects.contains(Effect::kDisc) || has_solids(effects); }

bool moves(const EffectSet& effects) { return effects.contains(Effect::kBallPath) || effects.contains(Effect::kPulse); }

namespace {

void add_bodies(const Scene& scene, std::vector<EffectReason>& reasons) {
    if (scene.sphere) reasons.push_back({Effect::kSphere, fmt::format("[sphere] of radius {}", scene.sphere->radius)});
    if (const auto& c = scene.cylinder)
        reasons.push_back(
            {Effect::kCylinder, fmt::format("[cylinder] from {} to {}, |z| up to {}", c->inner, c->outer, c->height)});
    if (const auto& b = scene.ball)
        reasons.push_back({Effect::kBall, fmt::format("[ball] of radius {} at [{}, {}, {}]", b->radius, b->position.x,
                                                      b->position.y, b->position.z)});
    if (const auto& f = scene.surface)
        reasons.push_back(
            {Effect::kSurface, fmt::format("[surface] {} within {}",
                                           f->kind == SurfaceKind::kFormula
                                               ? f->shape
                                               : std::string(kNamedSurfaces[static_cast<std::size_t>(f->kind)].key),
                                           f->bound)});
    std::vector<std::pair<const char*, const BodyLook*>> looks;
    const BodyLook disc = scene.disc ? scene.disc->look : BodyLook{}, sky = sky_look(scene.sky);
    if (scene.disc && disc.texture != TextureKind::kImage) looks.emplace_back("disc.texture", &disc);
    if (scene.sphere) looks.emplace_back("sphere.texture", &scene.sphere->look);
    if (scene.cylinder) looks.emplace_back("cylinder.texture", &scene.cylinder->look);
    if (scene.ball) looks.emplace_back("ball.texture", &scene.ball->look);
    if (scene.surface) looks.emplace_back("surface.texture", &scene.surface->look);
    if (has_look(scene.sky.kind)) looks.emplace_back("sky.kind", &sky);
    const auto add = [&](Effect effect, std::initializer_list<std::pair<TextureKind, const char*>> kinds) {
        for (const auto& [key, look] : looks)
            for (const auto& [kind, word] : kinds)
                if (look->texture == kind) {
                    reasons.push_back({effect, fmt::format("{} = \"{}\"", key, word)});
                    return;
                }
    };
    add(Effect::kPattern,
        {{TextureKind::kChecker, "checker"}, {TextureKind::kGrid, "grid"}, {TextureKind::kStripes, "stripes"}});
    add(Effect::kNoise, {{TextureKind::kNoise, "noise"}});
    add(Effect::kFormula, {{TextureKind::kFormula, "formula"}});
    add(Effect::kBodyImage, {{TextureKind::kImage, "image"}});
}

}  // namespace

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

std::vector<EffectReason> required_effects(const Scene& scene, const Spacetime* spacetime, const Observer* observer) {
    std::vector<EffectReason> reasons;
    const bool spins = spacetime != nullptr && !spacetime->planar_rays(),
               lensing = spacetime != nullptr && !spins && spacetime->bends_light() && scene.light.lensing;
    if (spins) {
        reasons.push_back({Effect::kSpin, fmt::format("spacetime.spin = {}", 2.0 * spacetime->axial()->a())});
        if (falls(scene.camera))
            reasons.push_back(
                {Effect::kSpinFall, fmt::format("camera.observer = \"{}\"", observer_name(scene.camera.observer))});
    } else if (lensing) {
        reasons.push_back({Effect::kLensing, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    }
    const LightSpec& light = scene.light;
    const bool moves = observer != nullptr && motion_is_seen(*spacetime, *observer, scene);
    if (moves) {
        const Vec3 v = scene.camera.velocity;
        const char* part = !light.aberration ? ", light.aberration = \"off\": frequencies alone"
                           : !light.doppler  ? ", light.doppler = \"off\": directions alone"
                                             : "";
        const std::string what = scene.camera.observer != ObserverKind::kStatic && v == Vec3{}
                                     ? fmt::format("camera.observer = \"{}\"", observer_name(scene.camera.observer))
                                     : fmt::format("camera.velocity = [{}, {}, {}]", v.x, v.y, v.z);
        reasons.push_back({Effect::kAberration, what + part});
    }
    const bool thermal = scene.disc && scene.disc->emission == DiscEmission::kThermal;
    if (scene.disc) {
        reasons.push_back({Effect::kDisc, fmt::format("[disc] from {} to {}", scene.disc->inner, scene.disc->outer)});
        if (scene.disc->look.texture != TextureKind::kImage) {
            const int pattern =
                static_cast<int>(SkyKind::kPlain) + static_cast<int>(scene.disc->look.texture);  // named as the sky's
            reasons.push_back({Effect::kDiscPattern, fmt::format("disc.texture = \"{}\"", kSkyKindNames[pattern])});
        } else if (!scene.disc->image.empty()) {
            reasons.push_back(
                {Effect::kDiscImage, fmt::format("disc.image = \"{}\"", scene.disc->image.filename().string())});
        } else if (!thermal) {
            reasons.push_back({Effect::kDiscImage, "disc.emission = \"image\", the one that ships"});
        }
        if (scene.disc->opacity < 1.0) {
            reasons.push_back({Effect::kTranslucentDisc, fmt::format("disc.opacity = {}", scene.disc->opacity)});
        } else if (scene.disc->edge > 0.0) {
            reasons.push_back({Effect::kTranslucentDisc, fmt::format("disc.edge = {}", scene.disc->edge)});
        }
        if (thermal) reasons.push_back({Effect::kThermalDisc, "disc.emission = \"thermal\""});
    }
    const bool points = scene.sky.kind == SkyKind::kPoints, spot = scene.disc && scene.spot;
    const bool sky_light = !has_look(scene.sky.kind) && scene.sky.kind != SkyKind::kBlack && scene.sky.even_stars == 0;
    const bool other_g = (moves && light.doppler) ||
                         (light.gravity && spacetime != nullptr && spacetime->lapse_squared(scene.camera.r) != 1.0);
    const bool sky_shift = sky_light && scene.sky.temperature_K && other_g && (light.shift || light.beaming);
    if (points || thermal || spot || sky_shift) {
        const char* heat = spot      ? "[spot]"
                           : points  ? "sky.kind = \"points\""
                           : thermal ? "disc.emission = \"thermal\""
                                     : "sky.temperature";
        const bool g = light.doppler || light.gravity;
        if (g && light.shift) reasons.push_back({Effect::kShift, heat});
        if (g && light.beaming) reasons.push_back({Effect::kBeaming, heat});
        if (light.bolometric) reasons.push_back({Effect::kBolometric, "light.band = \"bolometric\""});
    }
    add_bodies(scene, reasons);
    if (points) reasons.push_back({Effect::kPointStars, "sky.kind = \"points\""});
    if (has_look(scene.sky.kind)) {
        reasons.push_back({Effect::kSkyPattern, fmt::format("sky.kind = \"{}\"", name_of(scene.sky.kind))});
    } else if (sky_light) {
        reasons.push_back({Effect::kSky, fmt::format("sky.kind = \"{}\"", name_of(scene.sky.kind))});
        if (sky_shift)
            reasons.push_back({Effect::kSkyShift,
                               fmt::format("sky.temperature = {}, {}", *scene.sky.temperature_K,
                                           moves && light.doppler ? "camera.velocity"
                                                                  : fmt::format("camera.r = {}", scene.camera.r))});
    }
    if (lensing && spacetime->inner_end() != InnerEnd::kHorizon)
        reasons.push_back({Effect::kInner, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    if (lensing && spacetime->inner_end() == InnerEnd::kSameSky)
        reasons.push_back(
            {Effect::kBounce, fmt::format("spacetime.metric = \"{}\" without horizon", scene.spacetime.metric)});
    if (lensing && spacetime->inner_end() == InnerEnd::kOtherSky && scene.far_sky.kind != SkyKind::kBlack) {
        reasons.push_back({Effect::kFarSky, fmt::format("spacetime.metric = \"{}\", far_sky.kind = \"{}\"",
                                                        scene.spacetime.metric, name_of(scene.far_sky.kind))});
    }
    if (lensing && spacetime->inner_end() == InnerEnd::kSurface)
        reasons.push_back({Effect::kStar, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    const PictureSpec& picture = scene.picture;
    if (picture.bloom > 0.0) reasons.push_back({Effect::kBloom, fmt::format("picture.bloom = {}", picture.bloom)});
    if (picture.auto_exposure) reasons.push_back({Effect::kAutoExposure, "picture.auto_exposure = \"on\""});
    if (picture.tone == ToneCurve::kFilm) reasons.push_back({Effect::kToneFilm, "picture.tone = \"film\""});
    if (picture.tone == ToneCurve::kNeutral) reasons.push_back({Effect::kToneNeutral, "picture.tone = \"neutral\""});
    if (picture.dither) reasons.push_back({Effect::kDither, "picture.dither = \"on\""});
    if (lensing && spacetime->by_proper_length() && has_marched(effect_set(reasons)))
        reasons.push_back({Effect::kSides, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    if (const auto moving = moving_parts(scene); !moving.empty() && light.delay)
        reasons.push_back({Effect::kDelay, fmt::format("{}", fmt::join(moving, ", "))});
    if (scene.disc && scene.disc->flow == DiscFlowKind::kKepler)
        reasons.push_back({Effect::kDiscFlow, "disc.flow = \"kepler\""});
    if (spot) reasons.push_back({Effect::kSpot, fmt::format("[spot] at {}", scene.spot->r)});
    if (scene.ball && scene.ball->motion != BallMotion::kStill) reasons.push_back({Effect::kBallPath, "ball.motion"});
    if (scene.sphere && scene.sphere->swing > 0.0)
        reasons.push_back({Effect::kPulse, fmt::format("sphere.swing = {}", scene.sphere->swing)});
    if (lensing && effect_set(reasons).contains(Effect::kDelay) && spacetime->spherical()->has_inner_horizon())
        reasons.push_back({Effect::kInnerHorizon, fmt::format("spacetime.metric = \"{}\"", scene.spacetime.metric)});
    return reasons;
}

namespace {

using Kinds = std::initializer_list<TextureKind>;

void make_plain(BodyLook& look, Kinds kinds) {
    if (std::find(kinds.begin(), kinds.end(), look.texture) != kinds.end()) look.texture = TextureKind::kPlain;
}

void make_bodies_plain(Scene& scene, Kinds kinds) {
    if (scene.sphere) make_plain(scene.sphere->look, kinds);
    if (scene.cylinder) make_plain(scene.cylinder->look, kinds);
    if (scene.ball) make_plain(scene.ball->look, kinds);
    if (scene.surface) make_plain(scene.surface->look, kinds);
}

void make_all_plain(Scene& scene, Kinds kinds) {
    make_bodies_plain(scene, kinds);
    if (scene.disc) make_plain(scene.disc->look, kinds);
    if (BodyLook sky = sky_look(scene.sky); has_look(scene.sky.kind)) {
        make_plain(sky, kinds);
        if (sky.texture == TextureKind::kPlain) scene.sky.kind = SkyKind::kPlain;
    }
}

}  // namespace

std::optional<Scene> without_effect(const Scene& scene, Effect effect) {
    Scene less = scene;
    switch (effect) {
        case Effect::kLensing:
            less.light.lensing = falls(
                scene.camera);  // straight light is that of an observer at rest: what falls is put into flat space
            if (less.light.lensing) less.spacetime = {"minkowski", {}};
            if (effect_set(required_effects(scene)).contains(Effect::kSides))
                less.cylinder.reset(), less.ball.reset(), less.surface.reset();  // straight light knows one side
            return less;
        case Effect::kAberration:
            less.camera.velocity = {0, 0, 0};
            if (less.camera.observer == ObserverKind::kOrbit || less.camera.observer == ObserverKind::kCounterOrbit ||
                less.spacetime.metric == "minkowski")
                less.camera.observer = ObserverKind::kStatic;
            return less;
        case Effect::kSpin: less.spacetime.parameters["spin"] = 0.0; return less;
        case Effect::kDisc: less.disc.reset(); return less;
        case Effect::kTranslucentDisc:
            if (less.disc) less.disc->opacity = 1.0, less.disc->edge = 0.0;
            return less;
        case Effect::kDiscImage:
            if (!less.disc || less.disc->emission != DiscEmission::kThermal) break;  // there is no other light
            less.disc->image.clear();
            return less;
        case Effect::kDiscPattern:
            if (!less.disc || less.disc->emission != DiscEmission::kThermal) break;  // the same
            less.disc->look.texture = TextureKind::kImage;
            less.disc->image.clear();
            return less;
        case Effect::kThermalDisc:
            if (!less.disc || (less.disc->image.empty() && less.disc->look.texture == TextureKind::kImage))
                break;  // the same
            less.disc->emission = DiscEmission::kImage;
            return less;
        case Effect::kShift: less.light.shift = false; return less;
        case Effect::kBeaming: less.light.beaming = false; return less;
        case Effect::kBolometric: less.light.bolometric = false; return less;
        case Effect::kPointStars:
            less.sky.kind = scene.sky.even_stars == 0 ? SkyKind::kStars : SkyKind::kBlack;
            return less;
        case Effect::kSphere: less.sphere.reset(); return less;
        case Effect::kCylinder: less.cylinder.reset(); return less;
        case Effect::kBall: less.ball.reset(); return less;
        case Effect::kSurface: less.surface.reset(); return less;
        case Effect::kPattern:
            make_all_plain(less, {TextureKind::kChecker, TextureKind::kGrid, TextureKind::kStripes});
            return less;
        case Effect::kNoise: make_all_plain(less, {TextureKind::kNoise}); return less;
        case Effect::kFormula: make_all_plain(less, {TextureKind::kFormula}); return less;
        case Effect::kBodyImage: make_bodies_plain(less, {TextureKind::kImage}); return less;
        case Effect::kSkyShift: less.sky.temperature_K.reset(); return less;
        case Effect::kSky:
        case Effect::kSkyPattern: less.sky.kind = SkyKind::kBlack; return less;
        case Effect::kFarSky: less.far_sky.kind = SkyKind::kBlack; return less;
        case Effect::kBloom: less.picture.bloom = 0.0; return less;
        case Effect::kAutoExposure: less.picture.auto_exposure = false; return less;
        case Effect::kToneFilm:
        case Effect::kToneNeutral: less.picture.tone = ToneCurve::kShoulder; return less;
        case Effect::kDither: less.picture.dither = false; return less;
        case Effect::kSides: less.cylinder.reset(), less.ball.reset(), less.surface.reset(); return less;
        case Effect::kDelay: less.light.delay = false; return less;
        case Effect::kDiscFlow:
            if (less.disc) less.disc->flow = DiscFlowKind::kStill;
            return less;
        case Effect::kSpot: less.spot.reset(); return less;
        case Effect::kBallPath:
            if (less.ball) less.ball->motion = BallMotion::kStill;
            return less;
        case Effect::kPulse:
            if (less.sphere) less.sphere->swing = 0.0;
            return less;
        case Effect::kSpinFall:
        case Effect::kInner:
        case Effect::kBounce:
        case Effect::kStar:
        case Effect::kInnerHorizon: break;
    }
    return std::nullopt;
}

EffectSet effect_set(const std::vector<EffectReason>& reasons) {
    EffectSet set;
    for (const EffectReason& reason : reasons) set.insert(reason.effect);
    return set;
}

}  // namespace nullscope
