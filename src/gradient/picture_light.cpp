#include "gradient/picture_light.h"

#include <algorithm>
#include <cmath>

#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr double kBeyondDisc = 1.01;  // of its rims, where rays that leave are let go

Vec3 colour_by(const Colour& colour, const Change& change) {
    return {derivative(colour[0], change), derivative(colour[1], change), derivative(colour[2], change)};
}

Shade luminance_of(const Colour& colour) {
    return 0.2126390059 * colour[0] + 0.7151686788 * colour[1] + 0.0721923154 * colour[2];
}

// By how much a view has to turn, rad.
double off_rim(const Number& r, double rim) {
    return std::fabs(r.value - rim) / std::hypot(r.d[kSeedAside], r.d[kSeedAcross]);
}

}  // namespace

Result<std::unique_ptr<Flow>> flow_of(const SpacetimeSpec& spacetime) {
    std::map<std::string, double> numbers = spacetime.parameters;
    if (const MetricEntry* entry = find_metric(spacetime.metric))
        for (const MetricParameter& parameter : entry->parameters) numbers.emplace(parameter.name, parameter.fallback);
    return make_flow(spacetime.metric, numbers, spacetime.parameters.formulas);
}

Result<std::unique_ptr<PictureLight>> PictureLight::make(const Scene& scene, const std::vector<std::string>& keys,
                                                         double tolerance) {
    std::unique_ptr<PictureLight> light(new PictureLight);
    light->scene_ = scene, light->tolerance_ = tolerance;
    TRY(flow, flow_of(scene.spacetime));
    light->flow_ = std::move(*flow);
    TRY(glow, DiscGlow::make(scene, *light->flow_));
    light->glow_ = std::move(*glow);
    TRY(parameters, parse_parameters(keys, scene, DerivativesOf::kLight));
    light->parameters_ = std::move(*parameters);
    TRY(view, CameraView::make(light->scene_, *light->flow_));
    light->view_ = *view;
    light->marks_ = light->glow_->marks();
    return light;
}

std::vector<double> PictureLight::mark_by(const LightMark& mark) const {
    std::vector<double> by;
    const LookedAlong any = looked_along({-1, 0, 0});
    for (const Parameter& key : parameters_)  // no mark depends on the view
        by.push_back(velocity_axis(key.kind) >= 0 ? 0.0 : derivative(mark, change_by(key.kind, any, scene_)));
    return by;
}

bool PictureLight::falls_in(double x, double y) const { return ray_survey(*flow_, view_->seen(x, y).launch).falls_in; }

PictureLight::Ray PictureLight::at(double x, double y, double along_x, double along_y) const {
    const CameraView::Seen seen = view_->seen(x, y);
    const DiscSpec& disc = *scene_.disc;
    const RayGradient found =
        ray_gradient(*flow_, seen.launch,
                     {disc.lean, scene_.time, kOrders, kBeyondDisc * disc.outer, disc.inner / kBeyondDisc, tolerance_});
    Ray ray;
    ray.off_edge = found.off_critical;
    Colour sum = {Shade(0.0), Shade(0.0), Shade(0.0)};
    std::vector<Shade> added(found.crossings.size(), Shade(0.0));
    Shade through(1.0);
    for (std::size_t k = 0; k < found.crossings.size(); ++k) {
        const RayGradient::Crossing& crossing = found.crossings[k];
        for (const double rim : {disc.inner, disc.outer})
            ray.off_edge = std::min(ray.off_edge, off_rim(crossing.r, rim));
        if (!glow_->within(crossing.r.value)) continue;
        const DiscGlow::Light light = glow_->at(found.photon, crossing, seen.shift);
        for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + through * light.colour[i];
        added[k] = through * luminance_of(light.colour);
        through = through * (1.0 - light.coverage);
    }
    ray.off_edge /= pixel_angle(scene_.camera, x, y);
    const Change along = view_->moved(seen, x, y, along_x, along_y);
    ray.light = {sum[0].value, sum[1].value, sum[2].value};
    for (std::size_t k = 0; k < found.crossings.size(); ++k) {
        const Number& r = found.crossings[k].r;
        ray.crossings.push_back(
            {{r.value, derivative(r, along), {}}, {added[k].value, derivative(added[k], along), {}}});
    }
    for (const Parameter& key : parameters_) {
        const Change change = view_->change(key.kind, seen);
        ray.by.push_back(colour_by(sum, change));
        for (std::size_t k = 0; k < found.crossings.size(); ++k) {
            ray.crossings[k].r.by.push_back(derivative(found.crossings[k].r, change));
            ray.crossings[k].luminance.by.push_back(derivative(added[k], change));
        }
    }
    return ray;
}

}  // namespace nullscope
