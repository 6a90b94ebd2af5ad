#include "scene/moving.h"

#include "expr/formula.h"

namespace nullscope {

bool surface_moves(const SurfaceSpec& surface) {
    if (surface.kind != SurfaceKind::kFormula) return false;
    constexpr std::size_t kTime = 3;
    const auto formula = expr::Formula::parse(surface.shape, {"x", "y", "z", "t"});
    return formula && formula->uses(kTime);
}

std::vector<std::string> moving_parts(const Scene& scene) {
    std::vector<std::string> parts;
    if (scene.disc && scene.disc->flow != DiscFlowKind::kStill) parts.emplace_back("disc.flow");
    if (scene.disc && scene.spot) parts.emplace_back("spot.r");
    if (scene.sphere && scene.sphere->swing > 0.0) parts.emplace_back("sphere.swing");
    if (scene.ball && scene.ball->motion != BallMotion::kStill) parts.emplace_back("ball.motion");
    if (scene.surface && surface_moves(*scene.surface)) parts.emplace_back("t in surface.shape");
    return parts;
}

}  // namespace nullscope
