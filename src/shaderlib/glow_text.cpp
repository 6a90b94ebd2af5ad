#include "shaderlib/glow_text.h"

#include <fmt/format.h>

#include "scene/bodies.h"
#include "shaderlib/body_text.h"
#include "shaderlib/shader_source.h"

namespace nullscope {

std::size_t glow_from(const Scene& scene) {
    return 5 * shader_bodies(scene).size() + (scene.disc ? 3 * scene.spots.size() : 0);
}

std::size_t glow_to(const Scene& scene) {
    std::size_t to = glow_from(scene);
    for (const std::size_t i : shader_bodies(scene)) to += scene.bodies[i].material.temperature_K ? kGlowVectors : 0;
    return to;
}

bool sphere_turns(const Scene& scene) {
    const Body* sphere = seen_sphere(scene);
    return sphere != nullptr && std::get<SphereSpec>(sphere->shape).spin_rate != 0.0;
}

bool has_caps(const Scene& scene) {
    const Body* sphere = seen_sphere(scene);
    return !scene.caps.empty() && sphere != nullptr && sphere->material.temperature_K;
}

std::size_t turn_from(const Scene& scene) { return glow_to(scene); }
std::size_t caps_from(const Scene& scene) { return turn_from(scene) + (sphere_turns(scene) ? 1 : 0); }
std::size_t caps_to(const Scene& scene) { return caps_from(scene) + (has_caps(scene) ? 2 * scene.caps.size() : 0); }

std::string turn_defines(const Scene& scene) {
    std::string text;
    if (sphere_turns(scene)) text += fmt::format("#define SPHERE_TURN {}\n", turn_from(scene));
    if (has_caps(scene))
        text += fmt::format("#define CAP_FROM {}\n#define CAP_COUNT {}\n", caps_from(scene), scene.caps.size());
    return text;
}

GlowText glow_text(const Scene& scene, const std::vector<GlowGroup>& groups) {
    if (groups.empty()) return {};
    GlowText text{include_line("path/glow"), include_line("object/glow.glsl")};
    std::string choice;
    std::size_t next = glow_from(scene);
    for (const auto& [name, shape, moves, capped, from, to] : groups) {
        const std::string at = fmt::format("{} + {} * (i - {})", next, kGlowVectors, from);
        next += kGlowVectors * (to - from);
        const bool ball = shape == "moving_ball";
        if (ball) text.shift += include_line("object/moving_ball_velocity.glsl");
        if (shape == "pulse") text.shift += include_line("object/pulse_velocity.glsl");
        if (shape == "sphere" && moves) text.shift += include_line("object/sphere_turn.glsl");
        if (capped) text.light += include_line("object/caps.glsl");
        const std::string motion =
            fmt::format(", {}, {}_velocity(i, place)", ball ? "moving_ball_middle(i, place)" : "place.at", shape);
        text.shift += fmt::format(
            "float {}_g(int i, Trace trace, RayPlace place) {{ return {}_g(trace, place, objects[{} + 1]{}); }}\n",
            name, moves ? "moving" : "rest", at, moves ? motion : "");
        const std::string light = fmt::format("{}_light(i, trace, place) * glow_light({}, g)", name, at);
        text.light += fmt::format(
            "vec3 {}_glow(int i, Trace trace, RayPlace place) {{\n    float g = {}_g(i, trace, place);\n    return "
            "{};\n}}\n",
            name, name,
            capped ? fmt::format("with_caps({}, i, trace, place, g, objects[{} + 1].x)", light, at) : light);
        choice += fmt::format("    if (i >= {} && i < {}) return {}_g(i, trace, hit.place);\n", from, to, name);
    }
    text.shift += "float solid_g(Trace trace, SolidHit hit) {\n    int i = hit.object - BODIES_FROM;\n" + choice +
                  "    return 0.0;\n}\n";
    return text;
}

}  // namespace nullscope
