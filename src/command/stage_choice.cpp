#include "command/stage_choice.h"

#include <fmt/format.h>

#include "base/stopwatch.h"
#include "gl/abilities.h"
#include "gl/gl.h"
#include "platform/usage.h"
#include "render/stage_trial.h"

namespace nullscope::cli {
namespace {

double frame_ms(Renderer& renderer, const gl::Target& target, bool by_processor) {
    gl::finish();
    const double core = platform::process_cpu_seconds();
    const Stopwatch watch;
    renderer.draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay);
    gl::finish();
    return by_processor ? 1e3 * (platform::process_cpu_seconds() - core) : watch.ms();
}

}  // namespace

StageChoice choose_stage(Renderer& renderer, int width, int height) {
    const gl::Target target = gl::make_target(width, height, gl::Format::kRgba8);
    const bool software = gl::names_software(renderer.info().renderer);
    const auto trial = try_stages(renderer, [&] { return std::optional(frame_ms(renderer, target, software)); });
    StageChoice choice{.reason = trial->refusal, .times = trial->times};
    if (!choice.reason.empty()) return choice;
    choice.stage = choice.times.stage();
    choice.reason =
        fmt::format("{} ({}{})", choice.times.words(), renderer.info().renderer, software ? ", processor time" : "");
    // Where it cannot be kept it is measured again.
    static_cast<void>(StageMemory().keep(stage_device(renderer), stage_kind(renderer), choice.times));
    return choice;
}

std::vector<std::string> remembered_stages(const Scene& scene, const EffectSet& effects) {
    const StageMemory memory;
    std::vector<std::string> lines;
    for (const Tiles tiles : {Tiles::kBodies, Tiles::kInterpolated})
        for (const StageMemory::Row& row : memory.of_kind(scene_kind(scene.spacetime.metric, effects, Method{}, tiles)))
            lines.push_back(fmt::format("{}: {}{} ({})", row.times.stage(), row.times.words(),
                                        tiles == Tiles::kInterpolated ? " in the viewer" : "", row.device));
    return lines;
}

}  // namespace nullscope::cli
