#include "render/stage_trial.h"

#include <algorithm>

namespace nullscope {
namespace {

constexpr int kTimed = 3;

}  // namespace

std::optional<StageTrial> try_stages(Renderer& renderer, const std::function<std::optional<double>()>& draw) {
    const auto by = [&](bool compute) {
        renderer.compute(compute);
        const auto ms = draw();
        renderer.compute(false);
        return ms;
    };
    const int drawn = renderer.computed().drawn();
    renderer.compute(true);
    const bool went = draw().has_value();  // compiles
    StageTrial trial{.refusal = renderer.computed().refusal(), .times = {}};
    renderer.compute(false);
    if (!went) return std::nullopt;
    if (trial.refusal.empty() && renderer.computed().drawn() == drawn)
        trial.refusal = "no pass of this scene can be computed";
    if (!trial.refusal.empty()) return trial;
    if (!by(false)) return std::nullopt;
    trial.times = {1e30, 1e30};
    for (int i = 0; i < kTimed; ++i)
        for (const bool compute : {false, true}) {
            const auto ms = by(compute);
            if (!ms) return std::nullopt;
            double& least = compute ? trial.times.compute_ms : trial.times.fragment_ms;
            least = std::min(least, *ms);
        }
    renderer.compute(trial.times.computes());
    return trial;
}

std::string stage_device(const Renderer& renderer) { return renderer.info().renderer + ", " + renderer.info().version; }

std::string stage_kind(const Renderer& renderer) {
    const FrameTables& tables = renderer.tables();
    return scene_kind(tables.plan().scene.spacetime.metric, tables.effects(), renderer.method(), renderer.most_tiles());
}

}  // namespace nullscope
