// What a picture shows while its shutter is open.
#pragma once
#include <utility>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope {

struct SubFrame {
    double share;  // of the time for which the shutter is open
    Scene scene;
};

// The picture's light is the mean of the sub-frames' light; without any it is the scene's. All else is of the scene: size, exposure,
// bloom, tone curve, letters.
struct Exposure {
    Exposure(Scene shown) : scene(std::move(shown)) {}  // NOLINT: implicit on purpose
    Scene scene;                                        // at the picture's own time
    std::vector<SubFrame> sub_frames{};                 // none, or two and more
};

// With every scene changed likewise: its left half, a part of the picture.
template <class Change>
Exposure changed(Exposure shown, const Change& change) {
    shown.scene = change(shown.scene);
    for (SubFrame& sub_frame : shown.sub_frames) sub_frame.scene = change(sub_frame.scene);
    return shown;
}

// The same where a change may fail.
template <class Change>
Result<Exposure> tried(Exposure shown, const Change& change) {
    const auto apply = [&](Scene& scene) -> Status {
        auto made = change(scene);
        if (!made) return made.error();
        scene = std::move(*made);
        return Done{};
    };
    if (Status done = apply(shown.scene); !done) return done.error();
    for (SubFrame& sub_frame : shown.sub_frames)
        if (Status done = apply(sub_frame.scene); !done) return done.error();
    return shown;
}

// The mean of what light(scene), a Result of an Image<float>, gives for each.
template <class Light>
auto mean_light(const Exposure& shown, const Light& light) {
    auto sum = light(shown.sub_frames.empty() ? shown.scene : shown.sub_frames.front().scene);
    if (!sum || shown.sub_frames.empty()) return sum;
    for (float& value : sum->data) value *= static_cast<float>(shown.sub_frames.front().share);
    for (std::size_t i = 1; i < shown.sub_frames.size(); ++i) {
        auto next = light(shown.sub_frames[i].scene);
        if (!next) return next;
        for (std::size_t k = 0; k < sum->data.size(); ++k)
            sum->data[k] += static_cast<float>(shown.sub_frames[i].share * next->data[k]);
    }
    return sum;
}

}  // namespace nullscope
