// nullscope bench frames --effects: what each effect costs, added alone to a scene that does without it.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/effects.h"

namespace nullscope::cli {

// Core-seconds of a frame with an effect, without it, and of the empty scene's.
struct EffectCost {
    Effect effect;
    double with_s, without_s, floor_s;
    double over_floor() const { return (with_s - without_s) / floor_s; }
};

// Of each effect of a scene that can go alone, the picture's size being the scene's. Errors: no context, what prepare() says.
Result<std::vector<EffectCost>> effect_costs(const Scene& scene, const std::string& context, int frames);

// Prints one line an effect and, if json names a file, writes the rows there. Every effect is drawn in turn with the scene without
// it (A B A B ...). Errors: no context, a file that cannot be written.
Status bench_effects(const std::string& context, int width, int height, int frames, const std::string& json);

}  // namespace nullscope::cli
