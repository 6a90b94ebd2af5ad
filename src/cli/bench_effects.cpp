#include "cli/bench_effects.h"

#include <fmt/format.h>

#include <memory>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/session.h"
#include "scene/feature.h"

namespace nullscope::cli {
namespace {

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
    Progress progress("effects", static_cast<long long>(kEffectCount) * frames);
    for (const EffectRow* row : effect_rows()) {
        const Feature& feature = feature_of(row->effect);
        Scene without = empty_scene(width, height);
        feature.before(without);
        Scene with = without;
        feature.with(with);
        if (Status ready = bench.without->prepare(without); !ready) return ready;
        if (Status ready = bench.with->prepare(with); !ready) return ready;
        const EffectCost cost = cost_of(bench, feature.effect, frames, progress);
        fmt::print("{:<18} {:.4f} core-s, without it {:.4f}: {:+.2f} x the empty scene's {:.4f}\n", feature.key,
                   cost.with_s, cost.without_s, cost.over_floor(), cost.floor_s);
        rows.push_back(JsonObject()
                           .add("effect", feature.key)
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
