// Split screen: two spacetimes, one camera.
#pragma once
#include <optional>

#include "scene/scene.h"

namespace nullscope {

// What each half shows: the scene's camera at the same coordinates, each half centred, pixels as large as in the whole.
struct Halves {
    Scene left, right;
};
Halves halves(const Scene& scene, const Scene& other);  // beside a scene of its own, camera apart
std::optional<Halves> halves(const Scene& scene);       // beside scene.split; nothing where there is none

}  // namespace nullscope
