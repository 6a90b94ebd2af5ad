#include "shaderlib/shader_source.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "shaderlib/embedded.h"
#include "shaderlib/preprocess.h"

namespace nullscope {
namespace {

constexpr std::string_view kVersion = "#version 330 core\n";

std::vector<std::string> method_files(const Method& method, std::string_view metric) {
    switch (method.kind) {
        case MethodKind::kStrip: return {method.cubic ? "method/strip_cubic.glsl" : "method/strip.glsl"};
        case MethodKind::kTable: return {"core/table_mapping.glsl", "method/by_angle.glsl", "method/table.glsl"};
        case MethodKind::kClosedForm:
            return {"method/by_angle.glsl", fmt::format("method/closed_form/{}.glsl", metric)};
        case MethodKind::kIntegrate:
            return {"method/by_angle.glsl", fmt::format("spacetime/{}.glsl", metric), "method/integrate.glsl"};
        case MethodKind::kMino: return {};
        case MethodKind::kKerrSchild: return {"method/kerr_schild.glsl"};
    }
    return {};
}

std::string method_constants(const Method& method) {
    if (method.kind == MethodKind::kTable) return fmt::format("#define TABLE_SIZE {}\n", method.size);
    if (method.kind == MethodKind::kIntegrate)
        return fmt::format("#define STEP_ANGLE {:.9f}\n#define STEP_MOST {}\n", method.step, method.most_steps);
    if (method.kind == MethodKind::kMino)
        return fmt::format("#define SPIN_STEP {:.9f}\n#define SPIN_MOST_STEPS {}\n", method.step, method.most_steps);
    if (method.kind == MethodKind::kKerrSchild) return fmt::format("#define KERR_SCHILD_STEP {:.9f}\n", method.step);
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

using Files = std::vector<std::string>;

// What a ray's way is made of.
Files way_files(Stage stage, const EffectSet& effects, bool ends, const Method& method, std::string_view metric) {
    const bool lensing = effects.contains(Effect::kLensing), disc = effects.contains(Effect::kDisc),
               spin = effects.contains(Effect::kSpin);
    Files files;
    if (lensing || ends || (stage == Stage::kPicture && effects.contains(Effect::kSkyPattern)))
        files.emplace_back("core/trig.glsl");  // else nothing inverse to compute
    if (effects.contains(Effect::kAberration)) files.emplace_back("core/aberration.glsl");
    if (lensing) {
        files.emplace_back("core/strip.glsl");
        files.emplace_back("core/sweep.glsl");
        for (std::string& file : method_files(method, metric)) files.push_back(std::move(file));
    }
    if (lensing && (meets_objects(effects) || effects.contains(Effect::kDelay))) files.emplace_back("core/orbit.glsl");
    if (disc && !spin) files.emplace_back("core/plane.glsl");
    if (spin)
        for (const char* file : {"core/kerr.glsl", "core/spin_leg.glsl", "core/spin_ray.glsl"})
            files.emplace_back(file);
    if (spin && method.kind == MethodKind::kMino && method.order == 4) files.emplace_back("method/mino_4.glsl");
    return files;
}

Files trace_files(const EffectSet& effects, const Method& method) {
    if (!effects.contains(Effect::kSpin))
        return effects.contains(Effect::kDelay) ? Files{"core/trace.glsl", "core/delay.glsl"}
                                                : Files{"core/trace.glsl"};
    return method.kind == MethodKind::kKerrSchild ? Files{"core/spin_trace.glsl", "method/kerr_schild.glsl"}
                                                  : Files{"core/spin_trace.glsl"};
}

// What is no solid body.
Files scene_files(Stage stage, const EffectSet& effects) {
    const bool disc = effects.contains(Effect::kDisc), sky = effects.contains(Effect::kSky),
               far_sky = effects.contains(Effect::kFarSky);
    Files files;
    if (disc) files.emplace_back(effects.contains(Effect::kSpin) ? "object/spin_disc.glsl" : "object/disc.glsl");
    if (stage != Stage::kPicture) return files;
    if (disc || sky || far_sky || effects.contains(Effect::kBodyImage)) files.emplace_back("effect/footprint.glsl");
    if (shades_heat(effects)) files.emplace_back("effect/black_body.glsl");
    if (effects.contains(Effect::kThermalDisc))
        for (const char* file : {"object/disc_matter.glsl", "effect/thermal.glsl"}) files.emplace_back(file);
    if (disc) files.emplace_back("object/disc_colour.glsl");
    if (effects.contains(Effect::kDiscFlow)) files.emplace_back("object/disc_flow.glsl");
    if (effects.contains(Effect::kSpot)) files.emplace_back("object/spot.glsl");
    if (disc && effects.contains(Effect::kLensing)) files.emplace_back("object/disc_thin.glsl");
    if (sky || far_sky) files.emplace_back("object/celestial_sphere.glsl");
    if (far_sky && !sky) files.emplace_back("object/other_side.glsl");
    if (effects.contains(Effect::kStar)) files.emplace_back("object/star.glsl");
    return files;
}

std::string text_of(const Files& files) {
    std::string text;
    for (const std::string& file : files) text += shader_file(file);
    return text;
}

bool has_coats(const EffectSet& effects) {
    return effects.contains(Effect::kDiscPattern) || effects.contains(Effect::kSkyPattern);
}

// What formulas are made of.
std::string formula_text(Stage stage, const EffectSet& effects) {
    if (!has_solids(effects) && !(stage == Stage::kPicture && has_coats(effects))) return "";
    const bool formulas =
        effects.contains(Effect::kFormula) || effects.contains(Effect::kNoise) || effects.contains(Effect::kSurface);
    return formulas ? std::string(shader_file("effect/expression.glsl")) : "";
}

// What looks are made of, and what the disc and the sky are painted with.
std::string look_text(Stage stage, const EffectSet& effects, const BodyText& bodies) {
    if (stage != Stage::kPicture || (!has_solids(effects) && !has_coats(effects))) return "";
    std::string text(shader_file("effect/body_mapping.glsl"));
    if (effects.contains(Effect::kPattern)) text += shader_file("effect/pattern.glsl");
    if (effects.contains(Effect::kNoise)) text += shader_file("effect/grain.glsl");
    text += bodies.coats;
    if (effects.contains(Effect::kSkyPattern)) text += shader_file("object/dome.glsl");
    return text;
}

// Solid bodies, and how they are met: about a spinning hole by the tracer, else by what it has found.
std::string solid_text(const EffectSet& effects, const BodyText& bodies) {
    if (!has_solids(effects)) return "";
    const bool spin = effects.contains(Effect::kSpin), pulse = effects.contains(Effect::kPulse);
    std::string text = text_of({spin ? "object/spin_place.glsl" : "object/place.glsl", "object/solid_hit.glsl"});
    if (effects.contains(Effect::kSphere))
        text += shader_file(pulse ? "object/pulse.glsl" : spin ? "object/still_sphere.glsl" : "object/sphere.glsl");
    if (effects.contains(Effect::kCylinder)) text += shader_file("object/cylinder.glsl");
    if (effects.contains(Effect::kBall)) text += shader_file("object/ball.glsl");
    if (effects.contains(Effect::kSurface)) text += bodies.shape;
    text += bodies.march;
    if (has_marched(effects))
        text += spin ? text_of({"object/spin_way.glsl", "object/march.glsl", "object/spin_march.glsl"})
                     : text_of({"object/plane_way.glsl", "object/march.glsl", "object/plane_march.glsl"});
    return text + bodies.hit;
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

constexpr const char* kBlockDeclaration = "layout(std140) uniform FrameBlock { FrameData frame; };\n";
constexpr const char* kDiscMatterDeclarations =
    "uniform highp sampler2D disc_matter_texture;\n"
    "vec4 disc_matter_fetch(int i) { return texelFetch(disc_matter_texture, ivec2(i, 0), 0); }\n";
constexpr const char* kBlackBodyDeclarations =
    "uniform highp sampler2D black_body_texture;\n"
    "vec4 black_body_fetch(int i) { return texelFetch(black_body_texture, ivec2(i, 0), 0); }\n";

std::string declarations(Stage stage, const EffectSet& effects, bool ends, const Method& method) {
    std::string text = std::string(shader_file("shared/frame_block.glsl")) + kBlockDeclaration;
    const bool disc = effects.contains(Effect::kDisc);
    if (effects.contains(Effect::kLensing)) {
        const bool strip = method.kind == MethodKind::kStrip;
        if (strip && !method.cubic)
            text +=
                "uniform highp sampler2D strip_texture;\n"
                "vec4 strip_fetch(int x, int y) { return texelFetch(strip_texture, ivec2(x, y), 0); }\n";
        if (ends || (strip && method.cubic))
            text +=
                "uniform highp sampler2D ends_texture;\n"
                "vec4 ends_fetch(int x, int y) { return texelFetch(ends_texture, ivec2(x, y), 0); }\n";
        if (method.kind == MethodKind::kTable) text += "uniform highp sampler2D table_texture;\n";
        text += method_constants(method);
        const bool delay = effects.contains(Effect::kDelay);
        // With delays the map's texels lie beside theirs (table/orbit_map.h).
        if (disc || has_solids(effects) || delay)
            text += fmt::format(
                "uniform highp sampler2D orbit_texture;\n"
                "vec4 orbit_fetch(int x, int y) {{ return texelFetch(orbit_texture, ivec2({}x, y), 0); }}\n",
                delay ? "2 * " : "");
        if (delay)
            text += "vec4 delay_fetch(int x, int y) { return texelFetch(orbit_texture, ivec2(2 * x + 1, y), 0); }\n";
    }
    if (effects.contains(Effect::kBallPath))
        text +=
            "uniform highp sampler2D ball_path_texture;\n"
            "vec4 ball_path_fetch(int x, int y) { return texelFetch(ball_path_texture, ivec2(x, y), 0); }\n";
    if (counts_steps(method)) text += method_constants(method);
    if (stage == Stage::kPicture) {
        const bool sky = effects.contains(Effect::kSky), far_sky = effects.contains(Effect::kFarSky);
        if (sky)
            text += far_sky ? "uniform highp sampler2DArray sky_texture;\n" : "uniform samplerCube sky_texture;\n";
        else if (far_sky)
            text += "uniform samplerCube other_side_texture;\n";
        if (effects.contains(Effect::kDiscImage)) text += "uniform sampler2D disc_texture;\n";
        if (effects.contains(Effect::kThermalDisc)) text += kDiscMatterDeclarations;
        if (shades_heat(effects)) text += kBlackBodyDeclarations;
    }
    return text;
}

const std::string kHead = std::string(kVersion) + "precision highp float;\nprecision highp int;\n";

// Of a program whose picture calls for nothing of the scene but the uniform block.
std::string with_block(const std::string& body, const std::vector<std::string>& defines) {
    return kHead + stripped(resolved_branches(
                       std::string(shader_file("shared/frame_block.glsl")) + kBlockDeclaration + body, defines));
}

ShaderSource star_source(const EffectSet& effects) {
    const std::vector<std::string> defines = defines_of(effects);
    std::string body = kBlackBodyDeclarations;
    if (!effects.contains(Effect::kSpin)) body += "uniform int image_order;\n";
    if (effects.contains(Effect::kLensing)) body += "uniform highp sampler2D star_lens_texture;\n";
    const bool spin = effects.contains(Effect::kSpin);  // the host has found the images
    if (effects.contains(Effect::kAberration) && !spin) body += shader_file("core/aberration.glsl");
    body += shader_file("effect/black_body.glsl");
    if (!spin) body += shader_file("object/star_image.glsl");
    body += shader_file("stage/star.vert");
    return {with_block(body, defines), with_block(std::string(shader_file("stage/star.frag")), defines)};
}

constexpr const char* kBloomDeclaration = "uniform highp sampler2D bloom_texture;\n";

std::string develop_source(const EffectSet& effects) {
    std::string body = "uniform highp sampler2D picture_texture;\n";
    if (effects.contains(Effect::kBloom)) body += kBloomDeclaration;
    if (effects.contains(Effect::kAutoExposure))
        body += fmt::format("uniform highp sampler2D meter_texture;\n#define METER_KEY {}\n", kMeterKey);
    body += shader_file("effect/display.glsl");
    body += shader_file("stage/develop.frag");
    return with_block(body, defines_of(effects));
}

}  // namespace

bool has_shader(std::string_view folder, std::string_view metric) {
    const std::string path = fmt::format("{}/{}.glsl", folder, metric);
    for (const EmbeddedShader& file : embedded_shaders())
        if (file.path == path) return true;
    return false;
}

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
    const std::string vertex = std::string(kVersion) + stripped(shader_file("stage/fullscreen.vert"));
    if (stage == Stage::kBareFetch) return {vertex, with_block(std::string(shader_file("stage/bare_fetch.frag")), {})};
    if (stage == Stage::kStars) return star_source(effects);
    if (stage == Stage::kDevelop) return {vertex, develop_source(effects)};
    const std::string source = "uniform highp sampler2D source_texture;\n";
    if (stage == Stage::kBloomDown)
        return {vertex, kHead + stripped(source + std::string(shader_file("stage/bloom_down.frag")))};
    if (stage == Stage::kBloomUp)
        return {vertex, kHead + stripped(source + kBloomDeclaration + std::string(shader_file("stage/bloom_up.frag")))};
    if (stage == Stage::kMeter)
        return {vertex, kHead + stripped(source + std::string(shader_file("stage/meter.frag")))};
    std::vector<std::string> defines = defines_of(effects);
    const bool ends = stage == Stage::kRayData || effects.contains(Effect::kDisc) || has_solids(effects) ||
                      effects.contains(Effect::kDelay);
    if (ends) defines.emplace_back("NEEDS_PHI_END");
    if (stage == Stage::kRayData && effects.contains(Effect::kDelay)) defines.emplace_back("NEEDS_PLACE_LATE");
    const bool display = stage == Stage::kPicture && output == Output::kDisplay;
    if (display) defines.emplace_back("DISPLAY_ENCODE");

    if (stage == Stage::kPicture) defines.emplace_back("NEEDS_FOOTPRINT");
    if (bodies.shape.find("vec3 at, float t") != std::string::npos) defines.emplace_back("SURFACE_MOVES");
    for (std::string& define : method_defines(method)) defines.push_back(std::move(define));

    std::string body = declarations(stage, effects, ends, method);
    const bool spin = effects.contains(Effect::kSpin);
    body += text_of(way_files(stage, effects, ends, method, metric)) + formula_text(stage, effects);
    if (spin) body += solid_text(effects, bodies);
    body += text_of(trace_files(effects, method)) + text_of(scene_files(stage, effects)) +
            look_text(stage, effects, bodies);
    if (!spin) body += solid_text(effects, bodies);
    if (has_solids(effects) && stage == Stage::kPicture)
        body += std::string(shader_file("object/solid.glsl")) + bodies.light;
    if (stage == Stage::kRayData) body += shader_file("core/raydata.glsl");
    if (display) body += shader_file("effect/display.glsl");
    body += shader_file(stage == Stage::kPicture ? "stage/trace.frag" : "stage/raydata.frag");
    return {vertex, kHead + stripped(resolved_branches(body, defines))};
}

}  // namespace nullscope
