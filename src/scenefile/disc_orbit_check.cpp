#include "scenefile/disc_orbit_check.h"

#include <fmt/format.h>

#include "observer/observer.h"
#include "scene/leaning_disc.h"
#include "scene/orbit_sense.h"
#include "spacetime/leaning_circle.h"

namespace nullscope {
namespace {

constexpr double kLeaningInner =
    1.05;  // of the horizon's radius, seen by a camera that falls (reference/leaning_watch.cpp, mino/step.glsl)

bool disc_flows(const DiscSpec& disc) {
    return disc.emission == DiscEmission::kThermal || disc.flow != DiscFlowKind::kStill;
}

std::vector<SceneFault> leaning_faults(const Spacetime& spacetime, const Scene& scene) {
    if (!disc_leans(scene) || !spacetime.rotates()) return {};
    const DiscSpec& disc = *scene.disc;
    std::vector<SceneFault> faults;
    const auto refuse = [&](bool there, const char* key, const char* what, const std::string& allowed) {
        if (there)
            faults.push_back(
                {key, fmt::format("{}, and the disc leans about a rotating hole", what), allowed, "disc.tilt"});
    };
    const double least = kLeaningInner * spacetime.horizon_radius().value_or(0.0);
    refuse(falls(scene.camera) && disc.inner < least, "disc.inner",
           "the camera falls, and sees light that winds round next to the horizon",
           fmt::format("at least {:.6g}, or disc.tilt = 0", least));
    refuse(has_polarised_disc(scene), "disc.polarisation", "there is one", "off, or disc.tilt = 0");
    if (!faults.empty()) return faults;
    const auto check = [&](const char* key, double inner, double outer, OrbitSense sense) {
        const auto limit = leaning_disc_limit(spacetime, inner, outer, sense_about(spacetime, sense), disc.lean.tilt);
        if (limit)
            faults.push_back(
                {key,
                 fmt::format("at {:.4g} its matter would outrun light on circles about an axis that leans", *limit),
                 fmt::format("above {:.4g}, or disc.tilt = 0", *limit)});
    };
    if (disc_flows(disc)) check("disc.inner", disc.inner, disc.outer, disc.sense);
    for (const SpotSpec& spot : scene.spots)
        if (faults.empty()) check("spot.r", spot.r, spot.r * 1.0001, spot.sense);
    return faults;
}

}  // namespace

std::vector<SceneFault> disc_orbit_faults(const Spacetime& spacetime, const Scene& scene) {
    std::vector<SceneFault> faults = leaning_faults(spacetime, scene);
    if (!faults.empty() || !scene.disc || !disc_flows(*scene.disc)) return faults;
    const double most = outermost_circular_orbit(spacetime);
    if (scene.disc->outer <= most) return {};
    return {{"disc.outer",
             fmt::format("at {} its matter is pulled outward by a cosmological constant", scene.disc->outer),
             fmt::format("at most {:.6g}, or a disc that neither is thermal nor flows", most)}};
}

}  // namespace nullscope
