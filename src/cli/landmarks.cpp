// nullscope landmarks: characteristic radii of a scene's spacetime, and numbers of its camera's place and motion.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "command/json.h"
#include "observer/landmarks.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct LandmarksOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene;
    bool json = false;
};

struct NamedNumber {
    const char *key, *unit;
    std::string words;
    std::optional<double> value;  // nothing: there is none
};

std::vector<NamedNumber> numbers_of(const Spacetime& spacetime, const CameraSpec& camera) {
    const Landmarks marks = landmarks_of(spacetime);
    const CameraNumbers here = camera_numbers(spacetime, camera);
    const auto degrees = [](std::optional<double> angle) {
        return angle ? std::optional(*angle * 180.0 / M_PI) : angle;
    };
    std::string sense = "prograde ", other = "retrograde ";
    if (!spacetime.rotates()) sense = other = "";  // there are no two
    if (spacetime.a() < 0.0) sense = "towards growing phi, retrograde: ", other = "towards falling phi, prograde: ";
    const char* at = spacetime.by_proper_length() ? "r_s, l" : "r_s";
    const auto side = [&](std::size_t i) {
        return here.shadow_size ? std::optional((*here.shadow_size)[i]) : std::nullopt;
    };
    return {
        {"horizon", "r_s", marks.singular ? "singularity: a surface of no area, where light ends" : "outer horizon",
         marks.horizon},
        {"photon_orbit", at, spacetime.rotates() ? sense + "circular photon orbit" : "photon sphere",
         marks.photon_orbit},
        {"retrograde_photon_orbit", "r_s", other + "circular photon orbit", marks.retrograde_photon_orbit},
        {"isco", at, sense + "ISCO", marks.isco},
        {"retrograde_isco", "r_s", other + "ISCO", marks.retrograde_isco},
        {"critical_impact", "r_s", "critical impact parameter", marks.critical_impact},
        {"lapse", "", "dtau/dt of a local observer at rest (ZAMO) at the camera", here.lapse},
        {"clock_rate", "", "dtau/dt of the camera", here.clock_rate},
        {"shadow_radius", "deg", "angular radius of the shadow for an observer at rest there", degrees(here.shadow)},
        {"shadow_width", "deg", "angular width of the shadow for a ZAMO there", degrees(side(0))},
        {"shadow_height", "deg", "angular height of the shadow for a ZAMO there", degrees(side(1))},
        {"orbit_speed", "c", "speed of the circular geodesic there for observers at rest", here.orbit_speed},
        {"orbit_period", "r_s/c", "period of the circular geodesic there, in coordinate time", here.orbit_period},
    };
}

Result<int> run_landmarks(const LandmarksOptions& options) {
    TRY(scene, asked_scene(options));
    TRY(spacetime, make_spacetime(scene->spacetime.metric, scene->spacetime.parameters));
    Json json{{"scene", scene->name}, {"metric", scene->spacetime.metric}};
    for (const NamedNumber& number : numbers_of(**spacetime, scene->camera)) {
        json[number.key] = number.value ? Json(*number.value) : Json(nullptr);
        if (!options.json && number.value) fmt::print("{:<14.9g} {:<6} {}\n", *number.value, number.unit, number.words);
    }
    if (options.json) fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
    return 0;
}

}  // namespace

void add_landmarks(Command& parent) {
    auto [command, options] = add_command<LandmarksOptions>(parent, "landmarks",
                                                            "Characteristic radii of a scene's spacetime (horizon, "
                                                            "photon orbit, ISCO), its shadow and clocks at the camera",
                                                            run_landmarks);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene (see: nullscope scenes)");
    set_option(command, options.set);
    command.add_flag("--json", &options.json, "Print one JSON object; null: there is none");
}

}  // namespace nullscope::cli
