#include "plan/moving.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "expr/formula.h"
#include "plan/body_kind.h"
#include "plan/medium.h"
#include "scene/bodies.h"
#include "scene/leaning_disc.h"
#include "scene/medium_dumps.h"

namespace nullscope {

bool surface_moves(const SurfaceSpec& surface) {
    if (surface.kind != SurfaceKind::kFormula) return false;
    constexpr std::size_t kTime = 3;
    const auto formula = expr::Formula::parse(surface.shape, {"x", "y", "z", "t"});
    return formula && formula->uses(kTime);
}

double unseen_radius(const Scene& scene, std::optional<double> horizon) {
    constexpr double kAbove = 0.01, kDarkAbove = 5e-4;  // of the horizon's radius
    if (!horizon || !scene.light.delay || !scene.light.lensing) return 0.0;
    const bool dark = std::ranges::all_of(scene.bodies, [](const Body& body) {
        return kind_of(body).moves(body) == nullptr || body.material.temperature_K;
    });
    const double radius = (1.0 + (dark ? kDarkAbove : kAbove)) * *horizon;
    return scene.camera.r > radius ? radius : 0.0;
}

std::vector<SceneFault> late_fall_faults(bool rotates, const Scene& scene) {
    constexpr double kLatest = 2e4;  // r_s/c from t = 0
    std::vector<SceneFault> faults;
    const double left = scene.time - (scene.light.delay ? std::fabs(scene.camera.r) : 0.0);
    if (!rotates || std::fabs(left) < kLatest) return faults;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (const auto* ball = std::get_if<BallSpec>(&scene.bodies[i].shape);
            ball != nullptr && ball->motion == BallMotion::kGeodesic)
            faults.push_back({body_section(scene, i) + ".motion",
                              fmt::format("light that left at about t = {:.6g} is too far from the start of a fall "
                                          "about a rotating hole",
                                          left),
                              fmt::format("times less camera.r within {:.0f} r_s/c of 0", kLatest)});
    return faults;
}

std::vector<std::string> moving_parts(const Scene& scene) {
    std::vector<std::string> parts;
    if (scene.disc && scene.disc->flow != DiscFlowKind::kStill) parts.emplace_back("disc.flow");
    if (scene.disc && !scene.spots.empty()) parts.emplace_back("spot.r");
    if (const char* key = scene.medium ? medium_moves(*scene.medium) : nullptr) parts.emplace_back(key);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (const char* key = kind_of(scene.bodies[i]).moves(scene.bodies[i]))
            parts.push_back(fmt::format("{}.{}", body_section(scene, i), key));
    return parts;
}

bool changes_with_time(const Scene& scene) {
    const bool film = has_dumps(scene) && scene.medium->grid.last > scene.medium->grid.first;
    return film || disc_precesses(scene) || !moving_parts(scene).empty();
}

std::string moving_words(const Scene& scene) {
    constexpr std::size_t kMost = 4;
    std::vector<std::string> parts = moving_parts(scene);
    const std::size_t more = parts.size() > kMost ? parts.size() - kMost : 0;
    parts.resize(parts.size() - more);
    return fmt::format("{}{}", fmt::join(parts, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace nullscope
