#include "shaderlib/passes.h"

#include <algorithm>

namespace nullscope {

namespace {

// A picture of matter before nothing but a sky.
void add_matter(std::vector<Pass>& list, Output light) {
    list.push_back({Stage::kLattice, Output::kLinear, "lattices of matter",
                    "its light 16, 8 and 4 px apart, finer where it is not smooth"});
    list.push_back({Stage::kLatticeTold, Output::kLinear, "told by coarser",
                    "nodes of a lattice whose light the next coarser one tells"});
    list.push_back({Stage::kLatticeCells, Output::kLinear, "cells of these",
                    "where the light between their nodes is told by them to 0.5 %"});
    list.push_back({Stage::kMatterTold, light, "tiles told by lattices", "the light of matter by these"});
    list.push_back({Stage::kMatterTraced, light, "tiles of matter", "elsewhere it is that of the pixel's ray"});
}

}  // namespace

std::vector<Pass> passes(const EffectSet& effects, Output output, Tiles tiles) {
    if (output == Output::kLayers) tiles = std::min(tiles, Tiles::kBodies);  // their programs know all layers
    const bool stars = effects.contains(Effect::kPointStars);
    const bool bloom = effects.contains(Effect::kBloom), meter = effects.contains(Effect::kAutoExposure);
    const bool refine = effects.contains(Effect::kRefine), samples = takes_samples(effects);
    const bool develop = output == Output::kDisplay && (stars || bloom || meter || samples);
    std::vector<Pass> list;
    const Output light = develop ? Output::kLinear : output;
    const bool disc = effects.contains(Effect::kDisc), find_bodies = tiles >= Tiles::kBodies && has_tiles(effects),
               find_disc = tiles >= Tiles::kTraced && tiles_classify_disc(effects),
               interpolated =
                   tiles >= Tiles::kInterpolated && !effects.contains(Effect::kSamples) && interpolates(effects);
    if (interpolated || find_disc)
        list.push_back({Stage::kRays, Output::kLinear, "rays of tiles",
                        "where the rays through the corners of the picture's tiles go"});
    if (interpolated || find_disc || find_bodies) {
        list.push_back({interpolated ? Stage::kTilesInterpolated
                        : find_disc  ? Stage::kTilesTraced
                                     : Stage::kTiles,
                        Output::kLinear, "tiles", "what the picture's tiles may show, by rays through each"});
        if (interpolated)
            list.push_back({Stage::kInterpolated, light, "sky interpolated",
                            "the sky alone, where the rays between a tile's are interpolated"});
        if (interpolated && interpolates_disc(effects))
            list.push_back({Stage::kInterpolatedDisc, light, "disc interpolated",
                            "the disc where these rays cross it once, and the sky behind it"});
        if (find_disc || !disc)
            list.push_back({Stage::kSkyTiles, light, "tiles of sky",
                            "every pixel traces its ray; neither disc nor bodies are looked for"});
        if (find_disc && tiles_classify_full_disc(effects))
            list.push_back({Stage::kFullDisc, light, "tiles full of disc",
                            "every pixel traces its ray to the crossing where it meets the disc"});
        if (disc) list.push_back({Stage::kDiscTiles, light, "tiles of disc", "the same, and the disc"});
        if (find_bodies) list.push_back({Stage::kBodyTiles, light, "tiles of bodies", "the same, and bodies"});
    } else if (tiles >= Tiles::kInterpolated && !effects.contains(Effect::kSamples) && interpolates_matter(effects)) {
        add_matter(list, light);
    } else {
        list.push_back({Stage::kPicture, light, "picture",
                        "one triangle over the picture: every pixel traces its ray and shades what it meets"});
    }
    if (refine)
        list.push_back({Stage::kEdges, Output::kLinear, "edges",
                        "marks pixels that differ from a neighbour; these are drawn again with 4, 16 or 36 rays"});
    if (refine)
        list.push_back({Stage::kPatches, Output::kLinear, "means of rays", "of these pixels, one ray a fragment"});
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

bool refines(const std::vector<Pass>& passes) {
    return std::ranges::find(passes, Stage::kEdges, &Pass::stage) != passes.end();
}

bool keeps_light(const std::vector<Pass>& passes) { return passes.back().stage == Stage::kDevelop; }

std::string pass_text(const Pass& pass, const EffectSet& effects, const Method& method, std::string_view metric,
                      const BodyText& bodies) {
    const ShaderSource source = shader_source(pass.stage, effects, pass.output, method, metric, bodies);
    return pass.stage == Stage::kStars ? source.vertex + source.fragment : source.fragment;
}

}  // namespace nullscope
