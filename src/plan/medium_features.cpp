// Features of matter along rays.
#include <fmt/format.h>

#include "plan/feature.h"

namespace nullscope {
namespace {

bool is_flow(const Scene& s) { return s.medium->kind == MediumKind::kFlow; }
bool is_gas(const Scene& s) { return s.medium->kind == MediumKind::kGas; }
constexpr std::string_view kFlow = "kind = \"flow\"", kGas = "kind = \"gas\"";

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
         "alpha of the emissivity nu^-alpha and of the absorptivity nu^-(2.5 + alpha). Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->spectral_index; }, is_flow, kFlow},
        {"medium", "emissivity", KeyType::kNumber, "erg/(s cm^3 Hz sr)", "3e-18", closed(0.0, 1e30), "",
         "Emissivity of the densest matter at 230 GHz, in its own frame. Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->emissivity; }, is_flow, kFlow},
        {"medium", "absorption", KeyType::kNumber, "", "0", closed(0.0, 1e30), "",
         "Absorptivity over emissivity at 230 GHz, both in cgs units; 0 is transparent matter. Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->absorption; }, is_flow, kFlow},
        {"medium", "frequency", KeyType::kNumber, "GHz", "230", closed(1e-3, 1e12), "",
         "Frequency at which the camera sees the matter. Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->frequency_GHz; }, is_flow, kFlow},
    };
}

std::vector<SceneKey> gas_keys() {
    return {
        {"medium", "kind", KeyType::kChoice, "", "gas", kNoRange, "gas flow",
         "What the matter is: gas, a soft thick disc in circular orbits; flow, a hot flow about the hole that shines "
         "by a power law, "
         "seen at one frequency.",
         [](auto& s) { return &s.medium->kind; }},
        {"medium", "colour", KeyType::kColour, "", "[1, 1, 1]", closed(0.0, 1e6), "",
         "Multiplies its light, by linear colour. Of a flow 1 stands for a brightness temperature of 1e9 K.",
         [](auto& s) { return &s.medium->colour; }},
        {"medium", "brightness", KeyType::kNumber, "", "1", kBrightness, "",
         "Multiplies its light; of gas 1 is a black body of its temperature.",
         [](auto& s) { return &s.medium->brightness; }},
        {"medium", "step", KeyType::kNumber, "", "1", closed(0.05, 4.0), "",
         "Length of the march's steps over the usual one: less is more exact, and slower.",
         [](auto& s) { return &s.medium->step; }},
        {"medium", "inner", KeyType::kNumber, "r_s", "3", kPositive, "",
         "Radius where gas begins; outside the photon sphere. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->inner; }, is_gas, kGas},
        {"medium", "outer", KeyType::kNumber, "r_s", "12", kPositive, "", "Radius where it ends. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->outer; }, is_gas, kGas},
        {"medium", "thickness", KeyType::kNumber, "", "0.1", closed(0.01, 0.5), "",
         "Scale height over the radius: the density is Gaussian across the plane. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->thickness; }, is_gas, kGas},
        {"medium", "optical_depth", KeyType::kNumber, "", "4", closed(0.0, 1000.0), "",
         "Optical depth through the gas along the plane's normal. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->optical_depth; }, is_gas, kGas},
        {"medium", "edge", KeyType::kNumber, "", "0.25", closed(0.01, 2.0), "",
         "Width of both rims in ln r, within which the density fades. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->edge; }, is_gas, kGas},
        {"medium", "temperature", KeyType::kNumber, "K", "8000", closed(600.0, 1e9), "",
         "Temperature at the inner radius, from where it falls as r^(-3/4). Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->temperature_K; }, is_gas, kGas},
        {"medium", "gas_contrast", KeyType::kNumber, "", "0.7", closed(0.0, 1.0), "",
         "How much denser clumps of gas are than gaps; 0 is smooth. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.contrast; }, is_gas, kGas},
        {"medium", "gas_winding", KeyType::kNumber, "rad", "4", closed(0.0, 30.0), "",
         "Azimuth by which filaments of gas trail for each factor of e in radius. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.winding; }, is_gas, kGas},
        {"medium", "flow", KeyType::kChoice, "", "still", kNoRange, "still kepler",
         "Motion of the clumps: none, or with the gas, each ring at its own orbital speed. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->flow; }, is_gas, kGas},
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
          "ray ends, orbit table; the ray's way once more, in samples of two exponentials",
          {Slot::kMedium, "medium/flow.glsl"}},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.medium || f.scene.medium->kind != MediumKind::kFlow) return kNot;
             return fmt::format("[medium] of radius {}", f.scene.medium->radius);
         },
         [](Scene& s) { s.medium.reset(); },
         [](Scene& s) {
             s.spacetime.metric = "schwarzschild";
             s.object.mass_suns = 4.3e6;
         },
         [](Scene& s) { s.medium.emplace().kind = MediumKind::kFlow; },
         nullptr,
         flow_keys()},
        {{Effect::kMediumGas,
          "medium-gas",
          "EFFECT_MEDIUM_GAS",
          "Light is emitted and absorbed along its way by a soft disc of gas.",
          "there is a [medium] of kind \"gas\"",
          "ray ends, orbit table, black body; the ray's way once more, in samples of up to 16 hashes",
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
         gas_keys()},
        {{Effect::kMediumMotion, "medium-motion", "EFFECT_MEDIUM_MOTION",
          "The clumps of a soft disc's gas go round with it.", "medium.flow is \"kepler\"",
          "two exponentials and roots an octave of each sample"},
         [](const FrameFacts& f) {
             return reason_if(f.gas() && f.scene.medium->flow != DiscFlowKind::kStill, "medium.flow = \"kepler\"");
         },
         [](Scene& s) {
             if (s.medium) s.medium->flow = DiscFlowKind::kStill;
         },
         [](Scene& s) {
             s.spacetime.metric = "schwarzschild";
             s.light.shift = s.light.beaming = s.light.delay = false;
             s.medium.emplace();
         },
         [](Scene& s) { s.medium->flow = DiscFlowKind::kKepler; }},
    });
    return features;
}

}  // namespace nullscope
