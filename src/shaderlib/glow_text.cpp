#include "shaderlib/glow_text.h"

#include <fmt/format.h>

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

GlowText glow_text(const Scene& scene, const std::vector<GlowGroup>& groups) {
    if (groups.empty()) return {};
    GlowText text{include_line("path/glow"), include_line("object/glow.glsl")};
    std::string choice;
    std::size_t next = glow_from(scene);
    for (const auto& [name, shape, moves, from, to] : groups) {
        const std::string at = fmt::format("{} + {} * (i - {})", next, kGlowVectors, from);
        next += kGlowVectors * (to - from);
        const bool ball = shape == "moving_ball";
        if (ball) text.shift += include_line("object/moving_ball_velocity.glsl");
        if (shape == "pulse") text.shift += include_line("object/pulse_velocity.glsl");
        const std::string motion =
            fmt::format(", {}, {}_velocity(i, place)", ball ? "moving_ball_middle(i, place)" : "place.at", shape);
        text.shift += fmt::format(
            "float {}_g(int i, Trace trace, RayPlace place) {{ return {}_g(trace, place, objects[{} + 1]{}); }}\n",
            name, moves ? "moving" : "rest", at, moves ? motion : "");
        text.light += fmt::format(
            "vec3 {0}_glow(int i, Trace trace, RayPlace place) {{ return {0}_light(i, trace, place) * "
            "glow_light({1}, {0}_g(i, trace, place)); }}\n",
            name, at);
        choice += fmt::format("    if (i >= {} && i < {}) return {}_g(i, trace, hit.place);\n", from, to, name);
    }
    text.shift += "float solid_g(Trace trace, SolidHit hit) {\n    int i = hit.object - BODIES_FROM;\n" + choice +
                  "    return 0.0;\n}\n";
    return text;
}

}  // namespace nullscope
