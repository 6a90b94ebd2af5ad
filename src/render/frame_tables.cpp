#include "render/frame_tables.h"

#include <utility>

#include "render/frame_numbers.h"

namespace nullscope {

Status FrameTables::update(const Scene& scene) {
    auto planned = plan_frame(scene, delays_wanted_, path_ != nullptr ? &plan_ : nullptr);
    if (!planned) return planned.error();
    std::optional<BallPath> ball;
    if (planned->effects.contains(Effect::kBallPath)) {
        auto made = nullscope::ball_path(*planned->matter, scene);
        if (!made) return made.error();
        ball = std::move(*made);
    }
    ball_path_ = std::move(ball);
    const FramePlan before = std::exchange(plan_, std::move(*planned));
    if (before.light != plan_.light) {
        path_ = make_light_path(plan_.light);
        ++revision_;
    }
    if (path_->update(plan_)) ++revision_;
    return Done{};
}

const TexelGrid* FrameTables::texels(std::string_view name) const {
    for (const NamedTexels& table : path_->tables())
        if (table.name == name) return table.texels;
    return nullptr;
}

CoreInput FrameTables::core_input() const {
    CoreInput input;
    input.frame = frame_numbers(plan_, *path_, {}, ball_path());
    input.aberration = plan_.effects.contains(Effect::kAberration);
    path_->give(input);
    return input;
}

}  // namespace nullscope
