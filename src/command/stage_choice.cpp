#include "command/stage_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/stopwatch.h"
#include "gl/abilities.h"
#include "gl/gl.h"
#include "platform/usage.h"

namespace nullscope::cli {
namespace {

constexpr int kFrames = 3;

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
    const bool software = gl::names_llvmpipe(renderer.info().renderer);
    const int drawn = renderer.computed().drawn();
    StageChoice choice;
    renderer.compute(true);
    frame_ms(renderer, target, software);  // compiles
    if (!renderer.computed().draws())
        choice.reason = renderer.computed().refusal();
    else if (renderer.computed().drawn() == drawn)
        choice.reason = "no pass of this scene can be computed";
    renderer.compute(false);
    if (!choice.reason.empty()) return choice;
    frame_ms(renderer, target, software);
    choice.fragment_ms = choice.compute_ms = 1e30;
    for (int i = 0; i < kFrames; ++i)
        for (const bool compute : {false, true}) {
            renderer.compute(compute);
            double& least = compute ? choice.compute_ms : choice.fragment_ms;
            least = std::min(least, frame_ms(renderer, target, software));
        }
    const bool sooner = choice.compute_ms < choice.fragment_ms;
    renderer.compute(sooner);
    if (sooner) choice.stage = kComputeStage;
    choice.reason = fmt::format("{:.2f} ms a frame by fragments, {:.2f} by compute ({}{})", choice.fragment_ms,
                                choice.compute_ms, renderer.info().renderer, software ? ", processor time" : "");
    return choice;
}

}  // namespace nullscope::cli
