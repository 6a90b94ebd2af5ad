// A hot flow about the hole (Gold et al. 2020).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "plan/medium_model.h"
#include "scene/medium_bands.h"

namespace nullscope {
namespace {

bool is_flow(const Scene& s) { return s.medium->kind == MediumKind::kFlow; }
constexpr std::string_view kFlow = "kind = \"flow\"";

std::vector<SceneKey> flow_keys() {
    return {
        {"medium", "radius", KeyType::kNumber, "r_s", "5", kPositive, "",
         "Radius at which the density of a flow has fallen to exp(-1/2). Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->flow.radius; }, is_flow, kFlow},
        {"medium", "flattening", KeyType::kNumber, "", "0", closed(0.0, 1000.0), "",
         "The density of a flow falls off from the equatorial plane as exp(-(flattening cos theta)^2/2); 0 is a "
         "sphere. Needs kind = \"flow\".",
         [](auto& s) { return &s.medium->flow.flattening; }, is_flow, kFlow},
        {"medium", "angular_momentum", KeyType::kNumber, "", "1", closed(-1.0, 1.0), "",
         "l0 of the matter's angular momentum over energy, l = l0 R^1.5/(1 + R), R = r sin(theta) in M; 0: none. Needs "
         "kind = \"flow\".",
         [](auto& s) { return &s.medium->flow.momentum; }, is_flow, kFlow},
    };
}

// Along the plane, in and out and round the hole, in samples of flow.glsl; and across its scales, here and there.
double flow_spans(const MediumSpec& m, double horizon) {
    constexpr double kInward = 0.1, kStep = 0.25, kLonger = 10.0;
    constexpr double kCrossings = 4.0;
    constexpr double kNearest = 1e-4;  // of the radius: rays that come nearer are thinner than a pixel
    const double farthest = kFlowScales * m.flow.radius, from = std::max(horizon, kNearest * m.flow.radius);
    const double sample = std::min(kInward, kLonger * kStep / std::max(m.flow.flattening, 1.0));
    const double in_and_out = 2.0 * std::max(std::log(farthest / from), 0.0);
    return 0.25 * ((in_and_out + kTurned) / sample + 2.0 * kFlowScales / kStep * (1.0 + kCrossings)) +
           (horizon > 0.0 ? spans_to_horizon() : 0.0);
}

}  // namespace

const MediumModel kFlowModel{
    .word = "flow",
    .what = "a hot flow about the hole",
    .effect = {medium_effect(MediumKind::kFlow),
               "medium-flow",
               "EFFECT_MEDIUM_FLOW",
               "A hot flow about the hole emits and absorbs light along rays.",
               "there is a [medium] of kind \"flow\"",
               "a march along each ray, in samples of two exponentials",
               {Slot::kMedium, "medium/flow.glsl"}},
    .shares = kDensityScale | kLaws | kWarmth,
    .traits = {},
    .keys = flow_keys,
    .words =
        [](const MediumSpec& m) {
            return fmt::format("of radius {}{}", m.flow.radius,
                               m.by_frequency() ? fmt::format(" at {}", frequency_words(m)) : "");
        },
    .farthest = [](const MediumSpec& m) { return kFlowScales * m.flow.radius; },
    .least_step = nullptr,
    .spans = flow_spans,
    .moves = nullptr,
    .faults = nullptr,
    .numbers = "FLOW_SCALE FLOW_FLATTENING FLOW_MOMENTUM FLOW_DENSITY FLOW_FARTHEST",
    .values = [](const MediumFrame& f) -> std::vector<double> {
        const MediumSpec& m = f.medium();
        const double scale =
            m.law() == MediumEmission::kPowerLaw ? 1.0 : m.density_scale;  // of power laws law_numbers() has it
        return {1.0 / m.flow.radius, m.flow.flattening, m.flow.momentum, scale, kFlowScales * m.flow.radius};
    },
    .before = massive_hole,
    .with = [](Scene& s) { s.medium.emplace().kind = MediumKind::kFlow; },
};

}  // namespace nullscope
