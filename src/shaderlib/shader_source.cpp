#include "shaderlib/shader_source.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "shaderlib/embedded.h"
#include "shaderlib/preprocess.h"

namespace nullscope {
namespace {

constexpr const char* kHead = "#version 330 core\nprecision highp float;\nprecision highp int;\n";

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
    switch (method.lookup) {
        case Lookup::kHardware: return {"TABLE_HARDWARE"};
        case Lookup::kBilinear: return {"TABLE_BILINEAR"};
        case Lookup::kCubic: return {"TABLE_CUBIC"};
        case Lookup::kHermite: return {"TABLE_HERMITE"};
    }
    return {};
}

std::vector<std::string> defines_of(const EffectSet& effects) {
    std::vector<std::string> defines;
    for (const Effect effect : effects.list()) {
        defines.emplace_back(effect_row(effect).define);
        defines.push_back("BLOCK_" + defines.back().substr(std::string_view("EFFECT_").size()));
    }
    if (has_solids(effects)) defines.emplace_back("NEEDS_PLACE");
    if (has_marched(effects)) defines.emplace_back("BLOCK_MARCH");
    const bool delay = effects.contains(Effect::kDelay),
               late = effects.contains(Effect::kDiscFlow) || effects.contains(Effect::kSpot);
    if (late) defines.emplace_back("NEEDS_LATE");
    if (effects.contains(Effect::kThermalDisc) || (effects.contains(Effect::kDisc) && delay))
        defines.emplace_back("NEEDS_ZETA_SLOPE");
    if (moves(effects) || (delay && effects.contains(Effect::kSurface))) defines.emplace_back("NEEDS_PLACE_LATE");
    const bool sky = effects.contains(Effect::kSky), far_sky = effects.contains(Effect::kFarSky);
    if (far_sky && !sky) defines.emplace_back("BLOCK_SKY");
    if (sky && (far_sky || effects.contains(Effect::kBounce))) defines.emplace_back("NEEDS_SKY_OF_EVERY_RAY");
    return defines;
}

std::vector<std::string> members_of(const std::string& block) {
    std::vector<std::string> members;
    constexpr std::string_view kType = "    vec4 ";
    for (std::size_t at = block.find(kType); at != std::string::npos; at = block.find(kType, at + 1)) {
        const std::size_t name = at + kType.size();
        members.push_back(block.substr(name, block.find(';', name) - name));
    }
    return members;
}

struct StageFiles {
    const char *vertex, *fragment;
};

StageFiles files_of(Stage stage) {
    constexpr const char* kFullscreen = "stage/fullscreen.vert";
    switch (stage) {
        case Stage::kPicture: return {kFullscreen, "stage/trace.frag"};
        case Stage::kStars: return {"stage/star.vert", "stage/star.frag"};
        case Stage::kBloomDown: return {kFullscreen, "stage/bloom_down.frag"};
        case Stage::kBloomUp: return {kFullscreen, "stage/bloom_up.frag"};
        case Stage::kMeter: return {kFullscreen, "stage/meter.frag"};
        case Stage::kDevelop: return {kFullscreen, "stage/develop.frag"};
        case Stage::kRayData: return {kFullscreen, "stage/raydata.frag"};
        case Stage::kBareFetch: break;
    }
    return {kFullscreen, "stage/bare_fetch.frag"};
}

}  // namespace

bool has_shader(std::string_view folder, std::string_view metric) {
    const std::string path = fmt::format("{}/{}.glsl", folder, metric);
    for (const EmbeddedShader& file : embedded_shaders())
        if (file.path == path) return true;
    return false;
}

std::string include_line(std::string_view path) { return fmt::format("#include \"{}\"\n", path); }

std::string_view shader_file(std::string_view path) {
    for (const EmbeddedShader& file : embedded_shaders())
        if (file.path == path) return file.text;
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

ShaderSource shader_source(Stage stage, const EffectSet& effects, Output output, const Method& method,
                           std::string_view metric, const BodyText& bodies) {
    std::vector<std::string> defines;
    if (stage != Stage::kBareFetch) defines = defines_of(effects);
    if (stage == Stage::kRayData || meets_objects(effects) || effects.contains(Effect::kDelay))
        defines.emplace_back("NEEDS_PHI_END");
    if (stage == Stage::kRayData && effects.contains(Effect::kDelay)) defines.emplace_back("NEEDS_PLACE_LATE");
    if (stage == Stage::kPicture) defines.emplace_back("NEEDS_FOOTPRINT");
    if (stage == Stage::kPicture && output == Output::kDisplay) defines.emplace_back("DISPLAY_ENCODE");
    for (std::string& define : method_defines(method)) defines.push_back(std::move(define));
    const std::map<std::string_view, std::string> generated = {
        {"generated/method", method_text(method, metric)},
        {"generated/metric", include_line(fmt::format("spacetime/{}.glsl", metric))},
        {"generated/constants", fmt::format("#define METER_KEY {}\n", kMeterKey)},
        {"generated/surface", bodies.shape},
        {"generated/bodies_march", bodies.march},
        {"generated/bodies_hit", bodies.hit},
        {"generated/bodies_light", bodies.light},
        {"generated/coats", bodies.coats}};
    const char* path = light_path_kind(effects) == LightPathKind::kMino ? "mino" : "planar";
    std::map<std::string, std::string, std::less<>> chosen;  // "path/trace": the file of the kind of path
    const ShaderReader read = [&](std::string_view name) -> std::string_view {
        if (const auto part = generated.find(name); part != generated.end()) return part->second;
        if (!name.starts_with(kPathPrefix)) return shader_file(name);
        return chosen[std::string(name)] = path_line(path, name);
    };
    const StageFiles files = files_of(stage);
    return {kHead + resolved_text(files.vertex, defines, read), kHead + resolved_text(files.fragment, defines, read)};
}

}  // namespace nullscope
