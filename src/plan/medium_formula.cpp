// Matter whose density and motion are formulas of the scene. Keys that other models share are where files have them.
#include <fmt/format.h>

#include "expr/formula.h"
#include "plan/medium.h"
#include "plan/medium_model.h"

namespace nullscope {
namespace {

bool medium_is_formula(const Scene& s) { return s.medium->kind == MediumKind::kFormula; }
constexpr std::string_view kFormula = "kind = \"formula\"", kVariables = "x y z r t";

bool is_warm(const Scene& s) { return has_share(s, kWarmth) && s.medium->warm(); }
bool has_field(const Scene& s) { return has_share(s, kWarmth) && s.medium->law_row().field; }

std::vector<SceneKey> formula_keys() {
    const auto formula = [](std::string_view key, std::string_view unit, std::string_view fallback,
                            std::string_view help, KeyMember member, bool (*meant)(const Scene&),
                            std::string_view with) {
        return SceneKey{"medium", key, KeyType::kFormula, unit, fallback, kNoRange, kVariables, help, member,
                        meant,    with};
    };
    const std::string warm(kinds_with(kWarmth));
    const std::string_view warm_law = kept(warm + " and another emission and other electrons than \"power-law\""),
                           field_law = kept(warm + " and emission = \"synchrotron\"");
    return {
        formula(
            "density", "", "exp(-r^2/18)",
            "Density at x, y, z (r_s), radius r and time t: relative to that of emissivity or opacity; with "
            "synchrotron and bremsstrahlung, electrons per cm^3. Needs kind = \"formula\".",
            [](auto& s) { return &s.medium->formulas.density; }, medium_is_formula, kFormula),
        formula(
            "local_temperature", "K", "1e4",
            kept(fmt::format("Temperature; with synchrotron that of the electrons, which emit nothing below 5e8. Needs "
                             "{}, with another emission, and other electrons, than \"power-law\".",
                             warm)),
            [](auto& s) { return &s.medium->formulas.temperature; }, is_warm, warm_law),
        formula(
            "field", "G", "10",
            kept(fmt::format("Magnetic field strength. Needs {}, with emission = \"synchrotron\".", warm)),
            [](auto& s) { return &s.medium->formulas.field; }, has_field, field_law),
        formula(
            "velocity_out", "c", "0",
            "Radial velocity, as gamma v, relative to the local zero-angular-momentum observer (ZAMO). Needs "
            "kind = \"formula\".",
            [](auto& s) { return &s.medium->formulas.outward; }, medium_is_formula, kFormula),
        formula(
            "velocity_south", "c", "0", "The same toward growing theta. Needs kind = \"formula\".",
            [](auto& s) { return &s.medium->formulas.south; }, medium_is_formula, kFormula),
        formula(
            "velocity_east", "c", "0",
            "The same toward growing phi: sqrt(0.5/(r - 1.5)) of circular orbits about a hole that does not rotate. "
            "Needs kind = \"formula\".",
            [](auto& s) { return &s.medium->formulas.east; }, medium_is_formula, kFormula),
    };
}

const char* formula_moves(const MediumSpec& medium) {
    const MediumFormulas& f = medium.formulas;
    if (asks_for_time(f.density)) return "medium.density";
    if (const char* key = warmth_moves(medium)) return key;
    if (asks_for_time(f.outward)) return "medium.velocity_out";
    if (asks_for_time(f.south)) return "medium.velocity_south";
    return asks_for_time(f.east) ? "medium.velocity_east" : nullptr;
}

}  // namespace

const MediumModel kFormulaModel{
    .word = "formula",
    .what = "given by formulas of density, temperature and motion",
    .effect = {medium_effect(MediumKind::kFormula),
               "medium-formula",
               "EFFECT_MEDIUM_FORMULA",
               "Matter given by formulas emits and absorbs light along rays.",
               "there is a [medium] of kind \"formula\"",
               "a march along each ray, in samples of the formulas",
               {Slot::kMedium, "medium/formula.glsl"}},
    .shares = kOuter | kSphere | kDensityScale | kLaws | kWarmth,
    .traits = {.turn = true, .any_density = true},
    .keys = formula_keys,
    .words = [](const MediumSpec& m) { return fmt::format("of density {}", m.formulas.density); },
    .farthest = [](const MediumSpec& m) { return m.outer; },
    .least_step = nullptr,
    .spans = sphere_spans,
    .moves = formula_moves,
    .faults = nullptr,
    .numbers = "SPHERE_RADIUS SPHERE_HEIGHT SPHERE_STEP FORMULA_DENSITY",
    .values =
        [](const MediumFrame& f) {
            std::vector<double> values = sphere_values(f);
            values.push_back(f.medium().density_scale);
            return values;
        },
    .before = massive_hole,
    .with = [](Scene& s) { s.medium.emplace().kind = MediumKind::kFormula; },
};

}  // namespace nullscope
