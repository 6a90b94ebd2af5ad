#include "render/medium_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/black_body.h"
#include "plan/medium.h"
#include "render/body_numbers.h"
#include "scene/known_object.h"

namespace nullscope {
namespace {

// Steps of the march, at least: of a flow's farthest matter, and of a disc's scale height at its inner rim.
constexpr double kLeastStep = 1e-6, kLeastOfHeight = 0.1;

constexpr double kMostLight = 1e30;
// Of what may be 0: far below all that counts.
double logarithm(double number) { return std::log2(std::max(number, 1e-300)); }

// Powers of the frequency by which light that is seen with its frequency times g differs, and by which its intensity does.
struct Seen {
    double shift, beaming;
};
Seen seen_light(const LightSpec& light) { return {light.shift ? 1.0 : 0.0, light.beaming ? 3.0 : 0.0}; }

// Powers of g in g^3 j(nu/g) dlambda/g and alpha(nu/g) dlambda/g of a power law.
std::array<double, 2> powers_of_g(const LightSpec& light, double spectral_index) {
    const auto [shift, beaming] = seen_light(light);
    return {beaming + shift * spectral_index - 1.0, shift * (2.5 + spectral_index) - 1.0};
}

void put_flow(FrameData& frame, const FramePlan& plan, const MediumSpec& medium) {
    const FlowNumbers flow = flow_numbers(medium, plan.scene.object.mass().value_or(0.0));
    // Where it is opaque beyond what has room in a float it is as bright.
    const double most = std::max({flow.absorption, flow.emission * medium.brightness, kMostLight}) / kMostLight;
    frame.medium_colour = {medium.brightness * flow.emission / most * medium.colour, 0};
    frame.medium_flow = {1.0 / medium.radius, medium.flattening, medium.momentum, flow.absorption / most};
    const auto [emission, absorption] = powers_of_g(plan.scene.light, medium.spectral_index);
    frame.medium_powers = {emission, absorption, 0, 0};
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
                              medium.flow == DiscFlowKind::kKepler ? late_time(plan) : 0.0, 0};
    frame.medium_gas_orbit = {first, second, 0, 0};
}

void put_emission(FrameData& frame, const FramePlan& plan, const MediumSpec& medium) {
    const LightSpec& light = plan.scene.light;
    const double mass = plan.scene.object.mass().value_or(0.0);
    const auto [shift, beaming] = seen_light(light);
    frame.medium_extent = {medium.outer, medium.height, 2.0 * medium.outer / medium.steps, late_time(plan)};
    frame.medium_colour = {medium.brightness * medium.colour, 0};
    frame.medium_seen = {shift, beaming, 0, 0};
    switch (medium.emission) {
        case MediumEmission::kPowerLaw: {
            const FlowNumbers flow = flow_numbers(medium, mass);
            const auto [emission, absorption] = powers_of_g(light, medium.spectral_index);
            frame.medium_law = {emission, absorption, logarithm(flow.absorption), logarithm(flow.emission)};
            break;
        }
        case MediumEmission::kBlackBody:
            frame.medium_law = {log2_brightness(medium.temperature_K, light.bolometric), medium.opacity, 0, 0};
            break;
        case MediumEmission::kSynchrotron:
            frame.medium_law = {
                medium.frequency_GHz,
                std::log2(1e-20 * 100.0 * schwarzschild_radius_m(mass) / medium_light_cgs(medium.frequency_GHz)),
                -std::log2(kMediumLight_K), 0};
            break;
    }
}

void put_grid(FrameData& frame, const MediumSpec& medium, const MediumGrid& grid) {
    const auto &rings = grid.rings(), &polar = grid.polar(), &around = grid.around();
    frame.medium_grid = {rings.first, 1.0 / rings.step, polar.first, 1.0 / polar.step};
    frame.medium_nodes = {static_cast<double>(rings.count), static_cast<double>(polar.count),
                          static_cast<double>(around.count), grid.kerr_schild() ? 1.0 : 0.0};
    frame.medium_scale = {around.first / (2.0 * M_PI), medium.density_scale, std::sqrt(medium.density_scale),
                          grid.horizon()};
}

// Of black and white in a picture of brightness temperatures, for effect/edge.glsl: brightness, colour and exposure are for the eye, and a flux
// does not depend on them.
constexpr double kFluxExposure = 0.1;
double edge_exposure(const Scene& scene, const MediumSpec& medium) {
    const bool alone = scene.sky.kind == SkyKind::kBlack && !scene.disc && scene.bodies.empty();
    const double light = medium.brightness * std::max({medium.colour.x, medium.colour.y, medium.colour.z});
    return medium.by_frequency() && alone && light > 0 ? kFluxExposure / light : 0.0;
}

}  // namespace

void put_medium(FrameData& frame, const FramePlan& plan, const MediumGrid* grid) {
    const auto& medium = plan.scene.medium;
    const auto hole = medium ? medium_hole(*plan.matter) : std::nullopt;
    if (!hole) return;
    const double farthest = medium_farthest(*medium);
    const double least =
        medium->kind == MediumKind::kGas ? kLeastOfHeight * medium->thickness * medium->inner : kLeastStep * farthest;
    frame.medium_hole = {hole->a, hole->outer, hole->inner,
                         hole->outer > 0.0 ? hole->outer + kMediumAboveHorizon : -1.0};
    // Samples that begin or end beyond a sphere have a part within it.
    const double beyond = medium->by_place() ? 2.0 * medium->step * medium->outer / medium->steps : 0.0;
    frame.medium_bound = {farthest + beyond, least, medium->step, edge_exposure(plan.scene, *medium)};
    if (medium->by_place()) put_emission(frame, plan, *medium);
    if (medium->kind == MediumKind::kGrid && grid != nullptr) put_grid(frame, *medium, *grid);
    if (medium->kind == MediumKind::kFlow) put_flow(frame, plan, *medium);
    if (medium->kind == MediumKind::kGas) put_gas(frame, plan, *medium);
}

}  // namespace nullscope
