// What is drawn for a picture, in order: the renderer runs it, `nullscope plan` prints it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "shaderlib/shader_source.h"

namespace nullscope {

struct Pass {
    Stage stage;
    Output output;
    std::string_view name;  // "picture"
    std::string_view what;  // a person's words
};

// kDisplay: to 8 bits. kLinear: linear light, nothing done to it.
// tiles: false draws the picture at once even where it could be done in tiles.
std::vector<Pass> passes(const EffectSet& effects, Output output, bool tiles = true);

// Does something work on the picture's light before it is encoded, so that it has to be kept?
bool keeps_light(const std::vector<Pass>& passes);

// What a pass says to the driver; of fullscreen passes the fragment shader alone.
std::string pass_text(const Pass& pass, const EffectSet& effects, const Method& method, std::string_view metric,
                      const BodyText& bodies);

}  // namespace nullscope
