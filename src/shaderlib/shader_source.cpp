#include "shaderlib/shader_source.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "shaderlib/embedded.h"

namespace nullscope {
namespace {

constexpr std::string_view kVersion = "#version 330 core\n";

// Drops whole-line comments and blank lines: the driver's text is what is compiled, nothing else.
std::string stripped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        const std::size_t first = line.find_first_not_of(' ');
        if (first != std::string_view::npos && line.substr(first, 2) != "//") out.append(line).append("\n");
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return out;
}

// Keeps or drops the branches of #ifdef / #ifndef / #else / #endif for the macros that are ours (EFFECT_, NEEDS_, DISPLAY_,
// __cplusplus), so that nothing of an effect that is off is left in the text.
std::string resolved(const std::string& text, const std::vector<std::string>& defines) {
    struct Level { bool ours, keep; };
    std::vector<Level> levels;
    const auto is_ours = [](const std::string& name) {
        return name.starts_with("EFFECT_") || name.starts_with("NEEDS_") || name.starts_with("DISPLAY_") || name.starts_with("TABLE_") ||
               name.starts_with("STEP_ORDER_") || name == "__cplusplus";
    };
    const auto kept = [&] {
        for (const Level& level : levels)
            if (level.ours && !level.keep) return false;
        return true;
    };
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        const bool ifdef = line.starts_with("#ifdef "), ifndef = line.starts_with("#ifndef ");
        bool drop = false;
        if (ifdef || ifndef) {
            const std::string name = line.substr(ifdef ? 7 : 8);
            bool defined = false;
            for (const std::string& d : defines) defined = defined || d == name;
            levels.push_back({is_ours(name), defined == ifdef});
            drop = levels.back().ours;
        } else if (line.starts_with("#else") && !levels.empty()) {
            levels.back().keep = !levels.back().keep;
            drop = levels.back().ours;
        } else if (line.starts_with("#endif") && !levels.empty()) {
            drop = levels.back().ours;
            levels.pop_back();
        }
        if (!drop && kept()) out += line + "\n";
    }
    return out;
}

std::vector<std::string> method_files(const Method& method, std::string_view metric) {
    switch (method.kind) {
        case MethodKind::kStrip: return {method.cubic ? "method/strip_cubic.glsl" : "method/strip.glsl"};
        case MethodKind::kTable: return {"core/table_mapping.glsl", "method/by_angle.glsl", "method/table.glsl"};
        case MethodKind::kClosedForm: return {"method/by_angle.glsl", "method/closed_form.glsl"};
        case MethodKind::kIntegrate:
            return {"method/by_angle.glsl", fmt::format("spacetime/{}.glsl", metric), "method/integrate.glsl"};
    }
    return {};
}

std::string method_constants(const Method& method) {
    if (method.kind == MethodKind::kTable) return fmt::format("#define TABLE_SIZE {}\n", method.size);
    if (method.kind == MethodKind::kIntegrate)
        return fmt::format("#define STEP_ANGLE {:.9f}\n#define STEP_MOST {}\n", method.step, method.most_steps);
    return "";
}

std::vector<std::string> method_defines(const Method& method) {
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

std::vector<std::string> files_of(Stage stage, const EffectSet& effects, bool ends, const Method& method, std::string_view metric) {
    std::vector<std::string> files = {"core/trig.glsl"};
    const bool lensing = effects.contains(Effect::kLensing), disc = effects.contains(Effect::kDisc);
    const bool picture = stage == Stage::kPicture;
    if (effects.contains(Effect::kAberration)) files.emplace_back("core/aberration.glsl");
    if (lensing) {
        files.emplace_back("core/strip.glsl");
        files.emplace_back("core/sweep.glsl");
        for (std::string& file : method_files(method, metric)) files.push_back(std::move(file));
    }
    if (lensing && disc) files.emplace_back("core/orbit.glsl");
    if (disc) files.emplace_back("core/plane.glsl");
    if (!lensing && !ends) files.erase(files.begin());   // nothing inverse to compute
    files.emplace_back("core/trace.glsl");
    if (disc) files.emplace_back("object/disc.glsl");
    if (picture && (disc || effects.contains(Effect::kSky))) files.emplace_back("effect/footprint.glsl");
    if (picture && effects.contains(Effect::kThermalDisc))
        for (const char* file : {"object/disc_flow.glsl", "effect/black_body.glsl", "effect/thermal.glsl"}) files.emplace_back(file);
    if (picture && disc) files.emplace_back("object/disc_colour.glsl");
    if (picture && effects.contains(Effect::kSky)) files.emplace_back("object/celestial_sphere.glsl");
    if (!picture) files.emplace_back("core/raydata.glsl");
    return files;
}

constexpr const char* kThermalDeclarations =
    "uniform highp sampler2D disc_flow_texture;\nuniform highp sampler2D black_body_texture;\n"
    "vec4 disc_flow_fetch(int i) { return texelFetch(disc_flow_texture, ivec2(i, 0), 0); }\n"
    "vec4 black_body_fetch(int i) { return texelFetch(black_body_texture, ivec2(i, 0), 0); }\n";

std::string declarations(Stage stage, const EffectSet& effects, bool ends, const Method& method) {
    std::string text = std::string(shader_file("shared/frame_block.glsl")) +
                       "layout(std140) uniform FrameBlock { FrameData frame; };\n";
    const bool disc = effects.contains(Effect::kDisc);
    if (effects.contains(Effect::kLensing)) {
        const bool strip = method.kind == MethodKind::kStrip;
        if (strip && !method.cubic)
            text += "uniform highp sampler2D strip_texture;\n"
                    "vec4 strip_fetch(int x, int y) { return texelFetch(strip_texture, ivec2(x, y), 0); }\n";
        if (ends || (strip && method.cubic))
            text += "uniform highp sampler2D ends_texture;\n"
                    "vec4 ends_fetch(int x, int y) { return texelFetch(ends_texture, ivec2(x, y), 0); }\n";
        if (method.kind == MethodKind::kTable) text += "uniform highp sampler2D table_texture;\n";
        text += method_constants(method);
        if (disc)
            text += "uniform highp sampler2D orbit_texture;\n"
                    "vec4 orbit_fetch(int x, int y) { return texelFetch(orbit_texture, ivec2(x, y), 0); }\n";
    }
    if (stage == Stage::kPicture) {
        if (effects.contains(Effect::kSky)) text += "uniform samplerCube sky_texture;\n";
        if (effects.contains(Effect::kDiscImage)) text += "uniform sampler2D disc_texture;\n";
        if (effects.contains(Effect::kThermalDisc)) text += kThermalDeclarations;
    }
    return text;
}

}  // namespace

std::string_view shader_file(std::string_view path) {
    for (const EmbeddedShader& file : embedded_shaders())
        if (file.path == path) return file.text;
    std::fprintf(stderr, "shader_file: no shaders/%.*s in this build\n", static_cast<int>(path.size()), path.data());
    std::abort();
}

ShaderSource shader_source(Stage stage, const EffectSet& effects, Output output, const Method& method, std::string_view metric) {
    const std::string vertex = std::string(kVersion) + stripped(shader_file("stage/fullscreen.vert"));
    const std::string head = std::string(kVersion) + "precision highp float;\nprecision highp int;\n";
    if (stage == Stage::kBareFetch)
        return {vertex, head + stripped(std::string(shader_file("shared/frame_block.glsl")) +
                                        "layout(std140) uniform FrameBlock { FrameData frame; };\n" +
                                        std::string(shader_file("stage/bare_fetch.frag")))};
    std::vector<std::string> defines;
    for (const Effect effect : effects.list()) defines.emplace_back(effect_row(effect).define);
    const bool ends = stage == Stage::kRayData || effects.contains(Effect::kDisc);
    if (ends) defines.emplace_back("NEEDS_PHI_END");
    const bool display = stage == Stage::kPicture && output == Output::kDisplay;
    if (display) defines.emplace_back("DISPLAY_ENCODE");

    if (stage == Stage::kPicture) defines.emplace_back("NEEDS_FOOTPRINT");
    for (std::string& define : method_defines(method)) defines.push_back(std::move(define));

    std::string body = declarations(stage, effects, ends, method);
    for (const std::string& file : files_of(stage, effects, ends, method, metric)) body += shader_file(file);
    if (display) body += shader_file("effect/display.glsl");
    body += shader_file(stage == Stage::kPicture ? "stage/trace.frag" : "stage/raydata.frag");
    return {vertex, head + stripped(resolved(body, defines))};
}

}  // namespace nullscope
