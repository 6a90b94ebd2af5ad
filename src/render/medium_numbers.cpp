#include "render/medium_numbers.h"

#include <algorithm>
#include <array>

#include "plan/medium.h"
#include "plan/medium_model.h"

namespace nullscope {
namespace {

// In the order of their names, four to a vector.
template <std::size_t count>
void put_in_order(const std::array<FrameVector*, count>& vectors, std::vector<double> values) {
    values.resize(4 * count);
    for (std::size_t i = 0; i < count; ++i)
        *vectors[i] = {values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]};
}

// Of black and white in a picture of brightness temperatures, for effect/edge.glsl: brightness, colour and exposure are for the eye, and a flux
// does not depend on them.
constexpr double kFluxExposure = 0.1;
double edge_exposure(const Scene& scene, const MediumSpec& medium) {
    const bool alone = scene.sky.kind == SkyKind::kBlack && !scene.disc && scene.bodies.empty();
    const double light = medium.brightness * std::max({medium.colour.x, medium.colour.y, medium.colour.z});
    return medium.by_frequency() && alone && light > 0 ? kFluxExposure / light : 0.0;
}

// What of the light behind comes through where no more is looked for, of what is as bright as the matter; less of what is brighter. Samples
// of gas cost most.
double least_through(const Scene& scene, const MediumModel& model) {
    constexpr double kLeast = 1e-6, kLeastOfGas = 1e-4, kNone = 1e-20;
    double behind = scene.sky.kind == SkyKind::kBlack ? 0.0 : scene.sky.brightness;
    if (scene.disc) behind = std::max(behind, scene.disc->brightness);
    for (const SpotSpec& spot : scene.spots) behind = std::max(behind, spot.brightness);
    for (const Body& body : scene.bodies) behind = std::max(behind, body.material.brightness);
    const double share = std::min(1.0, scene.medium->brightness / std::max(behind, kNone));
    return std::max(share * (model.traits.own_steps ? kLeastOfGas : kLeast), kNone);
}

}  // namespace

void put_medium(FrameData& frame, const FramePlan& plan, const MediumGrid* grid) {
    const auto& medium = plan.scene.medium;
    const auto hole = medium ? medium_hole(*plan.matter) : std::nullopt;
    if (!hole) return;
    const MediumModel& model = model_of(*medium);
    const double farthest = model.farthest(*medium),
                 least = model.least_step != nullptr ? model.least_step(*medium) : kLeastStep * farthest;
    frame.medium_hole = {hole->a, hole->outer, hole->inner,
                         hole->outer > 0.0 ? hole->outer + kMediumAboveHorizon : -1.0};
    // Samples that begin or end beyond a sphere have a part within it.
    const bool ends_sharply = (model.shares & kSphere) != 0;
    const double beyond = ends_sharply ? 2.0 * medium->step * medium->outer / medium->steps : 0.0;
    frame.medium_bound = {farthest + beyond, least, medium->step, edge_exposure(plan.scene, *medium)};
    const LawNumbers law = law_numbers(plan);
    frame.medium_colour = {law.light * medium->colour, least_through(plan.scene, model)};
    put_in_order<3>({&frame.medium_law_0, &frame.medium_law_1, &frame.medium_law_2}, law.values);
    const std::array<FrameVector*, 3> bands = {&frame.medium_band_0, &frame.medium_band_1, &frame.medium_band_2};
    for (std::size_t i = 0; i < law.bands.size() && i < bands.size(); ++i)
        *bands[i] = {law.bands[i][0], law.bands[i][1], law.bands[i][2], law.bands[i][3]};
    put_in_order<6>({&frame.medium_form_0, &frame.medium_form_1, &frame.medium_form_2, &frame.medium_form_3,
                     &frame.medium_form_4, &frame.medium_form_5},
                    model.values({plan, grid}));
}

}  // namespace nullscope
