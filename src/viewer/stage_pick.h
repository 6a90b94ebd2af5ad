// Which shaders trace the viewer's pictures, fragment or compute, and why.
#pragma once
#include <map>
#include <string>

#include "render/renderer.h"
#include "render/stage_times.h"
#include "render/stage_trial.h"
#include "studio/paint_job.h"

namespace nullscope::viewer {

class StagePick {
public:
    // By compute shaders? Of what the renderer has prepared; words() then say why.
    bool computes(const Renderer& renderer, StageWish wish);
    const std::string& words() const { return words_; }  // a line

    // Shall both be timed for it?
    bool asks(const Renderer& renderer, StageWish wish) const;
    void take(const Renderer& renderer, const StageTrial& trial);

private:
    StageMemory memory_;
    std::map<std::string, std::string> refused_;  // kinds of scenes of which nothing is computed here, and why
    std::string words_;
};

}  // namespace nullscope::viewer
