#include "shaderlib/medium_text.h"

#include <fmt/format.h>

#include "expr/formula.h"
#include "plan/medium.h"
#include "scene/medium_grid.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

std::string function_text(const char* name, const std::string& formula) {
    const auto parsed = expr::Formula::parse(formula, medium_variables());
    return fmt::format("float medium_{}(float x, float y, float z, float r, float t) {{\n{}    return value;\n}}\n",
                       name, parsed ? parsed->glsl("value") : "    float value = 0.0;\n");
}

}  // namespace

std::string medium_text(const Scene& scene) {
    if (!scene.medium || !scene.medium->by_place()) return "";
    const MediumSpec& medium = *scene.medium;
    constexpr const char* kDirections[] = {"vec3(0.0)", "vec3(1.0, 0.0, 0.0)", "vec3(0.0, 1.0, 0.0)",
                                           "vec3(0.0, 0.0, 1.0)"};
    std::string text = fmt::format("#define COLDEST_K {:.1f}\n", kColdest_K);
    if (medium.field_direction != FieldDirection::kIsotropic) text += "#define FIELD_DIRECTED\n";
    const bool of_file = medium.field_direction == FieldDirection::kFile;
    const char* direction = of_file ? "" : kDirections[static_cast<int>(medium.field_direction)];
    if (medium.kind == MediumKind::kGrid) {
        text += fmt::format("#define DENSEST_MATTER {:e}\n#define FASTEST_MATTER {:.1f}\n#define LEAST_FALL {:e}\n",
                            MediumGrid::kDensest, kFastestMatter, MediumGrid::kLeastFall);
        return of_file ? text : text + fmt::format("#define FIELD_DIRECTION {}\n", direction);
    }
    text += include_line("effect/expression.glsl") + include_line("medium/matter.glsl");
    const auto value = [&](const char* name, const std::string& formula, bool used) {
        if (!used) return std::string("0.0");
        text += function_text(name, formula);
        return fmt::format("medium_{}(at.x, at.y, at.z, r, t)", name);
    };
    const MediumFormulas& f = medium.formulas;
    const std::string density = value("density", f.density, true),
                      temperature = value("temperature", f.temperature, medium.emission != MediumEmission::kPowerLaw),
                      field = value("field", f.field, medium.emission == MediumEmission::kSynchrotron),
                      outward = value("outward", f.outward, true), south = value("south", f.south, true),
                      east = value("east", f.east, true);
    return text + fmt::format(
                      "MediumMatter medium_matter(vec3 at, float r, float t) {{\n"
                      "    MediumMatter matter;\n"
                      "    matter.density = max({}, 0.0);\n"
                      "    matter.temperature = {};\n"
                      "    matter.field = {};\n"
                      "    matter.field_way = {};\n"
                      "    matter.velocity = clamp(vec3({}, {}, {}), -{:.1f}, {:.1f});\n"
                      "    return matter;\n"
                      "}}\n",
                      density, temperature, field, direction, outward, south, east, kFastestMatter, kFastestMatter);
}

}  // namespace nullscope
