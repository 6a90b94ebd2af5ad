#include "fit/nuisance.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/text.h"

namespace nullscope::fit {

Result<Nuisance> parse_nuisance(const std::string& words, const Scene& scene) {
    Nuisance nuisance;
    if (words.empty()) return nuisance;
    const CameraSpec& camera = scene.camera;
    for (const std::string& part : split(words, ',')) {
        const std::string word = trim(part);
        if (word == "flux") {
            nuisance.flux = true;
        } else if (word == "centre") {
            nuisance.parameters.push_back(
                {"camera.shift_x", camera.shift_x - kCentreRange, camera.shift_x + kCentreRange, false});
            nuisance.parameters.push_back(
                {"camera.shift_y", camera.shift_y - kCentreRange, camera.shift_y + kCentreRange, false});
        } else if (word == "roll") {
            const double roll = camera.roll * 180 / M_PI;
            nuisance.parameters.push_back({"camera.roll", roll - 180, roll + 180});
        } else {
            return bad_input(without_controls(fmt::format("--nuisance {}: {} is none", words, word)),
                             "centre, roll, flux, with commas between");
        }
    }
    return nuisance;
}

Result<FreeScene> free_scene(const SceneFamily& fixed, const std::string& free, const std::string& nuisance) {
    TRY(parameters, parse_free(free));
    TRY(family, fixed.with(std::move(*parameters)));
    TRY(scene, fixed.at({}));
    TRY(more, parse_nuisance(nuisance, *scene));
    TRY(whole, family->with(more->parameters));
    return FreeScene{std::move(*whole), more->flux};
}

}  // namespace nullscope::fit
