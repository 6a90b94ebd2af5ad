#include "shaderlib/passes.h"

namespace nullscope {

std::vector<Pass> passes(const EffectSet& effects, Output output, bool tiles) {
    const bool stars = effects.contains(Effect::kPointStars);
    const bool bloom = effects.contains(Effect::kBloom), meter = effects.contains(Effect::kAutoExposure);
    const bool develop = output == Output::kDisplay && (stars || bloom || meter);
    std::vector<Pass> list;
    const Output light = develop ? Output::kLinear : output;
    if (tiles && has_tiles(effects)) {
        list.push_back({Stage::kTiles, Output::kLinear, "tiles",
                        "which tiles of the picture may show a body: five rays a tile, beside each other"});
        list.push_back({Stage::kClearTiles, light, "tiles without bodies",
                        "every pixel traces its ray and shades what it meets; bodies are not looked for"});
        list.push_back({Stage::kBodyTiles, light, "tiles with bodies", "the same, and bodies"});
    } else {
        list.push_back({Stage::kPicture, light, "picture",
                        "one triangle over the picture: every pixel traces its ray and shades what it meets"});
    }
    if (stars)
        list.push_back({Stage::kStars, Output::kLinear, "stars", "a point for every image of every star, added to it"});
    if (develop && (bloom || meter))
        list.push_back({Stage::kBloomDown, output, "bloom down", "halves of the picture, until 8 px are left"});
    if (develop && bloom)
        list.push_back({Stage::kBloomUp, output, "bloom up", "from the coarsest half to the finest, added up"});
    if (develop && meter) list.push_back({Stage::kMeter, output, "meter", "mean luminance of the coarsest half"});
    if (develop) list.push_back({Stage::kDevelop, output, "develop", "from linear light to the display"});
    return list;
}

bool keeps_light(const std::vector<Pass>& passes) { return passes.back().stage == Stage::kDevelop; }

std::string pass_text(const Pass& pass, const EffectSet& effects, const Method& method, std::string_view metric,
                      const BodyText& bodies) {
    const ShaderSource source = shader_source(pass.stage, effects, pass.output, method, metric, bodies);
    return pass.stage == Stage::kStars ? source.vertex + source.fragment : source.fragment;
}

}  // namespace nullscope
