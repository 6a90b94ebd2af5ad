// The size of a scene's picture: the camera's and that of the keys of its path, which has one size on all its way.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace nullscope {

// Of a cube's picture, which has three columns and two rows of square faces: what it is where nobody says, and what it may be.
inline constexpr int kCubeWidth = 1536;
inline constexpr std::string_view kCubeSizes = "any three columns and two rows of square faces";
inline bool holds_cube(int width, int height) { return width % 3 == 0 && width / 3 * 2 == height; }
// One beside that size: whose faces it may have been meant for where it is a square, else as wide.
inline std::string cube_size_words(int width, int height, std::string_view between) {
    const int side = std::clamp(width == height ? width : (width + 1) / 3, 1, 65536 / 3);
    return fmt::format("{}{}{}", 3 * side, between, 2 * side);
}

inline void set_size(Scene& scene, int width, int height) {
    scene.camera.width = width, scene.camera.height = height;
    if (scene.path)
        for (PathKey& key : scene.path->keys) key.camera.width = width, key.camera.height = height;
}

}  // namespace nullscope
