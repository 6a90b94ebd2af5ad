// Features of matter along rays.
#include <fmt/format.h>

#include "plan/feature.h"

namespace nullscope {
namespace {

std::vector<SceneKey> medium_keys() {
    return {
        {"medium", "kind", KeyType::kChoice, "", "flow", kNoRange, "flow",
         "What the matter is: flow, a hot flow about the hole that shines by a power law at one frequency.",
         [](auto& s) { return &s.medium->kind; }},
        {"medium", "radius", KeyType::kNumber, "r_s", "5", kPositive, "",
         "Radius at which the density has fallen to exp(-1/2).", [](auto& s) { return &s.medium->radius; }},
        {"medium", "flattening", KeyType::kNumber, "", "0", closed(0.0, 1000.0), "",
         "The density falls off from the equatorial plane as exp(-(flattening cos theta)^2/2); 0 is a sphere.",
         [](auto& s) { return &s.medium->flattening; }},
        {"medium", "angular_momentum", KeyType::kNumber, "", "1", closed(-1.0, 1.0), "",
         "l0 of the angular momentum l = l0 R^1.5/(1 + R) of the matter for its energy, R = r sin(theta) in M; 0: none.",
         [](auto& s) { return &s.medium->momentum; }},
        {"medium", "spectral_index", KeyType::kNumber, "", "0", closed(-10.0, 10.0), "",
         "alpha of the emissivity nu^-alpha and of the absorptivity nu^-(2.5 + alpha).",
         [](auto& s) { return &s.medium->spectral_index; }},
        {"medium", "emissivity", KeyType::kNumber, "erg/(s cm^3 Hz sr)", "3e-18", closed(0.0, 1e30), "",
         "Emissivity of the densest matter at 230 GHz, in its own frame.",
         [](auto& s) { return &s.medium->emissivity; }},
        {"medium", "absorption", KeyType::kNumber, "", "0", closed(0.0, 1e30), "",
         "Absorptivity over emissivity at 230 GHz, both in cgs units; 0 is transparent matter.",
         [](auto& s) { return &s.medium->absorption; }},
        {"medium", "frequency", KeyType::kNumber, "GHz", "230", closed(1e-3, 1e12), "",
         "Frequency at which the camera sees the matter.", [](auto& s) { return &s.medium->frequency_GHz; }},
        {"medium", "colour", KeyType::kColour, "", "[1, 1, 1]", closed(0.0, 1e6), "",
         "Linear colour of its light; 1 stands for a brightness temperature of 1e9 K.",
         [](auto& s) { return &s.medium->colour; }},
        {"medium", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Multiplies its light.",
         [](auto& s) { return &s.medium->brightness; }},
        {"medium", "step", KeyType::kNumber, "", "1", closed(0.05, 4.0), "",
         "Length of the march's steps over what keeps the flux to 0.1 %.", [](auto& s) { return &s.medium->step; }},
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
          {Slot::kMedium, "medium/flow.glsl", "flow_light"}},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.medium || f.scene.medium->kind != MediumKind::kFlow) return kNot;
             return fmt::format("[medium] of radius {}", f.scene.medium->radius);
         },
         [](Scene& s) { s.medium.reset(); },
         [](Scene& s) {
             s.spacetime.metric = "schwarzschild";
             s.object.mass_suns = 4.3e6;
         },
         [](Scene& s) { s.medium.emplace(); },
         nullptr,
         medium_keys()},
    });
    return features;
}

}  // namespace nullscope
