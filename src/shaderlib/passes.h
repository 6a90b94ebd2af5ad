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
// How much of a picture may be drawn in tiles. kNone: nothing. kBodies: bodies are looked for in those that may show one. kTraced: so is the
// disc; the same picture, but more programs, which one picture is not worth. kInterpolated: and about a rotating hole the rays of tiles
// without bodies are interpolated, to 0.002 px (shaders/stage/tile_fit.glsl), and where they cross the disc once (shaders/stage/disc_fit.glsl), and so is the light of matter before nothing but a sky
// (shaders/stage/lattice.glsl).
enum class Tiles { kNone, kBodies, kTraced, kInterpolated };
std::vector<Pass> passes(const EffectSet& effects, Output output, Tiles tiles = Tiles::kBodies);

// Are some of its pixels drawn again with more rays?
bool refines(const std::vector<Pass>& passes);

// Does something work on the picture's light before it is encoded, so that it has to be kept?
bool keeps_light(const std::vector<Pass>& passes);

// What a pass says to the driver; of fullscreen passes the fragment shader alone.
std::string pass_text(const Pass& pass, const EffectSet& effects, const Method& method, std::string_view metric,
                      const BodyText& bodies);

}  // namespace nullscope
