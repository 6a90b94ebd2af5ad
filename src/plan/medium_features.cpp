// Features of matter along rays.
#include <fmt/format.h>

#include "base/assets.h"
#include "plan/feature.h"
#include "plan/medium.h"

namespace nullscope {
namespace {

bool is_flow(const Scene& s) { return s.medium->kind == MediumKind::kFlow; }
bool medium_is_gas(const Scene& s) { return s.medium->kind == MediumKind::kGas; }
bool medium_is_formula(const Scene& s) { return s.medium->kind == MediumKind::kFormula; }
bool is_grid(const Scene& s) { return s.medium->kind == MediumKind::kGrid; }
bool has_outer(const Scene& s) { return medium_is_gas(s) || s.medium->by_place(); }
bool is_black_body(const Scene& s) { return s.medium->by_place() && s.medium->emission == MediumEmission::kBlackBody; }
bool is_synchrotron(const Scene& s) {
    return s.medium->by_place() && s.medium->emission == MediumEmission::kSynchrotron;
}
bool is_warm(const Scene& s) { return medium_is_formula(s) && s.medium->emission != MediumEmission::kPowerLaw; }
bool has_field(const Scene& s) { return medium_is_formula(s) && is_synchrotron(s); }
bool has_temperature(const Scene& s) { return medium_is_gas(s) || is_black_body(s); }
bool has_power(const Scene& s) {
    return is_flow(s) || (s.medium->by_place() && s.medium->emission == MediumEmission::kPowerLaw);
}
bool by_place(const Scene& s) { return s.medium->by_place(); }
bool by_frequency(const Scene& s) { return s.medium->by_frequency(); }
constexpr std::string_view kFlow = "kind = \"flow\"", kGas = "kind = \"gas\"", kFormula = "kind = \"formula\"",
                           kGrid = "kind = \"grid\"", kByPlace = "kind = \"formula\" or \"grid\"",
                           kPower = "kind = \"flow\" or emission = \"power-law\"",
                           kSynchrotron = "emission = \"synchrotron\"", kBlackBody = "emission = \"black-body\"";
constexpr std::string_view kVariables = "x y z r t";

constexpr double kShippedGridSpin = 0.9;  // of assets/medium/torus.grid

// Parts of examples.
void massive_hole(Scene& s) {
    s.spacetime.metric = "schwarzschild";
    s.object.mass_suns = 4.3e6;
}
void medium_by_formula(Scene& s) {
    massive_hole(s);
    s.medium.emplace().kind = MediumKind::kFormula;
}

std::vector<SceneKey> flow_keys() {
    return {
        {"medium", "radius", KeyType::kNumber, "r_s", "5", kPositive, "",
         "Radius at which the density of a flow has fallen to exp(-1/2). Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->radius; }, is_flow, kFlow},
        {"medium", "flattening", KeyType::kNumber, "", "0", closed(0.0, 1000.0), "",
         "The density of a flow falls off from the equatorial plane as exp(-(flattening cos theta)^2/2); 0 is a "
         "sphere. Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->flattening; }, is_flow, kFlow},
        {"medium", "angular_momentum", KeyType::kNumber, "", "1", closed(-1.0, 1.0), "",
         "l0 of the angular momentum l = l0 R^1.5/(1 + R) of the matter for its energy, R = r sin(theta) in M; 0: "
         "none. Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->momentum; }, is_flow, kFlow},
        {"medium", "spectral_index", KeyType::kNumber, "", "0", closed(-10.0, 10.0), "",
         "alpha of the emissivity nu^-alpha and of the absorptivity nu^-(2.5 + alpha). Needs kind = \"flow\" or "
         "emission "
         "= \"power-law\".",
         [](auto& s) { return &s.medium->spectral_index; }, has_power, kPower},
        {"medium", "emissivity", KeyType::kNumber, "erg/(s cm^3 Hz sr)", "3e-18", closed(0.0, 1e30), "",
         "Emissivity at 230 GHz where the density is 1, in the frame of the matter. Needs kind = \"flow\" or emission "
         "= "
         "\"power-law\".",
         [](auto& s) { return &s.medium->emissivity; }, has_power, kPower},
        {"medium", "absorption", KeyType::kNumber, "", "0", closed(0.0, 1e30), "",
         "Absorptivity over emissivity at 230 GHz, both in cgs units; 0 is transparent matter. Needs kind = \"flow\" "
         "or "
         "emission = \"power-law\".",
         [](auto& s) { return &s.medium->absorption; }, has_power, kPower},
        {"medium", "frequency", KeyType::kNumber, "GHz", "230", closed(1e-3, 1e12), "",
         "Frequency at which the camera sees the matter. Needs kind = \"flow\", or emission = \"power-law\" or "
         "\"synchrotron\".",
         [](auto& s) { return &s.medium->frequency_GHz; }, by_frequency, "matter that is seen at one frequency"},
    };
}

std::vector<SceneKey> formula_keys() {
    const auto formula = [](std::string_view key, std::string_view unit, std::string_view fallback,
                            std::string_view help, KeyMember member, bool (*meant)(const Scene&),
                            std::string_view with) {
        return SceneKey{"medium", key, KeyType::kFormula, unit, fallback, kNoRange, kVariables, help, member,
                        meant,    with};
    };
    return {
        {"medium", "emission", KeyType::kChoice, "", "power-law", kNoRange, "power-law black-body synchrotron",
         "How the matter shines: power-law, as a flow; black-body, by its temperature in all colours, with one "
         "opacity; "
         "synchrotron, thermal electrons in a magnetic field. Needs kind = \"formula\" or \"grid\".",
         [](auto& s) { return &s.medium->emission; }, by_place, kByPlace},
        formula(
            "density", "", "exp(-r^2/18)",
            "Density at x, y, z (r_s), r from the centre, at time t: over that of emissivity or opacity; of "
            "synchrotron radiation electrons a cm^3. Needs kind = \"formula\".",
            [](auto& s) { return &s.medium->formulas.density; }, medium_is_formula, kFormula),
        formula(
            "local_temperature", "K", "1e4",
            "Temperature at a place; of synchrotron radiation the electrons', which must be above 5e8. Needs kind = "
            "\"formula\" with emission = \"black-body\" or \"synchrotron\".",
            [](auto& s) { return &s.medium->formulas.temperature; }, is_warm,
            "kind = \"formula\" and another emission than \"power-law\""),
        formula(
            "field", "G", "10", "Magnetic field at a place. Needs kind = \"formula\" with emission = \"synchrotron\".",
            [](auto& s) { return &s.medium->formulas.field; }, has_field, kSynchrotron),
        formula(
            "velocity_out", "c", "0",
            "Motion along the radius at a place, as gamma v, seen by the observer of no angular momentum there. Needs "
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
        {"medium", "field_direction", KeyType::kChoice, "", "isotropic", kNoRange, "isotropic out south east file",
         "Direction of the magnetic field in the frame of the matter; isotropic: the mean over all; file: that of kind "
         "= \"grid\". Needs emission = \"synchrotron\".",
         [](auto& s) { return &s.medium->field_direction; }, is_synchrotron, kSynchrotron},
        {"medium", "height", KeyType::kNumber, "r_s", "1e6", kPositive, "",
         "Largest distance of the matter from the equatorial plane. Needs kind = \"formula\" or \"grid\".",
         [](auto& s) { return &s.medium->height; }, by_place, kByPlace},
        {"medium", "opacity", KeyType::kNumber, "1/r_s", "1", closed(0.0, 1e6), "",
         "Optical depth for each r_s where the density is 1. Needs emission = \"black-body\".",
         [](auto& s) { return &s.medium->opacity; }, is_black_body, kBlackBody},
        {"medium", "steps", KeyType::kWhole, "", "64", closed(16.0, 1024.0), "",
         "Samples across the sphere of radius outer; what is thinner may be missed. Needs kind = \"formula\" or "
         "\"grid\".",
         [](auto& s) { return &s.medium->steps; }, by_place, kByPlace},
    };
}

std::vector<SceneKey> grid_keys() {
    return {
        {"medium", "file", KeyType::kImage, "", "", kNoRange, "grid of matter",
         "The file of the matter; docs/matter.md has its format. Needs kind = \"grid\".",
         [](auto& s) { return &s.medium->file; }, is_grid, kGrid, true},
        {"medium", "density_scale", KeyType::kNumber, "", "1", closed(1e-12, 1e12), "",
         "Multiplies the densities of the file; the magnetic field is multiplied by the root of it. Needs kind = "
         "\"grid\".",
         [](auto& s) { return &s.medium->density_scale; }, is_grid, kGrid},
    };
}

std::vector<SceneKey> medium_gas_keys() {
    return {
        {"medium", "kind", KeyType::kChoice, "", "gas", kNoRange, "gas flow formula grid",
         "What the matter is: gas, a soft thick disc in circular orbits; flow, a hot flow about the hole that shines "
         "by a power law, seen at one frequency; formula, what the formulas of density, temperature and motion say; "
         "grid, what a file has at the nodes of a grid.",
         [](auto& s) { return &s.medium->kind; }},
        {"medium", "colour", KeyType::kColour, "", "[1, 1, 1]", closed(0.0, 1e6), "",
         "Multiplies its light, by linear colour. Where that is of one frequency, 1 stands for a brightness "
         "temperature of "
         "1e9 K.",
         [](auto& s) { return &s.medium->colour; }},
        {"medium", "brightness", KeyType::kNumber, "", "1", kBrightness, "",
         "Multiplies its light; of gas and of black bodies 1 is a black body of `temperature`.",
         [](auto& s) { return &s.medium->brightness; }},
        {"medium", "step", KeyType::kNumber, "", "1", closed(0.05, 4.0), "",
         "Length of the march's steps over the usual one: less is more exact, and slower.",
         [](auto& s) { return &s.medium->step; }},
        {"medium", "inner", KeyType::kNumber, "r_s", "3", kPositive, "",
         "Radius where gas begins; outside the photon sphere. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->inner; }, medium_is_gas, kGas},
        {"medium", "outer", KeyType::kNumber, "r_s", "12", kPositive, "",
         "Radius where it ends. Needs kind = \"gas\", \"formula\" or \"grid\".",
         [](auto& s) { return &s.medium->outer; }, has_outer, "another kind than \"flow\""},
        {"medium", "thickness", KeyType::kNumber, "", "0.1", closed(0.01, 0.5), "",
         "Scale height over the radius: the density is Gaussian across the plane. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->thickness; }, medium_is_gas, kGas},
        {"medium", "optical_depth", KeyType::kNumber, "", "4", closed(0.0, 1000.0), "",
         "Optical depth through the gas along the plane's normal. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->optical_depth; }, medium_is_gas, kGas},
        {"medium", "edge", KeyType::kNumber, "", "0.25", closed(0.01, 2.0), "",
         "Width of both rims in ln r, within which the density fades. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->edge; }, medium_is_gas, kGas},
        {"medium", "temperature", KeyType::kNumber, "K", "8000", closed(600.0, 1e9), "",
         "Temperature at the inner radius, from where it falls as r^(-3/4); of emission = \"black-body\" that of light "
         "1. "
         "Needs one of these.",
         [](auto& s) { return &s.medium->temperature_K; }, has_temperature,
         "kind = \"gas\" or emission = \"black-body\""},
        {"medium", "gas_contrast", KeyType::kNumber, "", "0.7", closed(0.0, 1.0), "",
         "How much denser clumps of gas are than gaps; 0 is smooth. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.contrast; }, medium_is_gas, kGas},
        {"medium", "gas_winding", KeyType::kNumber, "rad", "4", closed(0.0, 30.0), "",
         "Azimuth by which filaments of gas trail for each factor of e in radius. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.winding; }, medium_is_gas, kGas},
        {"medium", "flow", KeyType::kChoice, "", "still", kNoRange, "still kepler",
         "Motion of the clumps: none, or with the gas, each ring at its own orbital speed. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->flow; }, medium_is_gas, kGas},
    };
}

}  // namespace

std::span<const Feature> medium_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kMediumFlow,
          "medium-flow",
          "EFFECT_MEDIUM_FLOW",
          "Light is emitted and absorbed along its way by a hot flow about the hole.",
          "there is a [medium] of kind \"flow\"",
          "the ray's way once more, in samples of two exponentials",
          {Slot::kMedium, "medium/flow.glsl"}},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.medium || f.scene.medium->kind != MediumKind::kFlow) return kNot;
             return fmt::format("[medium] of radius {} at {} GHz", f.scene.medium->radius, f.frequency());
         },
         [](Scene& s) { s.medium.reset(); },
         massive_hole,
         [](Scene& s) { s.medium.emplace().kind = MediumKind::kFlow; },
         nullptr,
         flow_keys()},
        {{Effect::kMediumGas,
          "medium-gas",
          "EFFECT_MEDIUM_GAS",
          "Light is emitted and absorbed along its way by a soft disc of gas.",
          "there is a [medium] of kind \"gas\"",
          "the ray's way once more, in samples of up to 16 hashes",
          {Slot::kMedium, "medium/gas.glsl"}},
         [](const FrameFacts& f) -> Reason {
             if (!f.gas()) return kNot;
             return fmt::format("[medium] from {} to {}", f.scene.medium->inner, f.scene.medium->outer);
         },
         [](Scene& s) { s.medium.reset(); },
         [](Scene& s) {
             s.spacetime.metric = "schwarzschild";
             s.light.shift = s.light.beaming = false;
         },
         [](Scene& s) { s.medium.emplace(); },
         nullptr,
         medium_gas_keys()},
        {{Effect::kMediumMotion, "medium-motion", "EFFECT_MEDIUM_MOTION", "The medium depends on time.",
          "medium.flow is \"kepler\", or a formula of matter asks for t",
          "of gas two exponentials and roots an octave of each sample"},
         [](const FrameFacts& f) -> Reason {
             const char* key = f.scene.medium ? medium_moves(*f.scene.medium) : nullptr;
             if (key == nullptr) return kNot;
             return f.gas() ? "medium.flow = \"kepler\"" : fmt::format("{} asks for t", key);
         },
         [](Scene& s) {
             if (!s.medium) return;
             s.medium->flow = DiscFlowKind::kStill;
             if (medium_moves(*s.medium) != nullptr) s.medium.reset();
         },
         [](Scene& s) {
             s.spacetime.metric = "schwarzschild";
             s.light.shift = s.light.beaming = s.light.delay = false;
             s.medium.emplace();
         },
         [](Scene& s) { s.medium->flow = DiscFlowKind::kKepler; }},
        {{Effect::kMediumFormula,
          "medium-formula",
          "EFFECT_MEDIUM_FORMULA",
          "Light is emitted and absorbed along its way by matter that formulas describe.",
          "there is a [medium] of kind \"formula\"",
          "the ray's way once more, in samples of the formulas",
          {Slot::kMedium, "medium/formula.glsl"}},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.medium || f.scene.medium->kind != MediumKind::kFormula) return kNot;
             return fmt::format("[medium] of density {}", f.scene.medium->formulas.density);
         },
         [](Scene& s) { s.medium.reset(); },
         massive_hole,
         [](Scene& s) { s.medium.emplace().kind = MediumKind::kFormula; },
         nullptr,
         formula_keys()},
        {{Effect::kMediumBlackBody, "medium-black-body", "EFFECT_MEDIUM_BLACK_BODY",
          "Matter along rays is a black body of its temperature.", "medium.emission is \"black-body\"",
          "one fetch a sample"},
         [](const FrameFacts& f) {
             return reason_if(f.has_emission(MediumEmission::kBlackBody), "medium.emission = \"black-body\"");
         },
         [](Scene& s) {
             if (s.medium) s.medium->emission = MediumEmission::kPowerLaw;
         },
         [](Scene& s) {
             medium_by_formula(s);
             s.light.shift = s.light.beaming = false;
         },
         [](Scene& s) { s.medium->emission = MediumEmission::kBlackBody; }},
        {{Effect::kMediumSynchrotron, "medium-synchrotron", "EFFECT_MEDIUM_SYNCHROTRON",
          "Matter along rays shines by thermal synchrotron radiation.", "medium.emission is \"synchrotron\"",
          "a dozen exponentials and roots a sample"},
         [](const FrameFacts& f) {
             return reason_if(f.has_emission(MediumEmission::kSynchrotron),
                              fmt::format("medium.emission = \"synchrotron\" at {} GHz", f.frequency()));
         },
         [](Scene& s) {
             if (s.medium) s.medium->emission = MediumEmission::kPowerLaw;
         },
         medium_by_formula,
         [](Scene& s) { s.medium->emission = MediumEmission::kSynchrotron; }},
        {{Effect::kMediumGrid,
          "medium-grid",
          "EFFECT_MEDIUM_GRID",
          "Light is emitted and absorbed along its way by matter at the nodes of a file's grid.",
          "there is a [medium] of kind \"grid\"",
          "the ray's way once more, in samples of 16 fetches",
          {Slot::kMedium, "medium/grid.glsl"}},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.medium || f.scene.medium->kind != MediumKind::kGrid) return kNot;
             return fmt::format("[medium] of file \"{}\"", f.scene.medium->file.filename().string());
         },
         [](Scene& s) { s.medium.reset(); },
         [](Scene& s) {
             massive_hole(s);
             s.spacetime = {"kerr", {{"spin", kShippedGridSpin}}};
         },
         [](Scene& s) {
             MediumSpec& medium = s.medium.emplace();
             medium.kind = MediumKind::kGrid, medium.outer = 8;
             medium.file = assets_directory() / "medium" / "torus.grid";
         },
         nullptr,
         grid_keys()},
    });
    return features;
}

}  // namespace nullscope
