// A scene as canonical text: the value of every key of a scene file, one a line. Two scenes have the same lines if and only if they are the
// same to the program: what no key can change is not there.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

struct SceneLine {
    std::string name;            // as the key of a scene file: "camera.r"
    std::string value;           // in the units of Scene; numbers with 17 digits, kinds by their number
    std::filesystem::path file;  // of an image; what is in it is not part of value
    friend bool operator==(const SceneLine&, const SceneLine&) = default;
};

std::vector<SceneLine> scene_lines(const Scene& scene);

}  // namespace nullscope
