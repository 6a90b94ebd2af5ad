#include "shaderlib/body_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "expr/formula.h"
#include "scene/moving.h"
#include "scene/named_surface.h"
#include "shaderlib/preprocess.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

struct Body {
    std::string name;
    int number;        // Object
    const char* file;  // of shaders/
    const BodyLook* look;
    std::string size;               // GLSL: the length that grains are counted over
    std::string middle, normal;     // GLSL: at the place `place`
    const char* mapping = nullptr;  // instead of the look's
    bool marched = true;
    bool far = false;
};

std::vector<Body> bodies_of(const Scene& scene, bool mino) {
    std::vector<Body> bodies;
    if (scene.sphere)
        bodies.push_back({"sphere", 2,
                          scene.sphere->swing > 0.0 ? "object/pulse.glsl"
                          : mino                    ? "object/still_sphere.glsl"
                                                    : "planar/sphere.glsl",
                          &scene.sphere->look, "frame.sphere_form.x", "vec3(0.0)", "place.outward", nullptr,
                          mino || scene.sphere->swing > 0.0});
    if (scene.cylinder)
        bodies.push_back({"cylinder", 3, "object/cylinder.glsl", &scene.cylinder->look, "frame.cylinder_form.y",
                          "vec3(0.0)", "cylinder_normal(place.at)", "MAPPING_PLANE", true, scene.cylinder->far});
    if (scene.ball)
        bodies.push_back({"ball", 4, "object/ball.glsl", &scene.ball->look, "frame.ball_form.w", "ball_middle(place)",
                          "ball_offset(place) / frame.ball_form.w", nullptr, true, scene.ball->far});
    if (scene.surface)
        bodies.push_back({"surface", 5, "object/surface.glsl", &scene.surface->look, "frame.surface_form.x",
                          "vec3(0.0)", "surface_normal(place)", nullptr, true, scene.surface->far});
    return bodies;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

std::string file_of(const Body& body) { return include_line(body.file); }

// For shaders/object/surface.glsl: the formula, with or without the time.
std::string shape_of(const SurfaceSpec& surface) {
    const auto formula = expr::Formula::parse(surface_shape(surface), {"x", "y", "z", "t"});
    const std::string time = surface_moves(surface)
                                 ? "#define SURFACE_MOVES\n#define SURFACE_T , float t\n#define SURFACE_AT_T , t\n"
                                 : "#define SURFACE_T\n#define SURFACE_AT_T\n";
    return include_line("effect/expression.glsl") + time +
           "float surface_formula(vec3 at SURFACE_T) {\n    float x = at.x;\n    float y = at.y;\n    float z = "
           "at.z;\n" +
           (formula ? formula->glsl("value") : "    float value = 1.0;\n") + "    return value;\n}\n";
}

std::string statements(const BodyLook& look) {
    const auto formula = expr::Formula::parse(look.formula, {"u", "v", "x", "y", "z"});
    return formula ? formula->glsl("value") : "    float value = 0.0;\n";
}

// The template of shaders/object/paint.glsl for what is covered, and of body_light.glsl for bodies.
std::string light_of(const Body& body, bool solid) {
    constexpr const char* kTextures[] = {"TEXTURE_PLAIN", "TEXTURE_CHECKER", "TEXTURE_GRID", "TEXTURE_STRIPES",
                                         "TEXTURE_NOISE", "TEXTURE_FORMULA", "TEXTURE_IMAGE"};
    constexpr const char* kMappings[] = {"MAPPING_EQUIRECTANGULAR", "MAPPING_BAND", "MAPPING_CAPS", "MAPPING_CUBE"};
    const BodyLook& look = *body.look;
    std::vector<std::string> defines = {
        kTextures[static_cast<int>(look.texture)],
        body.mapping != nullptr ? body.mapping : kMappings[static_cast<int>(look.mapping)]};
    if (solid) defines.emplace_back("MAPPING_OUTSIDE");
    std::string text = resolved_branches(shader_file("object/paint.glsl"), defines);
    if (solid) text += shader_file("object/body_light.glsl");
    if (look.texture == TextureKind::kFormula) text = replaced(std::move(text), "BODY_STATEMENTS\n", statements(look));
    text = replaced(std::move(text), "frame.BODY_size", body.size);
    return replaced(std::move(text), "BODY", body.name);
}

std::string coats_of(const Scene& scene) {
    std::string text;
    if (scene.disc && scene.disc->look.texture != TextureKind::kImage)
        text += light_of({"disc_coat", 0, "", &scene.disc->look, "frame.disc_y.w", "", "", "MAPPING_POLAR"}, false);
    const BodyLook sky = sky_look(scene.sky);
    if (has_look(scene.sky.kind)) text += light_of({"dome", 0, "", &sky, "1.0", "", "", "MAPPING_INSIDE"}, false);
    return text;
}

// Through a wormhole: a body's value on its own side; on the other, from where the way to it leads through the throat, that of the throat
// and the way to there.
std::string value_by_side(const Body& body) {
    const char* off = body.far ? "place.side >= 0.0" : "place.side <= 0.0";
    const std::string at = body.name == "cylinder" ? "place.at" : "place";
    const std::string across = fmt::format("    bool off = {};\n    float way = off ? place.r : 0.0;\n", off);
    return fmt::format(
               "float {0}_value_by_side(RayPlace place) {{\n{1}    if (off) place.at = vec3(0.0);\n    return "
               "{0}_value({2}) + way;\n}}\n",
               body.name, across, at) +
           fmt::format(
               "float {0}_room_by_side(RayPlace place) {{\n{1}    if (!off) return {0}_room(place);\n    place.at = "
               "vec3(0.0);\n    return {0}_{3} + way;\n}}\n",
               body.name, across, at, body.name == "surface" ? "room(place)" : "value(" + at + ")");
}

std::string march_of(const std::vector<Body>& bodies, const Scene& scene, const EffectSet& effects) {
    const bool sides = effects.contains(Effect::kSides), mino = light_path_kind(effects) == LightPathKind::kMino;
    std::string value, object, room, helpers;
    for (const Body& body : bodies) {
        if (!body.marched) continue;
        helpers += file_of(body);
        if (sides) {
            helpers += value_by_side(body);
            value += fmt::format("    value = min(value, {}_value_by_side(place));\n", body.name);
            room += fmt::format("    room = min(room, {}_room_by_side(place));\n", body.name);
            object += fmt::format(
                "    if ({0}_value_by_side(place) < value) {{\n        value = {0}_value_by_side(place);\n        "
                "object = {1};\n    }}\n",
                body.name, body.number);
            continue;
        }
        const std::string at = body.name == "cylinder" ? "place.at" : "place";
        value += fmt::format("    value = min(value, {}_value({}));\n", body.name, at);
        room += fmt::format("    room = min(room, {}_room(place));\n", body.name);
        object += fmt::format(
            "    if ({0}_value({2}) < value) {{\n        value = {0}_value({2});\n        object = {1};\n    }}\n",
            body.name, body.number, at);
    }
    if (value.empty()) return "";
    const bool ball_alone = bodies.back().name == "ball" && scene.ball->motion == BallMotion::kStill &&
                            std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return b.marched; }) == 1;
    const std::string stop = mino ? ""
                                  : std::string(ball_alone ? include_line("planar/ball_beside.glsl") : "") +
                                        "float march_stop(Trace trace, vec3 tangent, float phi) { return " +
                                        std::string(ball_alone ? "ball_beside(trace, tangent) ? 1.0e-9 : " : "") +
                                        "max(phi, 1.0e-9); }\n";
    // Steps of a surface are equal: as many as cross its bounding sphere, and as many again for a way that is bent.
    const int steps = (sides ? 256 : 128) + (scene.surface ? 2 * scene.surface->steps : 0);
    const std::string graze = scene.surface ? "1.0e30" : "2.0 * angle * place_speed(place)";
    return fmt::format("#define MARCH_MOST_STEPS {}\n", steps) + helpers + stop +
           "float march_value(RayPlace place) {\n    float value = 1.0e30;\n" + value +
           "    return value;\n}\n"
           "float march_room(RayPlace place) {\n    float room = 1.0e30;\n" +
           room +
           "    return room;\n}\n"
           "float march_graze(float angle, RayPlace place) { return " +
           graze +
           "; }\n"
           "int march_object(RayPlace place) {\n    float value = 1.0e30;\n    int object = 0;\n" +
           object + "    return object;\n}\n";
}

std::string hit_of(const std::vector<Body>& bodies) {
    const bool sphere = !bodies.front().marched,
               march = bodies.back().marched;  // only a sphere that keeps its size is not
    const std::string text =
        (sphere ? file_of(bodies.front()) : "") + (march ? include_line("planar/march.glsl") : "") +
        "SolidHit solid_hit(Trace trace, float blur) {\n    vec3 tangent = place_tangent(trace);\n    SolidHit hit = ";
    const std::string placed =
        "    if (hit.object != 0) hit.place = place_seen(trace, tangent, hit.phi);\n    return hit;\n}\n";
    if (sphere && !march) return text + "sphere_hit(trace, tangent, blur);\n" + placed;
    if (!sphere) return text + "march_hit(trace, tangent, march_stop(trace, tangent, trace.phi_end), blur);\n" + placed;
    // What lies before the sphere; a body's blurred edge before it hides the sphere's own.
    return text +
           "sphere_hit(trace, tangent, blur);\n"
           "    bool whole = hit.covered >= 1.0;\n"
           "    SolidHit other = march_hit(trace, tangent, march_stop(trace, tangent, whole ? hit.phi : "
           "trace.phi_end), whole ? "
           "0.0 : blur);\n"
           "    if (other.object != 0 && (hit.object == 0 || other.phi < hit.phi)) hit = other;\n" +
           placed;
}

}  // namespace

BodyText body_text(const Scene& scene, const EffectSet& effects) {
    const bool mino = light_path_kind(effects) == LightPathKind::kMino;
    const std::vector<Body> bodies = bodies_of(scene, mino);
    BodyText text;
    text.coats = coats_of(scene);
    if (bodies.empty()) return text;
    if (scene.surface) text.shape = shape_of(*scene.surface);
    text.march = march_of(bodies, scene, effects);
    if (!mino) text.hit = hit_of(bodies);
    std::string choice;
    for (const Body& body : bodies) {
        text.light += file_of(body) + light_of(body, true);
        choice += fmt::format("    if (hit.object == {}) return {}_light(trace, place, place.at - {}, {});\n",
                              body.number, body.name, body.middle, body.normal);
    }
    text.light += "vec3 solid_light(Trace trace, SolidHit hit) {\n    RayPlace place = hit.place;\n" + choice +
                  "    return vec3(0.0);\n}\n";
    return text;
}

}  // namespace nullscope
