// The size of a scene's picture: the camera's and that of the keys of its path, which has one size on all its way.
#pragma once
#include "scene/scene.h"

namespace nullscope {

inline void set_size(Scene& scene, int width, int height) {
    scene.camera.width = width, scene.camera.height = height;
    if (scene.path)
        for (PathKey& key : scene.path->keys) key.camera.width = width, key.camera.height = height;
}

}  // namespace nullscope
