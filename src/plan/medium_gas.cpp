// A soft disc of gas. Keys that other models share are where files have them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "plan/medium_model.h"
#include "scene/orbit_sense.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

bool medium_is_gas(const Scene& s) { return s.medium->kind == MediumKind::kGas; }
constexpr std::string_view kGas = "kind = \"gas\"";

bool has_temperature(const Scene& s) { return s.medium->law() == MediumEmission::kBlackBody; }

std::vector<SceneKey> medium_gas_keys() {
    return {
        {"medium", "inner", KeyType::kNumber, "r_s", "3", kPositive, "",
         kept(fmt::format("Radius where it begins; of gas outside the photon sphere. Needs {}.", kinds_with(kInner))),
         [](auto& s) { return &s.medium->inner; }, shared<kInner>, kinds_with(kInner)},
        {"medium", "outer", KeyType::kNumber, "r_s", "12", kPositive, "",
         kept(fmt::format("Radius where it ends. Needs {}.", kinds_with(kOuter))),
         [](auto& s) { return &s.medium->outer; }, shared<kOuter>, kinds_with(kOuter)},
        {"medium", "thickness", KeyType::kNumber, "", "0.1", closed(0.01, 0.5), "",
         "Scale height over the radius: the density is Gaussian across the plane. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.thickness; }, medium_is_gas, kGas},
        {"medium", "optical_depth", KeyType::kNumber, "", "4", closed(0.0, 1000.0), "",
         "Optical depth through the gas along the plane's normal. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.optical_depth; }, medium_is_gas, kGas},
        {"medium", "edge", KeyType::kNumber, "", "0.25", closed(0.01, 2.0), "",
         kept(fmt::format("Width of both rims in ln r, within which the density fades. Needs {}.", kinds_with(kEdge))),
         [](auto& s) { return &s.medium->edge; }, shared<kEdge>, kinds_with(kEdge)},
        {"medium", "temperature", KeyType::kNumber, "K", "8000", closed(600.0, 1e9), "",
         "Temperature of gas at the inner radius, falling as r^(-3/4); with emission = \"black-body\" that of "
         "brightness 1. Needs one of these.",
         [](auto& s) { return &s.medium->temperature_K; }, has_temperature,
         "kind = \"gas\" or emission = \"black-body\""},
        {"medium", "gas_contrast", KeyType::kNumber, "", "0.7", closed(0.0, 1.0), "",
         "How much denser clumps of gas are than gaps; 0 is smooth. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.clumps.contrast; }, medium_is_gas, kGas},
        {"medium", "gas_winding", KeyType::kNumber, "rad", "4", closed(0.0, 30.0), "",
         "Azimuth by which filaments of gas trail for each factor of e in radius. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.clumps.winding; }, medium_is_gas, kGas},
        {"medium", "flow", KeyType::kChoice, "", "still", kNoRange, "still kepler",
         "Motion of the clumps: none, or with the gas, each ring at its own orbital speed. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.flow; }, medium_is_gas, kGas},
        {"medium", "sense", KeyType::kChoice, "", "eastward", kNoRange, kOrbitSenses,
         "Which way the gas goes round, as disc.sense. Needs kind = \"gas\".",
         [](auto& s) { return &s.medium->gas.sense; }, medium_is_gas, kGas},
    };
}

void gas_faults(const Spacetime& spacetime, const Scene& scene, std::vector<SceneFault>& faults) {
    if (spacetime.bends_light() &&
        !circular_orbit(spacetime, scene.medium->inner, sense_about(spacetime, scene.medium->gas.sense)))
        faults.push_back({"medium.inner", fmt::format("no circular orbit at {}", scene.medium->inner),
                          "a radius outside the photon sphere"});
}

// Along the plane, in and out and round the hole: samples of a scale height, or shorter where it changes along the radius.
double gas_spans(const MediumSpec& m, double) {
    constexpr double kAcross = 0.2, kTrail = 0.128;  // SOFT_ACROSS and SOFT_RIM, SOFT_TRAIL of shaders/medium/gas.glsl
    const double across = kAcross * std::min(1.0, m.edge), trail = kTrail / std::max(m.gas.clumps.winding, 1e-3);
    const double sample = std::min({m.gas.thickness, across, trail});
    return 0.25 * (2.0 * std::log(m.outer / m.inner) / sample + kTurned / m.gas.thickness);
}

// In the plane, times the radius.
double opacity_in_plane(const MediumSpec& m) { return m.gas.optical_depth / (std::sqrt(2.0 * M_PI) * m.gas.thickness); }

std::vector<double> gas_values(const MediumFrame& f) {
    const MediumSpec& m = f.medium();
    const auto [first, second] = circular_rate_numbers(*f.plan.matter);
    const double sense = sign_of(sense_about(*f.plan.matter, m.gas.sense));
    return {m.inner,
            m.outer,
            std::log(m.inner),
            std::log(m.outer),
            m.gas.thickness,
            std::log2(m.temperature_K),
            1.0 / m.edge,
            1.0 / std::hypot(1.0, kGasHeights * m.gas.thickness),
            m.gas.clumps.contrast,
            sense * m.gas.clumps.winding / (2.0 * M_PI),
            m.gas.flow == DiscFlowKind::kKepler ? late_time(f.plan) : 0.0,
            first,
            second,
            sense};
}

}  // namespace

const MediumModel kGasModel{
    .word = "gas",
    .what = "a soft thick disc in circular orbits",
    .effect = {medium_effect(MediumKind::kGas),
               "medium-gas",
               "EFFECT_MEDIUM_GAS",
               "A soft disc of gas emits and absorbs light along rays.",
               "there is a [medium] of kind \"gas\"",
               "a march along each ray, in samples of up to 16 hashes",
               {Slot::kMedium, "medium/gas.glsl"}},
    .shares = kInner | kOuter | kEdge,
    .traits = {.own_steps = true, .azimuth = true},
    .keys = medium_gas_keys,
    .words = [](const MediumSpec& m) { return fmt::format("from {} to {}", m.inner, m.outer); },
    .farthest = [](const MediumSpec& m) { return m.outer * std::hypot(1.0, kGasHeights * m.gas.thickness); },
    .least_step =
        [](const MediumSpec& m) {
            constexpr double kLeastOfHeight = 0.1;  // of a disc's scale height at its inner rim
            return kLeastOfHeight * m.gas.thickness * m.inner;
        },
    .spans = gas_spans,
    .moves = [](const MediumSpec& m) { return m.gas.flow != DiscFlowKind::kStill ? "medium.flow" : nullptr; },
    .faults = gas_faults,
    .numbers =
        "GAS_INNER GAS_OUTER GAS_LOG_INNER GAS_LOG_OUTER GAS_THICKNESS GAS_HEAT GAS_RIM GAS_SURFACE GAS_CONTRAST "
        "GAS_WINDING GAS_TIME "
        "GAS_RATE GAS_RATE_CHARGE GAS_SENSE",
    .values = gas_values,
    .before =
        [](Scene& s) {
            s.spacetime.metric = "schwarzschild";
            s.light.shift = s.light.beaming = false;
        },
    .with = [](Scene& s) { s.medium.emplace(); },
    .opacity = opacity_in_plane,
};

}  // namespace nullscope
