#include "scene/split.h"

#include <algorithm>

namespace nullscope {
namespace {

Scene half_of(Scene shown, const CameraSpec& camera, int width) {
    shown.split.reset();
    shown.camera = camera;
    shown.camera.width = std::max(width, 1);
    shown.camera.plane_width = camera.plane_width * shown.camera.width / camera.width;
    return shown;
}

}  // namespace

Halves halves(const Scene& scene, const Scene& other) {
    const int left = scene.camera.width / 2;
    return {half_of(scene, scene.camera, left), half_of(other, scene.camera, scene.camera.width - left)};
}

std::optional<Halves> halves(const Scene& scene) {
    if (!scene.split) return std::nullopt;
    Scene other = scene;
    other.spacetime = *scene.split;
    other.light.delay = scene.light.delay && scene.split_delay;
    return halves(scene, other);
}

}  // namespace nullscope
