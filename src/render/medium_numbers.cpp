#include "render/medium_numbers.h"

#include <cmath>

#include "light/black_body.h"
#include "plan/medium.h"
#include "render/body_numbers.h"

namespace nullscope {
namespace {

// Steps of the march, at least: of a flow's farthest matter, and of a disc's scale height at its inner rim.
constexpr double kLeastStep = 1e-6, kLeastOfHeight = 0.1;

void put_flow(FrameData& frame, const FramePlan& plan, const MediumSpec& medium) {
    const FlowNumbers flow = flow_numbers(medium, plan.scene.object.mass().value_or(0.0));
    frame.medium_colour = {medium.brightness * flow.emission * medium.colour, 0};
    frame.medium_flow = {1.0 / medium.radius, medium.flattening, medium.momentum, flow.absorption};
    // g^3 j(nu/g) dlambda/g and alpha(nu/g) dlambda/g.
    const double spectrum = plan.scene.light.shift ? 1.0 : 0.0, beaming = plan.scene.light.beaming ? 3.0 : 0.0;
    frame.medium_powers = {beaming + spectrum * medium.spectral_index - 1.0,
                           spectrum * (2.5 + medium.spectral_index) - 1.0, 0, 0};
}

void put_gas(FrameData& frame, const FramePlan& plan, const MediumSpec& medium) {
    const auto [first, second] = circular_rate_numbers(*plan.matter);
    frame.medium_colour = {medium.brightness * medium.colour, 0};
    frame.medium_gas = {medium.inner, medium.outer, medium.thickness,
                        medium.optical_depth / (std::sqrt(2.0 * M_PI) * medium.thickness)};
    frame.medium_gas_heat = {std::log2(medium.temperature_K),
                             log2_brightness(medium.temperature_K, plan.scene.light.bolometric), 1.0 / medium.edge,
                             1.0 / std::hypot(1.0, kGasHeights * medium.thickness)};
    frame.medium_gas_noise = {medium.gas.contrast, medium.gas.winding / (2.0 * M_PI),
                              medium.flow == DiscFlowKind::kKepler ? plan.scene.time : 0.0, 0};
    frame.medium_gas_orbit = {first, second, 0, 0};
}

}  // namespace

void put_medium(FrameData& frame, const FramePlan& plan) {
    const auto& medium = plan.scene.medium;
    const auto hole = medium ? medium_hole(*plan.matter) : std::nullopt;
    if (!hole) return;
    const double farthest = medium_farthest(*medium);
    const double least =
        medium->kind == MediumKind::kGas ? kLeastOfHeight * medium->thickness * medium->inner : kLeastStep * farthest;
    frame.medium_hole = {hole->a, hole->outer, hole->inner, hole->outer + kMediumAboveHorizon};
    frame.medium_bound = {farthest, least, medium->step, 0};
    if (medium->kind == MediumKind::kFlow) put_flow(frame, plan, *medium);
    if (medium->kind == MediumKind::kGas) put_gas(frame, plan, *medium);
}

}  // namespace nullscope
