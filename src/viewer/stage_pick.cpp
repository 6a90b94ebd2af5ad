#include "viewer/stage_pick.h"

#include <fmt/format.h>

#include "gl/abilities.h"

namespace nullscope::viewer {
namespace {

bool leaves_to_times(const Renderer& renderer, StageWish wish) {
    return wish == StageWish::kMeasured || (wish == StageWish::kAuto && !gl::names_software(renderer.info().renderer));
}

}  // namespace

bool StagePick::computes(const Renderer& renderer, StageWish wish) {
    const auto because = [&](bool compute, const std::string& why) {
        words_ = fmt::format("{}: {}", compute ? kComputeStage : kFragmentStage, why);
        return compute;
    };
    if (wish == StageWish::kFragment || wish == StageWish::kCompute)
        return because(wish == StageWish::kCompute, "chosen by hand");
    if (!leaves_to_times(renderer, wish))
        return because(false, "this driver draws on the processor, where compute shaders gain nothing");
    const std::string kind = stage_kind(renderer);
    if (const auto refused = refused_.find(kind); refused != refused_.end()) return because(false, refused->second);
    const auto times = memory_.find(stage_device(renderer), kind);
    return times ? because(times->computes(), times->words()) : because(false, "until both are timed, at rest");
}

bool StagePick::asks(const Renderer& renderer, StageWish wish) const {
    if (!leaves_to_times(renderer, wish)) return false;
    const std::string kind = stage_kind(renderer);
    return !refused_.contains(kind) && !memory_.find(stage_device(renderer), kind);
}

void StagePick::take(const Renderer& renderer, const StageTrial& trial) {
    const std::string kind = stage_kind(renderer);
    if (!trial.refusal.empty())
        refused_[kind] = trial.refusal;
    else  // where it cannot be kept it is measured again in the next session
        static_cast<void>(memory_.keep(stage_device(renderer), kind, trial.times));
}

}  // namespace nullscope::viewer
