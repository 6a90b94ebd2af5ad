#include "shaderlib/medium_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "expr/formula.h"
#include "plan/medium.h"
#include "plan/medium_model.h"
#include "scene/medium_bands.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

// By their order, four to a vector of the uniform block.
std::string names_text(std::string_view names, std::string_view vectors) {
    std::istringstream words{std::string(names)};
    std::string text;
    int number = 0;
    for (std::string word; words >> word; ++number)
        text += fmt::format("#define {} frame.{}_{}.{}\n", word, vectors, number / 4, "xyzw"[number % 4]);
    return text;
}

// What differs from frequency to frequency has a place of its own, where the march puts the numbers of each in turn.
std::string law_text(const Scene& scene) {
    std::string text = names_text(
        fmt::format("{}{}", kLawNumbers, scene.medium->has_electrons() ? kElectronNumbers : kPowerLawNumbers),
        "medium_law");
    if (!shows_bands(scene)) return text;
    text = "vec4 law_band;\n" +
           (bands_as_colours(*scene.medium).size() == kBandsAtOnce ? "#define MEDIUM_THREE_BANDS\n" + text : text);
    std::istringstream words{std::string(kBandNumbers)};
    int number = 0;
    for (std::string word; words >> word; ++number) {
        const std::size_t at = text.find("#define " + word + " ");
        if (at == std::string::npos) continue;  // of electrons that are not thermal: the last two
        text.replace(at, text.find('\n', at) - at, fmt::format("#define {} law_band.{}", word, "xyzw"[number]));
    }
    return text;
}

std::string function_text(const char* name, const std::string& formula) {
    const auto parsed = expr::Formula::parse(formula, medium_variables());
    return fmt::format("float medium_{}(float x, float y, float z, float r, float t) {{\n{}    return value;\n}}\n",
                       name, parsed ? parsed->glsl("value") : "    float value = 0.0;\n");
}

std::string field_direction_text(const MediumSpec& medium) {
    std::string text = fmt::format("#define COLDEST_K {:.1f}\n", kColdest_K);
    if (medium.field_direction != FieldDirection::kIsotropic) text += "#define FIELD_DIRECTED\n";
    if (medium.has_electrons() && medium.electrons.kind == ElectronKind::kKappa) text += "#define ELECTRONS_KAPPA\n";
    if (is_polarised(medium) && medium.faraday) text += "#define MEDIUM_FARADAY\n";
    if (medium.field_direction == FieldDirection::kFile) return text;
    const Vec3 way = field_way_of(medium);
    return text + fmt::format("#define FIELD_DIRECTION vec3({:.9f}, {:.9f}, {:.9f})\n", way.x, way.y, way.z);
}

}  // namespace

std::string medium_text(const Scene& scene) {
    if (!scene.medium) return "";
    const MediumSpec& medium = *scene.medium;
    const MediumModel& model = model_of(medium);
    std::string text = law_text(scene) + names_text(model.numbers, "medium_form") + field_direction_text(medium);
    if (medium.kind == MediumKind::kGrid)
        text += fmt::format("#define DENSEST_MATTER {:e}\n#define FASTEST_MATTER {:.1f}\n#define LEAST_FALL {:e}\n",
                            MediumGrid::kDensest, kFastestMatter, MediumGrid::kLeastFall);
    if ((model.shares & kWarmth) == 0) return text;
    const MediumFormulas& f = medium.formulas;
    const auto value = [&](const char* name, const std::string& formula, bool used) {
        if (!used) return std::string("0.0");
        text += function_text(name, formula);
        return fmt::format("medium_{}(at.x, at.y, at.z, r, t)", name);
    };
    const bool formula = medium.kind == MediumKind::kFormula;
    if (formula || medium.by_place()) text += include_line("effect/expression.glsl");
    text += include_line("medium/matter.glsl");
    const std::string density = value("density", f.density, formula),
                      temperature = value("temperature", f.temperature, medium.warm()),
                      field = value("field", f.field, medium.law_row().field),
                      outward = value("outward", f.outward, formula), south = value("south", f.south, formula),
                      east = value("east", f.east, formula);
    text += fmt::format(
        "MediumMatter medium_warmth(MediumMatter matter, vec3 at, float r, float t) {{\n"
        "    matter.temperature = {};\n"
        "    matter.field = {};\n"
        "    matter.field_way = {};\n"
        "    return matter;\n"
        "}}\n",
        temperature, field, medium.field_direction == FieldDirection::kFile ? "vec3(0.0)" : "FIELD_DIRECTION");
    if (!formula) return text;
    return text + fmt::format(
                      "MediumMatter medium_formulas(MediumMatter matter, vec3 at, float r, float t) {{\n"
                      "    matter.density = max({}, 0.0);\n"
                      "    matter.velocity = clamp(vec3({}, {}, {}), -{:.1f}, {:.1f});\n"
                      "    return matter;\n"
                      "}}\n",
                      density, outward, south, east, kFastestMatter, kFastestMatter);
}

std::string medium_law_text(const Scene& scene) {
    if (!scene.medium) return "";
    std::string file(scene.medium->law_row().word);
    std::ranges::replace(file, '-', '_');
    if (scene.medium->has_electrons()) file += "_electrons";
    return include_line(fmt::format("medium/{}.glsl", file));
}

}  // namespace nullscope
