#include "scenefile/disc_orbit_check.h"

#include <fmt/format.h>

#include "observer/observer.h"
#include "scene/leaning_disc.h"
#include "scene/orbit_sense.h"
#include "spacetime/leaning_circle.h"

namespace nullscope {
namespace {

bool disc_flows(const DiscSpec& disc) {
    return disc.emission == DiscEmission::kThermal || disc.flow != DiscFlowKind::kStill;
}

std::vector<SceneFault> leaning_faults(const Spacetime& spacetime, const Scene& scene) {
    if (!disc_leans(scene) || !spacetime.rotates()) return {};
    const DiscSpec& disc = *scene.disc;
    std::vector<SceneFault> faults;
    const auto refuse = [&](bool there, const char* key, const char* what, const char* allowed) {
        if (there)
            faults.push_back(
                {key, fmt::format("{}, and the disc leans about a rotating hole", what), allowed, "disc.tilt"});
    };
    const bool thermal = disc.emission == DiscEmission::kThermal;
    refuse(falls(scene.camera), "camera.observer", "the camera falls",
           "static, zamo, carter or orbit, or disc.tilt = 0");
    refuse(scene.camera.zoom.has_value(), "zoom.depth", "there is a zoom", "none, or disc.tilt = 0");
    refuse(thermal && disc.effects.limb_darkening, "disc.limb_darkening", "it is on", "off, or disc.tilt = 0");
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
