// Inside scene only: what must hold between the keys of solid bodies, and between them and the camera.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

struct BodyFault {
    std::string key;  // full name
    std::string what, allowed;
};

// given: whether the file has a key, by its full name. horizon: radius, 0 if there is none.
std::vector<BodyFault> check_bodies(const Scene& scene, double horizon,
                                    const std::function<bool(const std::string&)>& given);

}  // namespace nullscope
