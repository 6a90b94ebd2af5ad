#include <fmt/format.h>

#include "base/progress.h"
#include "bench/bench.h"
#include "command/json.h"
#include "plan/feature.h"

namespace nullscope::cli {
namespace {

// Nothing in it: flat, black, a camera at rest.
Scene empty_scene(int width, int height) {
    Scene scene;
    scene.name = "empty";
    scene.spacetime.metric = "minkowski";
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.r = 20.0;
    scene.picture.refine = false;
    scene.camera.width = width;
    scene.camera.height = height;
    return scene;
}

// In turn, of what is prepared: the bench's renderer has the empty scene, its other the scene without the effect.
EffectCost cost_of(const Bench& bench, Renderer& with, Effect effect, int frames, Progress& progress) {
    const auto samples = bench.time_in_turn(frames, {[&] { bench.draw(with); }}, [&] { progress.advance(); });
    return {effect, median(samples[2].core_s), median(samples[1].core_s), median(samples[0].core_s),
            effect == Effect::kRefine ? with.refined_share() : 0.0};
}

}  // namespace

Result<std::vector<EffectCost>> effect_costs(const Scene& scene, const ContextChoice& context, int frames) {
    TRY(bench, open_bench(context, scene.camera.width, scene.camera.height));
    TRY(empty, bench->renderer().prepare(empty_scene(scene.camera.width, scene.camera.height)));
    Renderer with;
    TRY(ready, with.prepare(scene));
    const std::vector<Effect> effects = effect_set(required_effects(scene)).list();
    Progress progress("effects", static_cast<long long>(effects.size()) * frames);
    std::vector<EffectCost> costs;
    for (const Effect effect : effects) {
        const auto without = without_effect(scene, effect);
        if (!without || !bench->other->prepare(*without)) {  // it cannot go alone
            progress.advance(frames);
            continue;
        }
        costs.push_back(cost_of(*bench, with, effect, frames, progress));
    }
    return costs;
}

Status bench_effects(const BenchOptions& options) {
    TRY(bench, open_bench(options));
    const int width = bench->target.width, height = bench->target.height;
    TRY(empty, bench->renderer().prepare(empty_scene(width, height)));
    Renderer renderer_with;
    Json rows = Json::array();
    Progress progress("effects", static_cast<long long>(kEffectCount) * options.frames);
    for (const EffectRow* row : effect_rows()) {
        const Feature& feature = feature_of(row->effect);
        Scene without = empty_scene(width, height);
        feature.before(without);
        Scene with = without;
        feature.with(with);
        TRY(without_ready, bench->other->prepare(without));
        TRY(with_ready, renderer_with.prepare(with));
        const EffectCost cost = cost_of(*bench, renderer_with, feature.effect, options.frames, progress);
        fmt::print("{:<18} {:.4f} core-s, without it {:.4f}: {:+.2f} x the empty scene's {:.4f}\n", feature.key,
                   cost.with_s, cost.without_s, cost.over_floor(), cost.floor_s);
        rows.push_back({{"effect", feature.key},
                        {"renderer", bench->driver()},
                        {"width", width},
                        {"height", height},
                        {"frames", options.frames},
                        {"core_seconds", cost.with_s},
                        {"without_core_seconds", cost.without_s},
                        {"empty_core_seconds", cost.floor_s},
                        {"added_floor_ratio", cost.over_floor()}});
    }
    return write_json(options.json, rows);
}

}  // namespace nullscope::cli
