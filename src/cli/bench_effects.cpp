#include "cli/bench_effects.h"

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/session.h"

namespace nullscope::cli {
namespace {

// One effect more, and the scene without it.
struct Added {
    Effect effect;
    std::function<void(Scene&)> ground;  // what the effect cannot be without
    std::function<void(Scene&)> add;
};

void nothing(Scene&) {}

const std::vector<Added>& additions() {
    const auto sphere = [](Scene& s) { s.sphere.emplace().radius = 4.0; };
    const auto texture = [](TextureKind kind) {
        return [kind](Scene& s) {
            s.sphere->look.texture = kind;
            if (kind == TextureKind::kFormula) s.sphere->look.formula = "0.5 + 0.5 * sin(40 * u) * sin(20 * v)";
            if (kind == TextureKind::kImage)
                s.sphere->look.image = assets_directory() / "images" / "accretion-disc.png";
        };
    };
    const auto dark_wormhole = [](Scene& s) {
        s.spacetime.metric = "ellis";
        s.far_sky.kind = SkyKind::kBlack;
    };
    const auto glowing = [](bool shift, bool beaming) {
        return [=](Scene& s) {
            s.spacetime.metric = "schwarzschild";
            s.disc.emplace().emission = DiscEmission::kThermal;
            s.light = {shift, beaming};
        };
    };
    const auto image_of_ours = [](Scene& s) { s.disc->image = assets_directory() / "images" / "accretion-disc.png"; };
    const auto bare_disc = [](Scene& s) {
        s.spacetime.metric = "schwarzschild";
        s.disc.emplace();
    };
    const auto still_disc = [=](Scene& s) { bare_disc(s), s.light.delay = false; };
    const auto moving_disc = [=](Scene& s) { still_disc(s), s.disc->flow = DiscFlowKind::kKepler; };
    static const std::vector<Added> all = {
        {Effect::kLensing, nothing, [](Scene& s) { s.spacetime.metric = "schwarzschild"; }},
        {Effect::kAberration, nothing,
         [](Scene& s) {
             s.camera.velocity = {0.1, 0.2, 0.3};
         }},
        {Effect::kDisc, nothing, [](Scene& s) { s.disc.emplace(); }},
        {Effect::kTranslucentDisc, [](Scene& s) { s.disc.emplace(); }, [](Scene& s) { s.disc->opacity = 0.5; }},
        {Effect::kDiscImage, glowing(false, false), image_of_ours},
        {Effect::kDiscPattern, glowing(false, false), [](Scene& s) { s.disc->look.texture = TextureKind::kPlain; }},
        {Effect::kThermalDisc, bare_disc, glowing(false, false)},
        {Effect::kShift, glowing(false, false), glowing(true, false)},
        {Effect::kBeaming, glowing(false, false), glowing(false, true)},
        {Effect::kBolometric, glowing(true, true), [](Scene& s) { s.light.bolometric = true; }},
        {Effect::kSphere, nothing, sphere},
        {Effect::kCylinder, nothing, [](Scene& s) { s.cylinder.emplace(); }},
        {Effect::kBall, nothing, [](Scene& s) { s.ball.emplace(); }},
        {Effect::kSurface, nothing, [](Scene& s) { s.surface.emplace(); }},
        {Effect::kPattern, sphere, texture(TextureKind::kChecker)},
        {Effect::kNoise, sphere, texture(TextureKind::kNoise)},
        {Effect::kFormula, sphere, texture(TextureKind::kFormula)},
        {Effect::kBodyImage, sphere, texture(TextureKind::kImage)},
        {Effect::kPointStars, nothing,
         [](Scene& s) {
             s.sky.kind = SkyKind::kPoints;
             s.sky.even_stars = 100000;
             s.sky.faintest = 6.0;
             s.light = {false, false};
         }},
        {Effect::kSky, nothing, [](Scene& s) { s.sky.kind = SkyKind::kStars; }},
        {Effect::kSkyShift,
         [](Scene& s) {
             s.sky.kind = SkyKind::kStars;
             s.camera.velocity = {0.1, 0.2, 0.3};
         },
         [](Scene& s) { s.sky.temperature_K = 6000.0; }},
        {Effect::kSkyPattern, nothing, [](Scene& s) { s.sky.kind = SkyKind::kPlain; }},
        {Effect::kInner, [](Scene& s) { s.spacetime.metric = "schwarzschild"; }, dark_wormhole},
        {Effect::kSpin, nothing, [](Scene& s) { s.spacetime.metric = "kerr"; }},
        {Effect::kSpinFall, [](Scene& s) { s.spacetime.metric = "kerr"; },
         [](Scene& s) {
             s.spacetime.metric = "kerr";
             s.camera.observer = ObserverKind::kRain;
         }},
        {Effect::kBounce, [](Scene& s) { s.spacetime.metric = "schwarzschild"; },
         [](Scene& s) {
             s.spacetime = {"reissner-nordstrom", {{"charge", 1.2}}};
         }},
        {Effect::kFarSky, dark_wormhole, [](Scene& s) { s.far_sky.kind = SkyKind::kStars; }},
        {Effect::kStar, [](Scene& s) { s.spacetime.metric = "schwarzschild"; },
         [](Scene& s) { s.spacetime.metric = "neutron-star"; }},
        {Effect::kBloom, nothing, [](Scene& s) { s.picture.bloom = 0.1; }},
        {Effect::kAutoExposure, nothing, [](Scene& s) { s.picture.auto_exposure = true; }},
        {Effect::kToneFilm, nothing, [](Scene& s) { s.picture.tone = ToneCurve::kFilm; }},
        {Effect::kToneNeutral, nothing, [](Scene& s) { s.picture.tone = ToneCurve::kNeutral; }},
        {Effect::kDither, nothing, [](Scene& s) { s.picture.dither = true; }},
        {Effect::kDelay, moving_disc, [](Scene& s) { s.light.delay = true; }},
        {Effect::kDiscFlow, still_disc, [](Scene& s) { s.disc->flow = DiscFlowKind::kKepler; }},
        {Effect::kSpot, [=](Scene& s) { glowing(true, true)(s), s.light.delay = false; },
         [](Scene& s) { s.spot.emplace(); }},
        {Effect::kBallPath,
         [](Scene& s) {
             s.ball.emplace().position = {-6, 0, 0}, s.spacetime.metric = "schwarzschild", s.light.delay = false;
         },
         [](Scene& s) { s.ball->motion = BallMotion::kOrbit; }},
        {Effect::kPulse, [=](Scene& s) { sphere(s), s.light.delay = false; }, [](Scene& s) { s.sphere->swing = 0.1; }},
        {Effect::kSides, dark_wormhole, [](Scene& s) { s.ball.emplace(); }},
        {Effect::kInnerHorizon, [=](Scene& s) { moving_disc(s), s.light.delay = true; },
         [](Scene& s) {
             s.spacetime = {"reissner-nordstrom", {{"charge", 0.8}}};
         }},
    };
    return all;
}

// Nothing in it: flat, black, a camera at rest.
Scene empty_scene(int width, int height) {
    Scene scene;
    scene.name = "empty";
    scene.spacetime.metric = "minkowski";
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.r = 20.0;
    scene.camera.width = width;
    scene.camera.height = height;
    return scene;
}

// Renderers of the empty scene (the session's), of a scene, and of the scene without an effect, on one context.
struct Bench {
    Session session;
    std::unique_ptr<Renderer> with, without;
    gl::Target target;
};

Result<Bench> open_bench(const std::string& context, int width, int height) {
    auto session = open_session(context);
    if (!session) return session.error();
    if (Status ready = session->renderer->prepare(empty_scene(width, height)); !ready) return ready.error();
    return Bench{std::move(*session), std::make_unique<Renderer>(), std::make_unique<Renderer>(),
                 gl::make_target(width, height, gl::Format::kRgba8)};
}

// Of what is prepared, in turn (A B C A B C ...).
EffectCost cost_of(Bench& bench, Effect effect, int frames, Progress& progress) {
    const auto draw = [&](Renderer& renderer) {
        renderer.draw(bench.target.framebuffer.id(), bench.target.width, bench.target.height, Output::kDisplay);
    };
    Renderer* const renderers[] = {bench.session.renderer.get(), bench.without.get(), bench.with.get()};
    for (Renderer* renderer : renderers) draw(*renderer);  // compiles
    Samples samples[3];
    for (int i = 0; i < frames; ++i, progress.advance())
        for (int k = 0; k < 3; ++k) time_one(samples[k], [&] { draw(*renderers[k]); });
    return {effect, median(samples[2].core_s), median(samples[1].core_s), median(samples[0].core_s)};
}

}  // namespace

Result<std::vector<EffectCost>> effect_costs(const Scene& scene, const std::string& context, int frames) {
    auto bench = open_bench(context, scene.camera.width, scene.camera.height);
    if (!bench) return bench.error();
    if (Status ready = bench->with->prepare(scene); !ready) return ready.error();
    const std::vector<Effect> effects = effect_set(required_effects(scene)).list();
    Progress progress("effects", static_cast<long long>(effects.size()) * frames);
    std::vector<EffectCost> costs;
    for (const Effect effect : effects) {
        const auto without = without_effect(scene, effect);
        if (!without || !bench->without->prepare(*without)) {  // it cannot go alone
            progress.advance(frames);
            continue;
        }
        costs.push_back(cost_of(*bench, effect, frames, progress));
    }
    return costs;
}

Status bench_effects(const std::string& context, int width, int height, int frames, const std::string& json) {
    auto opened = open_bench(context, width, height);
    if (!opened) return opened.error();
    Bench& bench = *opened;
    std::vector<JsonObject> rows;
    Progress progress("effects", static_cast<long long>(additions().size()) * frames);
    for (const Added& added : additions()) {
        Scene without = empty_scene(width, height);
        added.ground(without);
        Scene with = without;
        added.add(with);
        if (Status ready = bench.without->prepare(without); !ready) return ready;
        if (Status ready = bench.with->prepare(with); !ready) return ready;
        const EffectCost cost = cost_of(bench, added.effect, frames, progress);
        const EffectRow& row = effect_row(added.effect);
        fmt::print("{:<18} {:.4f} core-s, without it {:.4f}: {:+.2f} x the empty scene's {:.4f}\n", row.key,
                   cost.with_s, cost.without_s, cost.over_floor(), cost.floor_s);
        rows.push_back(JsonObject()
                           .add("effect", row.key)
                           .add("renderer", bench.session.renderer->info().renderer)
                           .add("width", width)
                           .add("height", height));
        rows.back()
            .add("frames", frames)
            .add("core_seconds", cost.with_s)
            .add("without_core_seconds", cost.without_s)
            .add("empty_core_seconds", cost.floor_s);
        rows.back().add("added_floor_ratio", cost.over_floor());
    }
    if (json.empty()) return Done{};
    return write_text_atomically(json, json_list(rows));
}

}  // namespace nullscope::cli
