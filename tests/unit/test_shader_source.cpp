// The text that goes to the driver: nothing of an effect that is off is in it.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "plan/effects.h"
#include "plan/medium_model.h"
#include "scene/bodies.h"
#include "scene/projection.h"
#include "scene/projection_table.h"
#include "shaderlib/embedded.h"
#include "shaderlib/flat_frame.h"
#include "shaderlib/preprocess.h"
#include "shaderlib/shader_source.h"
#include "support/costly.h"
#include "support/depth.h"

using namespace nullscope;
using namespace std::string_literals;

namespace {

// Scenes over every combination of what they can contain; the effects follow.
std::vector<Scene> all_scenes() {
    std::vector<Scene> scenes;
    constexpr TextureKind kKinds[] = {TextureKind::kPlain,   TextureKind::kChecker, TextureKind::kNoise,
                                      TextureKind::kFormula, TextureKind::kImage,   TextureKind::kGas};
    for (unsigned bits = 0; bits < 1024; bits += test::by_depth(3u, 1u, 1u))
        for (const TextureKind kind : kKinds) {
            const auto has = [&](unsigned bit) { return (bits >> bit & 1u) != 0; };
            Scene scene;
            scene.spacetime.metric = has(0) ? "schwarzschild" : "minkowski";
            if (has(0) && has(4)) scene.spacetime = {"reissner-nordstrom", {{"charge", 0.8}}};
            if (has(1)) scene.camera.velocity = {0, 0, 0.5};
            if (has(2)) scene.disc.emplace();
            if (has(2) && has(3)) scene.disc->opacity = 0.5;
            if (has(2) && has(9)) {
                scene.disc->emission = DiscEmission::kThermal;
                scene.light.shift = !has(5);  // any bits: switches off in some scenes
                scene.light.beaming = !has(6);
                scene.light.bolometric = has(7);
                scene.disc->effects.limb_darkening = has(4);
            }
            if (has(1) && has(9)) scene.sky.temperature_K = 6000.0;
            scene.sky.kind = has(4) ? SkyKind::kStars : SkyKind::kBlack;
            if (has(3) && has(6)) scene.picture.tone = has(1) ? ToneCurve::kFilm : ToneCurve::kNeutral;
            scene.picture.dither = has(9) && !has(2);
            scene.picture.bloom = has(8) && has(0) ? 0.1 : 0.0;
            if (has(2) && has(9) && has(8)) scene.sky.kind = SkyKind::kPoints;
            if (has(1) && has(3) && has(7))
                scene.sky.kind = static_cast<SkyKind>(static_cast<int>(SkyKind::kPlain) + static_cast<int>(bits % 6));
            if (has(2) && has(1) && has(6)) scene.disc->material.texture = kind, scene.disc->material.formula = "v"s;
            scene.sky.material.formula = "u"s;
            const TextureKind solid = kind == TextureKind::kGas ? TextureKind::kPlain : kind;
            if (has(5)) add_body<SphereSpec>(scene).material.texture = solid;
            if (has(6)) add_body<CylinderSpec>(scene).material.texture = solid;
            if (has(7)) add_body<BallSpec>(scene).material.texture = solid;
            if (has(8)) add_body<SurfaceSpec>(scene).material.texture = solid;
            for (Material* material :
                 {first_body<SphereSpec>(scene) ? &first_body<SphereSpec>(scene)->material : nullptr,
                  first_body<BallSpec>(scene) ? &first_body<BallSpec>(scene)->material : nullptr})
                if (material != nullptr && kind == TextureKind::kFormula) material->formula = "sin(u)";
            if (has(2) && has(4) && !has(9)) scene.disc->flow = DiscFlowKind::kKepler;
            if (has(2) && has(7) && has(9)) scene.spots.emplace_back();
            if (has(3) && has(5) && !scene.camera.zoom)
                scene.medium.emplace().kind = static_cast<MediumKind>(bits % kMediumKinds);
            if (scene.medium) scene.medium->emission = static_cast<MediumEmission>(bits / 4 % 3);
            if (has(7) && has(4) && has(3)) first_shape<BallSpec>(scene)->motion = BallMotion::kOrbit;
            if (has(5) && has(8) && has(1)) first_shape<SphereSpec>(scene)->amplitude = 0.1;
            if (has(8) && has(6)) first_shape<SurfaceSpec>(scene)->shape = "x^2 + y^2 + z^2 - 9 - sin(t)";
            scene.light.delay = !(has(0) && has(7));
            scene.picture.samples = has(2) && has(6) ? 2 : 1;
            scene.picture.refine = !(has(0) && has(9));
            if (has(3) && has(5) && !has(1)) scene.camera.zoom.emplace();
            if (has(2) && has(5) && !has(3)) scene.camera.warp = "mesh.data";
            if (has(0) && !scene.camera.zoom)
                scene.camera.projection = static_cast<Projection>(bits / 2 % kProjections);
            scenes.push_back(scene);
        }
    return scenes;
}

// Identifiers that belong to one effect.
struct Mark {
    Effect effect;
    std::vector<std::string> words;
};
const std::vector<Mark> kMarks = {
    {Effect::kLensing,
     {"strip_locate", "strip_texture", "StripRay", "sweep_to_sky", "vec4 strip;", "vec4 orbit;", "vec4 series;"}},
    {Effect::kSpin, {"spin_step", "spin_ray", "SpinState", "vec4 spin_hole;", "vec4 spin_place;"}},
    {Effect::kSpinFall, {"ingoing", "INGOING_DELTA"}},
    {Effect::kAberration, {"aberrate", "Aberration", "vec4 boost;", "vec4 boost_colour;"}},
    {Effect::kZoom, {"ring_part", "vec4 polar_length;", "vec4 polar_weight;", "vec4 ring;"}},
    {Effect::kSpinRing, {"ring_settling", "RingBarrier", "vec4 ring_peak;"}},
    {Effect::kSpinNear, {"near_above", "NearHorizon", "vec4 spin_near;"}},
    {Effect::kWarp, {"warp_place", "warp_texture", "vec4 warp;", "pixel_share"}},
    {Effect::kDisc, {"disc_cross", "DiscCrossing", "plane_meet", "disc_normal", "disc_map", "disc_surface"}},
    {Effect::kDiscImage, {"disc_texture", "disc_filtered"}},
    {Effect::kDiscPattern, {"disc_material_pattern", "vec4 disc_material_map;"}},
    {Effect::kTranslucentDisc, {"fade"}},
    {Effect::kThermalDisc, {"thermal_light", "disc_matter_texture", "DiscMatter", "vec4 disc_heat;"}},
    {Effect::kShift, {"colour_shift"}},
    {Effect::kBeaming, {"beaming"}},
    {Effect::kBolometric, {"all_wavelengths"}},
    {Effect::kPointStars, {"vec4 point_stars;", "vec4 point_spread;"}},
    {Effect::kSphere, {"sphere_size", "sphere_normal"}},
    {Effect::kCylinder, {"cylinder_value", "cylinder_size", "cylinder_light"}},
    {Effect::kBall, {"ball_value", "ball_size", "ball_light"}},
    {Effect::kSurface, {"surface_inside", "surface_size", "surface_light"}},
    {Effect::kPattern, {"pattern_checker", "pattern_wave"}},
    {Effect::kNoise, {"grain_noise"}},
    {Effect::kFormula, {"_blend("}},
    {Effect::kBodyImage, {"_image(", "body_image_0"}},
    {Effect::kGlow, {"glow_light(", "rest_g(", "solid_g("}},
    {Effect::kSky, {"celestial_sphere(", "sky_texture", "vec4 sky;"}},
    {Effect::kSkyShift, {"sky_shift", "vec4 sky_light;"}},
    {Effect::kSkyPattern, {"sky_pattern_light", "sky_pattern", "vec4 sky_pattern_x;"}},
    {Effect::kInner, {"frame.strip.w"}},
    {Effect::kBounce, {"by_centre"}},
    {Effect::kFarSky, {"other_side"}},
    {Effect::kBloom, {"vec4 bloom;"}},
    {Effect::kAutoExposure, {}},  // not in the picture's shader: see tests/cli/test_shader_text.py
    {Effect::kToneFilm, {"tone_film"}},
    {Effect::kToneNeutral, {"tone_neutral"}},
    {Effect::kDither, {"dither_noise"}},
    {Effect::kSamples, {}},  // what it shares with kRefine is looked for below
    {Effect::kRefine, {"edge_shown"}},
    {Effect::kNarrowDisc, {"narrow_disc"}},
    {Effect::kStar, {"star_surface", "star_square"}},
    {Effect::kSides, {"value_by_side", "vec4 throat;", "place.side"}},
    {Effect::kDelay, {"light_time("}},
    {Effect::kLightTimes, {"vec4 delay;"}},
    {Effect::kDiscFlow, {"disc_orbit(", "vec4 disc_winding;", "vec4 disc_copy;"}},
    {Effect::kRingRates, {"vec2 disc_rate_terms(", "vec4 disc_rate_0;"}},
    {Effect::kSpot, {"spot_light(", "spot_orbit_light("}},
    {Effect::kBallPath, {"ball_path_fetch", "moving_ball_middle"}},
    {Effect::kPulse, {"pulse_room"}},
    {Effect::kInnerHorizon, {"inner_horizon_time("}},
    {Effect::kLimbDarkening, {"limb_darkening(", "disc_cosine(", "disc_light("}},
    {Effect::kPolarisation, {"vec4 polarisation;"}},
    {Effect::kPolariser, {"disc_polarised(", "vec4 polariser;"}},
    {Effect::kMediumMotion, {"gas_moved("}},
    {medium_effect(MediumKind::kGrid), {"medium_texture", "grid_at(", "GRID_RING"}},
    {Effect::kMediumBlackBody, {}},  // gas has its shader too: see below
    {Effect::kMediumSynchrotron, {"log2_synchrotron("}},
    {Effect::kMediumElectrons, {"electron_texture", "electron_scale(", "ELECTRON_FIRST"}},
    {Effect::kMediumPolarisation, {"medium_stokes(", "stokes_rows(", "screen_direction("}},
    {Effect::kMediumBands, {"medium_bands(", "law_band", "vec4 medium_band_0;"}},
    {Effect::kDiscGas, {"disc_gas(", "disc_gas_gaps(", "vec4 disc_gas;"}},
    {Effect::kDiscLean, {"leaning_height(", "leaning_u_t(", "leaning_dip("}},
    {Effect::kDiscWarp, {"disc_warp_texture", "disc_ring(", "warped_step("}},
    {Effect::kSphereTurn, {"sphere_turn(", "SPHERE_TURN"}},
    {Effect::kCaps, {"cap_cover(", "with_caps(", "CAP_COUNT"}},
};

// Every line of a shader stands where #line says: in its file there is the same, but for a comment.
void check_places(const std::string& shader) {
    std::istringstream in(shader);
    std::map<int, std::string> files;
    std::string line, comment, all_of_file;
    std::vector<std::string> lines;  // of the file
    int known = 0, file = 0, number = 1;
    while (std::getline(in, line)) {
        if (line.starts_with("// ")) {
            comment = line.substr(3);
            ++number;
            continue;
        }
        if (std::sscanf(line.c_str(), "#line %d", &number) == 1) {
            file = number / 10000;
            number %= 10000;
            known += files.emplace(file, comment).second ? 1 : 0;
            CHECK(file <= known);
            lines.clear();
            if (files[file].starts_with("generated/")) continue;
            std::istringstream text{std::string(shader_file(files[file]))};
            for (std::string one; std::getline(text, one);) lines.push_back(one.substr(0, one.find("//")));
            continue;
        }
        const bool in_a_file = file > 0 && !files[file].starts_with("generated/");
        if (in_a_file && !line.empty()) {
            REQUIRE(static_cast<std::size_t>(number) <= lines.size());
            std::string there = lines[static_cast<std::size_t>(number - 1)];
            there.resize(there.find_last_not_of(' ') + 1);
            if (there != line) CHECK_MESSAGE(there == line, files[file], " line ", number);
        }
        ++number;
    }
    CHECK(known > 0);
}

std::string picture_of(const Scene& scene) {
    const EffectSet effects = effect_set(required_effects(scene));
    return shader_source(Stage::kPicture, effects, Output::kDisplay, {}, scene.spacetime.metric,
                         body_text(scene, effects))
        .fragment;
}

}  // namespace

TEST_CASE(
    "shader source: an effect that is off leaves nothing in the picture's shader, one that is on leaves its marks" *
    test::costly()) {
    for (const Scene& scene : all_scenes()) {
        const EffectSet set = effect_set(required_effects(scene));
        const std::string text = picture_of(scene);
        for (const Mark& mark : kMarks)
            for (const std::string& word : mark.words)
                CHECK_MESSAGE((text.find(word) != std::string::npos) == set.contains(mark.effect), word);
        const bool several = set.contains(Effect::kSamples) || set.contains(Effect::kRefine);
        CHECK((text.find("frame.sampling") != std::string::npos) == several);
        const bool glows = scene.medium && scene.medium->law() == MediumEmission::kBlackBody;
        CHECK((text.find("medium_glow(") != std::string::npos) == glows);
        for (const MediumModel* model : medium_models())
            CHECK((text.find(fmt::format("// {}\n", model->effect.part.file)) != std::string::npos) ==
                  set.contains(model->effect.effect));
        for (int i = 1; i < kProjections; ++i) {
            const auto projection = static_cast<Projection>(i);
            const bool seen = set.contains(projection_effect(projection));
            for (const std::string& word : {fmt::format("// projection/{}.glsl\n", projection_name(projection)),
                                            fmt::format(" {}_view(vec2 ", projection_name(projection))})
                CHECK((text.find(word) != std::string::npos) == seen);
        }
        CHECK((text.find("vec4 medium_form_0;") != std::string::npos) == scene.medium.has_value());
        for (const char* left : {"EFFECT_", "BLOCK", "BODY", "TEXTURE_", "MAPPING_", "__cplusplus", "#if", "#include"})
            CHECK(text.find(left) == std::string::npos);
        check_places(text);
    }
}

TEST_CASE("shader source: an include is resolved once, and in branches that are kept alone") {
    const std::map<std::string, std::string, std::less<>> files = {
        {"root",
         "// A comment.\n#include \"b\"\n#include \"a\"\n#ifdef OFF\n#include \"c\"\n#endif\nint root;   // x\n"},
        {"a", "int a;\n#define ON 1\n"},
        {"b", "#include \"a\"\n\n#ifdef ON\nint b;\n#else\nint no;\n#endif\n#ifndef ON\nint no;\n#endif\n"},
        {"c", "int c;\n"}};
    std::vector<std::string> read;
    const ShaderReader reader = [&](std::string_view name) -> std::string_view {
        read.emplace_back(name);
        return files.find(name)->second;
    };
    CHECK(resolved_text("root", {}, reader) ==
          "// a\n#line 10001\nint a;\n#define ON 1\n// b\n#line 20004\nint b;\n// root\n#line 30007\nint root;\n");
    CHECK(read == std::vector<std::string>{"root", "b", "a"});
    CHECK(resolved_text("c", {"__cplusplus"}, reader) == "#line 1 \"c\"\nint c;\n");
    CHECK(resolved_text("root", {"OFF"}, reader).find("int c;") != std::string::npos);
    CHECK(resolved_branches("#ifdef X\n#include \"x\"\n#else\n#include \"y\"  // y\n#endif\n", {}) ==
          "#include \"y\"  // y\n");
}

TEST_CASE("shader source: about a rotating hole nothing of plane orbits, without spin nothing of one that spins") {
    for (const double spin : {0.0, 0.9}) {
        Scene scene;
        scene.spacetime = {"kerr", {{"spin", spin}}};
        scene.disc.emplace();
        const std::string text = picture_of(scene);
        for (const char* word : {"spin_step", "SpinState", "KeptCrossings", "spin_hole"})
            CHECK((text.find(word) != std::string::npos) == (spin > 0));
        for (const char* word : {"strip_locate", "orbit_point", "plane_meet", "disc_reachable", "vec4 strip;"})
            CHECK((text.find(word) != std::string::npos) == (spin == 0));
        scene.sky.kind = SkyKind::kPoints;
        const std::string stars =
            shader_source(Stage::kStars, effect_set(required_effects(scene)), Output::kLinear, {}, "kerr", {}).vertex;
        for (const char* word : {"image_of_star", "star_lens_fetch", "image_order"})
            CHECK((stars.find(word) != std::string::npos) == (spin == 0));
    }
}

TEST_CASE("shader source: of a wormhole with bodies, on either side") {
    Scene scene;
    scene.spacetime.metric = "ellis";
    add<BallSpec>(scene);
    add_body<SurfaceSpec>(scene).far = true;
    const std::string text = picture_of(scene);
    for (const char* word : {"value_by_side", "vec4 throat;", "off = place.side <= 0.0", "off = place.side >= 0.0"})
        CHECK(text.find(word) != std::string::npos);
    scene.spacetime.metric = "schwarzschild";
    first_body<SurfaceSpec>(scene)->far = false;
    for (const char* word : {"by_side", "throat", "place.side"})
        CHECK(picture_of(scene).find(word) == std::string::npos);
}

TEST_CASE("shader source: the block's members are those of the effects that are on") {
    CHECK(block_members({}).size() == 12);
    CHECK(block_members({Effect::kSky}).size() == 13);
    EffectSet all;
    for (const EffectRow* row : effect_rows()) all.insert(row->effect);
    const auto members = block_members(all);
    for (std::size_t i = 0; i < members.size(); ++i) CHECK(members[i] == static_cast<int>(i));
    CHECK(members.size() == 89);
}

TEST_CASE("shader source: every row of the effects table has marks here") {
    for (const EffectRow* row : effect_rows()) {
        bool found = false;
        for (const Mark& mark : kMarks) found = found || mark.effect == row->effect;
        found = found || row->part.slot == Slot::kMedium;  // its file is looked for, and those of projections
        for (int i = 1; i < kProjections; ++i)
            found = found || row->effect == projection_effect(static_cast<Projection>(i));
        CHECK_MESSAGE(found, row->key);
    }
}

TEST_CASE("shader source: a list of rays has crossings where they are asked for, and nothing that is not a ray's") {
    for (const char* metric : {"schwarzschild", "kerr"})
        for (const bool crossings : {false, true}) {
            Scene scene;
            scene.spacetime.metric = metric;
            if (scene.spacetime.metric == "kerr") scene.spacetime.parameters["spin"] = 0.9;
            EffectSet set = effect_set(required_effects(scene));
            if (crossings) set.insert(Effect::kDisc);
            const std::string text = shader_source(Stage::kRayList, set, Output::kLinear, {}, metric).fragment;
            CHECK((text.find("listed_crossing(") != std::string::npos) == crossings);
            CHECK((text.find("disc_") != std::string::npos) == crossings);
            for (const char* word : {"sky_texture", "dFdx", "disc_texture", "fragment_pixel("})
                CHECK(text.find(word) == std::string::npos);
            // Only here a ray has numbers of its own.
            CHECK(text.find("FrameData every_ray;") != std::string::npos);
            CHECK(shader_source(Stage::kRayData, set, Output::kLinear, {}, metric).fragment.find("every_ray") ==
                  std::string::npos);
            check_places(text);
        }
}

TEST_CASE("shader source: linear output has no display encoding") {
    const EffectSet set = {Effect::kSky};
    CHECK(shader_source(Stage::kPicture, set, Output::kLinear).fragment.find("display_encode") == std::string::npos);
    CHECK(shader_source(Stage::kPicture, set, Output::kDisplay).fragment.find("display_encode") != std::string::npos);
}

TEST_CASE("shader source: the vertex shader hands on what the fragment shader reads of the frame, most read first") {
    const std::string block =
        "struct FrameData {\n    vec4 a;\n    vec4 ab;\n};\n"
        "layout(std140) uniform FrameBlock { FrameData frame; };\n";
    const ShaderSource source{std::string(shader_head(Glsl::k330)) + "void main() { gl_Position = vec4(0.0); }\n",
                              std::string(shader_head(Glsl::k330)) + "// shared/frame.glsl\n" + block +
                                  "float f = frame.a.x + frame.ab.y * frame.ab.z + my_frame.a;\n"};
    CHECK(frame_members_read(source.fragment) == std::vector<std::string>{"ab", "a"});
    const ShaderSource one = with_flat_frame(source, 1), both = with_flat_frame(source, 24);
    CHECK(one.fragment.find("frame.a.x + flat_ab.y * flat_ab.z + my_frame.a") != std::string::npos);
    CHECK(both.fragment.find("flat_a.x + flat_ab.y * flat_ab.z + my_frame.a") != std::string::npos);
    CHECK(one.fragment.find("flat in highp vec4 flat_a;") == std::string::npos);
    CHECK(one.vertex.find(block) != std::string::npos);
    CHECK(both.vertex.find("void main() { flat_ab = frame.ab; flat_a = frame.a; gl_Position") != std::string::npos);
    const ShaderSource without{source.vertex, "void main() {}\n"};
    CHECK(with_flat_frame(without, 24).vertex == without.vertex);
    const ShaderSource none = with_flat_frame(source, 0);
    CHECK(none.fragment == source.fragment);
}

TEST_CASE("shader source: for browsers everything is exact: GLSL ES takes samplers as lowp unless they are asked for") {
    const std::string head(shader_head(Glsl::kEs300));
    CHECK(head.starts_with("#version 300 es\n"));
    std::set<std::string> types = {"float", "int"};
    const std::regex sampler("\\b[iu]?sampler[A-Za-z0-9]+");
    for (const EmbeddedShader& file : embedded_shaders()) {
        const std::string text(file.text);
        for (std::sregex_iterator found(text.begin(), text.end(), sampler), end; found != end; ++found)
            types.insert(found->str());
        CHECK_MESSAGE(text.find("mediump") == std::string::npos, file.path);
        CHECK_MESSAGE(text.find("lowp") == std::string::npos, file.path);
    }
    CHECK(types.size() >= 4);  // those above and two of samplers
    for (const std::string& type : types)
        CHECK_MESSAGE(head.find("precision highp " + type + ";\n") != std::string::npos, type);
}
