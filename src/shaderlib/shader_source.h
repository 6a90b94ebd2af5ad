// Final GLSL text: a file of shaders/stage with what it includes, as far as the EffectSet calls for it. No GL in it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plan/effects.h"
#include "shaderlib/body_text.h"
#include "shaderlib/method.h"

namespace nullscope {

// kEdges: marks the picture's pixels that differ much from a neighbour. kPatches: the means of their rays. kStars: points added to the picture. kBloomDown, kBloomUp, kMeter: of the picture in
// linear light. kDevelop: from it to the display. kRayDepth: beside ray data, for layers. kBareFetch: one fetch of the sky a pixel,
// a baseline of cost. Tiles are squares of the picture. kRays: the rays through their corners. kTiles: which bodies they may show;
// kTilesTraced: and whether the disc; kTilesInterpolated: and whether their rays may be interpolated. The picture in these: kInterpolated, and
// kInterpolatedDisc where they cross the disc once;
// in the others kSkyTiles, where neither body nor disc is seen; kFullDisc, where nothing but the disc is; kDiscTiles, where no body is;
// kBodyTiles, the rest. kInterpolatedRays, kInterpolatedPlaces: where interpolated rays go, and where they cross the disc, for tests.
// kLattice: the light of matter on a lattice of the picture, by rays; kLatticeTold: by the next coarser one; kLatticeCells: where it tells the light
// between its nodes. kMatterTold: the tiles of a picture that it tells; kMatterTraced: the others.
// kRayList: ray data of a list, one ray a fragment.
enum class Stage {
    kPicture,
    kEdges,
    kPatches,
    kStars,
    kBloomDown,
    kBloomUp,
    kMeter,
    kDevelop,
    kRayData,
    kRayDepth,
    kBareFetch,
    kRays,
    kTiles,
    kTilesTraced,
    kTilesInterpolated,
    kInterpolated,
    kInterpolatedDisc,
    kSkyTiles,
    kFullDisc,
    kDiscTiles,
    kBodyTiles,
    kInterpolatedRays,
    kInterpolatedPlaces,
    kLattice,
    kLatticeTold,
    kLatticeCells,
    kMatterTold,
    kMatterTraced,
    kRayList
};
inline constexpr int kTileSide = 8;  // px, of the smallest tiles, and of groups of compute threads
// px. Where tiles tell nothing but disc and sky apart larger ones cost less: a point takes a software driver as long as 30 pixels of sky. Those that
// list bodies or interpolate rays are small.
int tile_side(const EffectSet& effects);
constexpr int tiles_along(int pixels, int side = kTileSide) { return (pixels + side - 1) / side; }
inline constexpr int kFirstTiles = 4;  // tiles a side of those of the first pass, which bodies are looked for in
// Of the target of pixels with more rays (render/ray_patches.h). No power of two: llvmpipe compiles once more for textures of such sizes.
inline constexpr int kPatchesSide = 184;
int rays_a_tile(
    const EffectSet& effects);  // of stage kRays: through the corner, and through the middle if rays are interpolated
// Whether a stage's text depends on the scene at all; else one program serves every scene.
constexpr bool knows_scene(Stage stage) {
    return stage != Stage::kBloomDown && stage != Stage::kBloomUp && stage != Stage::kMeter;
}
// kDisplay: exposure and sRGB encoding in the shader (8-bit targets). kLayers: linear light of one layer (render/picture_layers.h).
enum class Output { kLinear, kDisplay, kLayers };

// Does a stage draw tiles of a picture by lattices of matter?
constexpr bool is_of_matter(Stage stage) { return stage == Stage::kMatterTold || stage == Stage::kMatterTraced; }

// Does a stage draw a lattice's nodes, or mark its cells?
constexpr bool draws_lattice(Stage stage) {
    return stage == Stage::kLattice || stage == Stage::kLatticeTold || stage == Stage::kLatticeCells;
}

// Does a stage draw rays that are interpolated?
constexpr bool is_interpolated(Stage stage) {
    return stage == Stage::kInterpolated || stage == Stage::kInterpolatedDisc || stage == Stage::kInterpolatedRays ||
           stage == Stage::kInterpolatedPlaces;
}

// Does a stage draw the picture, whole or in part?
constexpr bool draws_picture(Stage stage) {
    return stage == Stage::kPicture || is_of_matter(stage) || stage == Stage::kInterpolated ||
           stage == Stage::kInterpolatedDisc || stage == Stage::kSkyTiles || stage == Stage::kFullDisc ||
           stage == Stage::kDiscTiles || stage == Stage::kBodyTiles;
}

// In one triangle?
constexpr bool is_whole(Stage stage) { return stage == Stage::kPicture; }

// Does a stage tell what the picture's tiles may show?
constexpr bool finds_tiles(Stage stage) {
    return stage == Stage::kTiles || stage == Stage::kTilesTraced || stage == Stage::kTilesInterpolated;
}

// Is it one of those that a picture in tiles consists of?
constexpr bool is_in_tiles(Stage stage) {
    return stage == Stage::kRays || finds_tiles(stage) || (draws_picture(stage) && !is_whole(stage));
}

// Does it tell what the picture's rows ask for, before these are drawn?
constexpr bool goes_before(Stage stage) { return stage == Stage::kRays || finds_tiles(stage) || draws_lattice(stage); }

// What every text begins with: the language, and that all is exact; GLSL ES (of browsers) gives samplers few digits unless it is asked.
enum class Glsl { k330, kEs300 };
std::string_view shader_head(Glsl language);

// What automatic exposure makes of the picture's mean luminance.
inline constexpr double kMeterKey = 0.12;

struct ShaderSource {
    std::string vertex, fragment;
};

// method counts only if the effects contain lensing; metric: the registry's key, for methods that need the metric's formula.
// bodies: body_text of a scene with these effects. Stages kRayData, kRayDepth and kRayList leave out the looks of sky, disc and bodies. Output concerns the picture only.
ShaderSource shader_source(Stage stage, const EffectSet& effects, Output output, const Method& method = {},
                           std::string_view metric = "schwarzschild", const BodyText& bodies = {});

// Can a stage be drawn by compute? What follows rays can. Interpolated ones are a tile's vertex shader's.
constexpr bool computes(Stage stage) {
    return (draws_picture(stage) && !is_interpolated(stage)) || stage == Stage::kRays || finds_tiles(stage) ||
           stage == Stage::kLattice || stage == Stage::kRayData || stage == Stage::kRayList;
}

// Are its tiles, of the picture or of a lattice, listed first?
constexpr bool lists_tiles(Stage stage) {
    return computes(stage) && ((draws_picture(stage) && !is_whole(stage)) || stage == Stage::kLattice);
}
// What such a stage draws as a compute shader of the same functions, without what it begins with (gl/compute.h). patches: also pixels that are
// drawn again with more rays, where the effects have them.
std::string compute_source(Stage stage, const EffectSet& effects, Output output, const Method& method = {},
                           std::string_view metric = "schwarzschild", const BodyText& bodies = {},
                           bool patches = false);
// And what lists the tiles that it draws, of a stage that is drawn in tiles.
std::string tile_list_source(Stage stage);

// Which members of FrameData (shaders/shared/frame_block.glsl, numbered as in the file) the block of these effects has, in order.
std::vector<int> block_members(const EffectSet& effects);

// Is there shaders/FOLDER/METRIC.glsl in this build?
bool has_shader(std::string_view folder, std::string_view metric);

// #include "PATH", as generated texts have it.
std::string include_line(std::string_view path);

// One embedded file of shaders/ by its path there; aborts if there is none (a broken build).
std::string_view shader_file(std::string_view path);

}  // namespace nullscope
