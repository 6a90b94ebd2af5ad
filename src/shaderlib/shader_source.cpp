#include "shaderlib/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "plan/medium_model.h"
#include "shaderlib/embedded.h"
#include "shaderlib/preprocess.h"
#include "shaderlib/projection_text.h"
#include "shaderlib/slots.h"

namespace nullscope {
namespace {

#ifdef __wasm__
constexpr Glsl kGlsl = Glsl::kEs300;
#else
constexpr Glsl kGlsl = Glsl::k330;
#endif

// What stands for "generated/method" (sweep_to_sky, or how a rotating hole's rays are traced): constants, and a file.
std::string method_text(const Method& method, std::string_view metric) {
    switch (method.kind) {
        case MethodKind::kStrip: return include_line(method.cubic ? "method/strip_cubic.glsl" : "method/strip.glsl");
        case MethodKind::kTable:
            return fmt::format("#define TABLE_SIZE {}\n", method.size) + include_line("method/table.glsl");
        case MethodKind::kClosedForm: return include_line(fmt::format("method/closed_form/{}.glsl", metric));
        case MethodKind::kIntegrate:
            return fmt::format("#define STEP_ANGLE {:.9f}\n#define STEP_MOST {}\n", method.step, method.most_steps) +
                   include_line("method/integrate.glsl");
        case MethodKind::kMino:
            return fmt::format("#define SPIN_STEP {:.9f}\n#define SPIN_MOST_STEPS {}\n", method.step,
                               method.most_steps) +
                   (method.order == 4 ? include_line("mino/fourth_order.glsl") : "");
        case MethodKind::kKerrSchild:
            return fmt::format("#define KERR_SCHILD_STEP {:.9f}\n", method.step) +
                   include_line("mino/kerr_schild.glsl");
    }
    return "";
}

std::vector<std::string> method_defines(const Method& method) {
    if (method.kind == MethodKind::kKerrSchild) return {"METHOD_KERR_SCHILD", "METHOD_COUNTS"};
    if (method.kind == MethodKind::kMino)
        return {"METHOD_MINO", fmt::format("METHOD_MINO_{}", method.order), "METHOD_COUNTS"};
    if (method.kind == MethodKind::kIntegrate) return {fmt::format("STEP_ORDER_{}", method.order)};
    if (method.kind != MethodKind::kTable) return {};
    constexpr const char* kTables[] = {"TABLE_HARDWARE", "TABLE_BILINEAR", "TABLE_CUBIC",
                                       "TABLE_HERMITE"};  // by Lookup
    return {kTables[static_cast<int>(method.lookup)]};
}

std::vector<std::string> defines_of(const EffectSet& effects) {
    std::vector<std::string> defines;
    for (const Effect effect : effects.list()) {
        defines.emplace_back(effect_row(effect).define);
        defines.push_back("BLOCK_" + defines.back().substr(std::string_view("EFFECT_").size()));
    }
    if (polarises(effects)) defines.emplace_back("BLOCK_SCREEN");
    if (takes_samples(effects)) defines.emplace_back("NEEDS_SAMPLING");
    if (has_solids(effects)) defines.emplace_back("NEEDS_PLACE");
    if (const MediumModel* model = model_of(effects)) {
        defines.emplace_back("BLOCK_MEDIUM");
        for (const auto& [has, define] :
             {std::pair{model->traits.own_steps, "MEDIUM_OWN_STEPS"},
              {model->traits.azimuth, "MEDIUM_AZIMUTH"},
              {model->traits.turn, "MEDIUM_TURN"},
              {model->traits.any_density || effects.contains(Effect::kMediumBands), "MEDIUM_ANY_DENSITY"}})
            if (has) defines.emplace_back(define);
    }
    if (!projections_of(effects).empty()) defines.emplace_back("BLOCK_PROJECTION");
    if (has_marched(effects)) defines.emplace_back("BLOCK_MARCH");
    if (has_marched(effects) && light_path_kind(effects) == LightPathKind::kPlanar && !effects.contains(Effect::kSides))
        defines.emplace_back("MARCH_PASSES");
    bool delayed = effects.contains(Effect::kDiscFlow);
    for (const SlotText& filled : slot_texts(effects)) {
        defines.emplace_back(filled.define);
        delayed = delayed || filled.slot == Slot::kDiscGlow;
        if (filled.slot == Slot::kDiscLight) defines.emplace_back("NEEDS_RISE");
    }
    if (delayed) defines.emplace_back("NEEDS_DELAY");
    const bool delay = effects.contains(Effect::kDelay);
    if (effects.contains(Effect::kThermalDisc) || effects.contains(Effect::kNarrowDisc) ||
        (effects.contains(Effect::kDisc) && delay))
        defines.emplace_back("NEEDS_ZETA_SLOPE");
    if (moves(effects) || (delay && (effects.contains(Effect::kSurface) || effects.contains(Effect::kMediumMotion))))
        defines.emplace_back("NEEDS_PLACE_LATE");
    const bool sky = effects.contains(Effect::kSky), far_sky = effects.contains(Effect::kFarSky);
    if (far_sky && !sky) defines.emplace_back("BLOCK_SKY");
    if (sky && (far_sky || effects.contains(Effect::kBounce))) defines.emplace_back("NEEDS_SKY_OF_EVERY_RAY");
    return defines;
}

std::vector<std::string> members_of(const std::string& block) {
    std::vector<std::string> members;
    constexpr std::string_view kType = "vec4 ";
    for (std::size_t at = block.find(kType); at != std::string::npos; at = block.find(kType, at + 1)) {
        const std::size_t name = at + kType.size();
        members.push_back(block.substr(name, block.find(';', name) - name));
    }
    return members;
}

struct StageFiles {
    const char *vertex, *fragment;
};
constexpr const char *kFullscreen = "stage/fullscreen.vert", *kTile = "stage/tile.vert",
                     *kInterpolated = "stage/interpolated.vert";
constexpr StageFiles kStageFiles[] = {  // by Stage
    {"stage/picture.vert", "stage/trace.frag"},
    {kFullscreen, "stage/edges.frag"},
    {"stage/patches.vert", "stage/patches.frag"},
    {"stage/star.vert", "stage/star.frag"},
    {kFullscreen, "stage/bloom_down.frag"},
    {kFullscreen, "stage/bloom_up.frag"},
    {kFullscreen, "stage/meter.frag"},
    {kFullscreen, "stage/develop.frag"},
    {kFullscreen, "stage/raydata.frag"},
    {kFullscreen, "stage/raydepth.frag"},
    {kFullscreen, "stage/bare_fetch.frag"},
    {kFullscreen, "stage/rays.frag"},
    {kFullscreen, "stage/tiles.frag"},
    {kFullscreen, "stage/tiles.frag"},
    {kFullscreen, "stage/tiles.frag"},
    {kInterpolated, "stage/interpolated.frag"},
    {kInterpolated, "stage/interpolated.frag"},
    {kTile, "stage/trace.frag"},
    {kTile, "stage/trace.frag"},
    {kTile, "stage/trace.frag"},
    {kTile, "stage/trace.frag"},
    {kInterpolated, "stage/interpolated_rays.frag"},
    {kInterpolated, "stage/interpolated_rays.frag"},
    {"stage/lattice_nodes.vert", "stage/lattice.frag"},
    {"stage/lattice_nodes.vert", "stage/lattice.frag"},
    {kFullscreen, "stage/lattice_cells.frag"},
    {"stage/lattice_picture.vert", "stage/trace.frag"},
    {"stage/lattice_picture.vert", "stage/trace.frag"},
    {kFullscreen, "stage/ray_list.frag"}};

const EmbeddedShader* find_file(std::string_view path) {
    const auto files = embedded_shaders();
    const auto found = std::ranges::find(files, path, &EmbeddedShader::path);
    return found != files.end() ? &*found : nullptr;
}

bool has_told_disc(Stage stage) { return stage == Stage::kInterpolatedDisc || stage == Stage::kInterpolatedPlaces; }

// What a stage of these effects is compiled with.
std::vector<std::string> stage_defines(Stage stage, const EffectSet& effects, Output output, const Method& method) {
    std::vector<std::string> defines;
    if (stage != Stage::kBareFetch) defines = defines_of(effects);
    const bool sky_alone = (is_interpolated(stage) && !has_told_disc(stage)) || stage == Stage::kSkyTiles,
               no_bodies = sky_alone || has_told_disc(stage) || stage == Stage::kFullDisc ||
                           stage == Stage::kDiscTiles || stage == Stage::kRays;
    const bool objects =
        (!no_bodies && has_solids(effects)) || (!sky_alone && effects.contains(Effect::kDisc)) || has_medium(effects);
    const bool list = stage == Stage::kRayList, data = list || stage == Stage::kRayData || stage == Stage::kRayDepth;
    if (data || objects || effects.contains(Effect::kDelay)) defines.emplace_back("NEEDS_PHI_END");
    if (data && light_path_kind(effects) == LightPathKind::kMino) defines.emplace_back("NEEDS_FINE_AZIMUTH");
    if (effects.contains(Effect::kDelay) || (data && effects.contains(Effect::kLightTimes)))
        defines.emplace_back("NEEDS_LIGHT_TIMES");
    if (data && effects.contains(Effect::kLightTimes)) {
        if (has_solids(effects)) defines.emplace_back("NEEDS_PLACE_TIME");
        if (effects.contains(Effect::kDisc)) defines.emplace_back("NEEDS_ZETA_SLOPE");
    }
    if (list) defines.emplace_back("RAYS_OF_A_LIST");
    if (stage == Stage::kStars && light_path_kind(effects) == LightPathKind::kPlanar)
        defines.emplace_back("NEEDS_VIEW_PLACE");
    if (stage == Stage::kRayDepth && has_medium(effects)) defines.emplace_back("MEDIUM_MEAN");
    if (list && effects.contains(Effect::kDisc)) defines.emplace_back("NEEDS_ZETA_SLOPE");
    if (no_bodies) std::erase(defines, "NEEDS_PLACE");
    if (sky_alone) std::erase(defines, "EFFECT_DISC"), std::erase(defines, "EFFECT_DISC_LEAN");
    if (stage == Stage::kSkyTiles) defines.emplace_back("TILES_OF_SKY");
    if (stage == Stage::kDiscTiles) defines.emplace_back("TILES_OF_THE_REST");
    if (stage == Stage::kFullDisc) defines.emplace_back("TILES_OF_FULL_DISC");
    if (stage == Stage::kRays) defines.emplace_back("EVERY_CROSSING");
    if (finds_tiles(stage) && has_tiles(effects)) defines.emplace_back("TILES_OF_BODIES");
    if (stage == Stage::kTilesTraced || stage == Stage::kTilesInterpolated) {
        if (tiles_classify_disc(effects)) defines.emplace_back("TILES_OF_DISC");
        if (tiles_classify_full_disc(effects)) defines.emplace_back("TILES_OF_FULL_DISC");
    }
    if (stage == Stage::kTilesInterpolated) defines.emplace_back("TILES_INTERPOLATED");
    if (has_told_disc(stage)) defines.emplace_back("INTERPOLATED_DISC");
    if (interpolates_disc(effects) &&
        (stage == Stage::kRays || stage == Stage::kTilesInterpolated || has_told_disc(stage)))
        defines.emplace_back("CROSSINGS_TOLD");
    if (stage == Stage::kBodyTiles) defines.emplace_back("TILES_WITH_BODIES");
    if (stage == Stage::kLatticeTold || stage == Stage::kMatterTold) defines.emplace_back("LATTICE_TOLD");
    if (is_of_matter(stage)) defines.emplace_back("MATTER_LATTICE");
    if (is_of_matter(stage) && (effects.contains(Effect::kSky) || effects.contains(Effect::kSkyPattern)))
        defines.emplace_back("LATTICE_BEFORE_SKY");
    if (draws_picture(stage)) defines.emplace_back("NEEDS_FOOTPRINT");
    if (draws_picture(stage) && output == Output::kDisplay) defines.emplace_back("DISPLAY_ENCODE");
    if (draws_picture(stage) && output == Output::kLayers) defines.emplace_back("LAYERS");
    const bool lights = (draws_picture(stage) || draws_lattice(stage)) && !sky_alone,
               stokes = lights && output == Output::kLayers, disc = effects.contains(Effect::kPolarisation),
               medium = effects.contains(Effect::kMediumPolarisation);
    if (stokes && (disc || medium)) defines.emplace_back("NEEDS_STOKES");
    if (stokes && disc) defines.emplace_back("NEEDS_DISC_STOKES");
    if (disc && (stokes || (lights && effects.contains(Effect::kPolariser))))
        for (const char* define : {"NEEDS_SCREEN", "NEEDS_POLARISATION", "NEEDS_RISE"}) defines.emplace_back(define);
    if (lights && medium)
        for (const char* define : {"NEEDS_SCREEN", "MEDIUM_STOKES"}) defines.emplace_back(define);
    for (std::string& define : method_defines(method)) defines.push_back(std::move(define));
    return defines;
}

}  // namespace

std::string_view shader_head(Glsl language) {
    constexpr std::string_view kDesktop = "#version 330 core\nprecision highp float;\nprecision highp int;\n";
    constexpr std::string_view kEs =
        "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
        "precision highp sampler2DArray;\n";
    return language == Glsl::kEs300 ? kEs : kDesktop;
}

int tile_side(const EffectSet& effects) {
    const bool disc_alone = tiles_classify_full_disc(effects) && !has_tiles(effects) && !has_medium(effects);
    return disc_alone ? 2 * kTileSide : kTileSide;
}

int rays_a_tile(const EffectSet& effects) { return interpolates(effects) ? 2 : 1; }

bool has_shader(std::string_view folder, std::string_view metric) {
    return find_file(fmt::format("{}/{}.glsl", folder, metric)) != nullptr;
}

std::string include_line(std::string_view path) { return fmt::format("#include \"{}\"\n", path); }

std::string_view shader_file(std::string_view path) {
    if (const EmbeddedShader* file = find_file(path)) return file->text;
    std::fprintf(stderr, "shader_file: no shaders/%.*s in this build\n", static_cast<int>(path.size()), path.data());
    std::abort();
}

std::vector<int> block_members(const EffectSet& effects) {
    const std::string block(shader_file("shared/frame_block.glsl"));
    const std::vector<std::string> all = members_of(block),
                                   kept = members_of(resolved_branches(block, defines_of(effects)));
    std::vector<int> members;
    for (std::size_t i = 0, next = 0; i < all.size() && next < kept.size(); ++i)
        if (all[i] == kept[next]) members.push_back(static_cast<int>(i)), ++next;
    return members;
}

namespace {

// The texts of these files, as a stage of these effects has them.
std::vector<std::string> texts_of(std::initializer_list<const char*> files, Stage stage,
                                  std::vector<std::string> defines, const EffectSet& effects, const Method& method,
                                  std::string_view metric, const BodyText& bodies) {
    // Formulas of temperature and field may depend on the azimuth, though the model does not.
    if (const MediumModel* model = model_of(effects);
        model != nullptr && !model->traits.turn && (model->shares & kWarmth) != 0 && bodies.law_by_place)
        defines.emplace_back("MEDIUM_TURN");
    ProjectionText projection = projection_text(projections_of(effects));
    std::map<std::string_view, std::string> generated = {
        {"generated/projection", std::move(projection.files)},
        {"generated/projection_view", std::move(projection.view)},
        {"generated/projection_place", std::move(projection.place)},
        {"generated/method", method_text(method, metric)},
        {"generated/metric", include_line(fmt::format("spacetime/{}.glsl", metric))},
        {"generated/constants", fmt::format("#define METER_KEY {}\n", kMeterKey)},
        {"generated/tiles", fmt::format("#define TILE_SIDE {}\n#define TILE_GROUPS {}\n#define PATCHES_SIDE "
                                        "{}\n#define RAYS_A_TILE {}\n#define FIRST_TILES {}\n",
                                        tile_side(effects), tile_side(effects) / kTileSide, kPatchesSide,
                                        rays_a_tile(effects), kFirstTiles)},
        {"generated/objects", bodies.objects},
        {"generated/surfaces", bodies.surfaces},
        {"generated/bodies_march", bodies.march},
        {"generated/bodies_hit", bodies.hit},
        {"generated/bodies_light", bodies.light},
        {"generated/bodies_shift", bodies.shift},
        {"generated/materials", bodies.materials},
        {"generated/medium_law", bodies.law},
        {"generated/medium_matter", bodies.medium}};
    for (SlotText& filled : slot_texts(effects)) generated[filled.name] = std::move(filled.text);
    const char* path = light_path_kind(effects) == LightPathKind::kMino ? "mino" : "planar";
    std::map<std::string, std::string, std::less<>> chosen;  // "path/trace": the file of the kind of path
    const ShaderReader read = [&](std::string_view name) -> std::string_view {
        if (const auto part = generated.find(name); part != generated.end()) return part->second;
        if (!name.starts_with(kPathPrefix)) return shader_file(name);
        return chosen[std::string(name)] = path_line(path, !is_interpolated(stage) ? name
                                                           : name == "path/trace"  ? "path/interpolated"
                                                           : name == "path/disc"   ? "path/interpolated_disc"
                                                                                   : name);
    };
    std::vector<std::string> texts;
    for (const char* file : files) texts.push_back(resolved_text(file, defines, read));
    return texts;
}

}  // namespace

ShaderSource shader_source(Stage stage, const EffectSet& effects, Output output, const Method& method,
                           std::string_view metric, const BodyText& bodies) {
    const StageFiles& files = kStageFiles[static_cast<std::size_t>(stage)];
    const std::vector<std::string> texts =
        texts_of({files.vertex, files.fragment}, stage, stage_defines(stage, effects, output, method), effects, method,
                 metric, bodies);
    const std::string head(shader_head(kGlsl));
    return {head + texts[0], head + texts[1]};
}

std::string compute_source(Stage stage, const EffectSet& effects, Output output, const Method& method,
                           std::string_view metric, const BodyText& bodies, bool patches) {
    std::vector<std::string> defines = stage_defines(stage, effects, output, method);
    defines.emplace_back("BY_COMPUTE");
    if (lists_tiles(stage)) defines.emplace_back("DRAWS_TILES");
    if (patches && draws_picture(stage) && effects.contains(Effect::kRefine)) defines.emplace_back("COMPUTES_PATCHES");
    const char* root = stage == Stage::kRayData   ? "stage/raydata.comp"
                       : stage == Stage::kRayList ? "stage/ray_list.comp"
                       : stage == Stage::kRays    ? "stage/rays.comp"
                       : stage == Stage::kLattice ? "stage/lattice.comp"
                       : finds_tiles(stage)       ? "stage/tiles.comp"
                                                  : "stage/trace.comp";
    return texts_of({root}, stage, std::move(defines), effects, method, metric, bodies).front();
}

std::string tile_list_source(Stage stage) {
    std::vector<std::string> defines = stage_defines(stage, {}, Output::kLinear, {});
    if (draws_lattice(stage)) defines.emplace_back("DRAWS_LATTICE");
    return texts_of({"stage/tile_list.comp"}, stage, std::move(defines), {}, {}, "schwarzschild", {}).front();
}

}  // namespace nullscope
