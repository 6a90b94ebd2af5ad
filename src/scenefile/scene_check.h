// What of a scene's values, each within its own range, does not go together.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

// Whether the file has a key, by its full name.
using GivenKeys = std::function<bool(const std::string& name)>;

// Defaults that depend on other keys, of those that are not given: of the picture's size, before the camera is checked, and of the rest.
void settle_size(Scene& scene, const GivenKeys& given);
void settle_defaults(Scene& scene, const GivenKeys& given);

std::vector<SceneFault> check_camera(const Scene& scene, const GivenKeys& given);
// All parts but the camera. Moving bodies are checked last and only if nothing else is wrong, because that costs more.
std::vector<SceneFault> check_parts(const Scene& scene, const GivenKeys& given);

}  // namespace nullscope
