// Scenes that nobody wrote: those that ship, with other numbers.
#pragma once
#include <random>

#include "scene/scene.h"
#include "scenefile/scene_keys.h"

namespace nullscope::test {

// Another value of some number keys, among those that have a meaning here.
inline Scene changed_scene(Scene scene, std::mt19937& random) {
    if (random() % 8 == 0) scene.camera.zoom = ZoomSpec{1.0, 0.0};
    for (const SceneKey& key : scene_keys()) {
        const bool there = key.section.empty() || key.section == "camera" || key.section == "sky" ||
                           key.section == "picture" || (key.section == "disc" && scene.disc) ||
                           (key.section == "path" && scene.path) || (key.section == "zoom" && scene.camera.zoom);
        if (!there || key.type != KeyType::kNumber || !key.member.readable() || random() % 3 != 0) continue;
        if (key.meant != nullptr && !key.meant(scene)) continue;
        KeyValue value = key.member.get(scene);
        if (!value.there) continue;
        const double share = std::uniform_real_distribution<double>(0.7, 1.3)(random);
        value.number = value.number == 0.0 ? 0.1 * share : value.number * share;
        // What is counted in the file's unit stays within its range: an opacity of 1 grows no further.
        const bool same_unit = key.unit != "deg" && key.range.low < key.range.high;
        if (same_unit && !key.range.contains(value.number)) continue;
        key.member.set(scene, value);
    }
    return scene;
}

}  // namespace nullscope::test
