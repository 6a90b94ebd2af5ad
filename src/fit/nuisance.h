// What a picture is free in that says nothing of its scene: where its middle lies, how it is turned, how bright it is.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "fit/free_parameters.h"
#include "scene/scene.h"

namespace nullscope::fit {

struct Nuisance {
    std::vector<FreeParameter> parameters;
    bool flux = false;
};
inline constexpr double kCentreRange = 0.05;  // of the picture's sides, to either side

// Of words as "centre,roll,flux": camera.shift_x and shift_y, camera.roll of any angle, the scale of all light. Errors (bad input): other words.
Result<Nuisance> parse_nuisance(const std::string& words, const Scene& scene);

// A scene with what is free in it, by the words of --free and --nuisance. Errors: those of parse_free, parse_nuisance, SceneFamily.
struct FreeScene {
    SceneFamily family;
    bool flux;
};
Result<FreeScene> free_scene(const SceneFamily& fixed, const std::string& free, const std::string& nuisance);

}  // namespace nullscope::fit
