#include "command/ray_derivatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gradient/disc_glow.h"
#include "gradient/picture_light.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

constexpr double kNear = 0.1;        // of a pixel
constexpr double kAtHorizon = 1e-5;  // of its radius
constexpr double kFound = 1e-7;      // of the ray's own values

bool agree(double found, double known, double size) { return std::fabs(found - known) <= kFound * size; }

// Whether a view turned by so little meets the other side of this radius.
bool near_rim(const Number& r, double rim, double turn) {
    return std::fabs(r.value - rim) < turn * std::hypot(r.d[kSeedAside], r.d[kSeedAcross]);
}

}  // namespace

Result<DerivativeTracer> DerivativeTracer::make(const Scene& scene, const std::vector<std::string>& parameters,
                                                int crossings) {
    DerivativeTracer tracer;
    TRY(parsed, parse_parameters(parameters, scene));
    TRY(flow, flow_of(scene.spacetime));
    if (scene.disc && scene.disc->emission == DiscEmission::kThermal) {
        TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
        if ((*spacetime)->can_have_disc())
            tracer.motion_ =
                std::make_shared<DiscMotion>(**flow, sense_of(scene.disc->sense, **flow), scene.disc->lean);
    }
    tracer.scene_ = scene, tracer.parameters_ = std::move(*parsed), tracer.flow_ = std::move(*flow);
    tracer.crossings_ = crossings;
    return tracer;
}

std::vector<std::string> DerivativeTracer::columns() const {
    std::vector<std::string> columns;
    for (const Parameter& parameter : parameters_) {
        for (const char* name : {"x", "y", "z", "g", "delay"})
            columns.push_back(fmt::format("d_{}.{}", parameter.name, name));
        for (int k = 1; k <= crossings_; ++k)
            for (const char* name : {"r", "phi", "g"})
                if (motion_ || name[0] != 'g') columns.push_back(fmt::format("d_{}.{}_{}", parameter.name, name, k));
    }
    return columns;
}

Result<RayDerivatives> DerivativeTracer::derivatives(const RayQuery& ray, const RayRecord& record) const {
    if (ray.orbit || ray.frame != LocalFrame::kStatic)
        return bad_input("no derivatives of a ray given by q, zeta0, s or of an observer that falls",
                         "r, theta, phi, n_r, n_theta, n_phi with frame = static");
    const LookedAlong view = looked_along(ray.n);
    GradientTask task;
    if (scene_.disc) task.lean = scene_.disc->lean;
    task.time = scene_.time, task.crossings = crossings_;
    const RayGradient found = ray_gradient(*flow_, {ray.r, ray.theta, ray.phi, view}, task);
    RayDerivatives answer{state_of(found, record), {}};
    std::vector<Number> shifts;
    if (motion_)
        for (const RayGradient::Crossing& crossing : found.crossings)
            shifts.push_back(motion_->g(found.photon, crossing));
    const bool lost = answer.state == DerivativeState::kLost, sky = found.sky && std::isfinite(record.theta_inf);
    const auto put = [&](bool there, double value) { answer.values.push_back(there && !lost ? value : kNotANumber); };
    for (const Parameter& parameter : parameters_) {
        const Change by = change_by(parameter.kind, view, scene_);
        const Vec3 moved = sky ? derivative_of_direction(found.sky->direction, by) : Vec3{};
        put(sky, moved.x), put(sky, moved.y), put(sky, moved.z);
        put(true, derivative(found.g, by));
        put(sky && std::isfinite(record.delay), sky ? derivative(found.sky->delay, by) : 0.0);
        for (std::size_t k = 0; k < static_cast<std::size_t>(crossings_); ++k) {
            const bool there = k < std::min(record.crossings.size(), found.crossings.size()) &&
                               record.crossings[k].r * flow_->innermost() >= 1 + kAtHorizon;
            put(there, there ? derivative(found.crossings[k].r, by) : 0.0);
            put(there, there ? derivative_of_azimuth(found.crossings[k].phi, by) : 0.0);
            if (motion_) put(there, there ? derivative(shifts[k], by) : 0.0);
        }
    }
    return answer;
}

DerivativeState DerivativeTracer::state_of(const RayGradient& found, const RayRecord& record) const {
    const double turn = kNear * smallest_pixel_angle(scene_.camera);
    bool same = agree(found.g.value, record.g, std::fabs(record.g));
    if (std::isfinite(record.theta_inf)) {
        const auto& sky = found.sky;
        same = same && sky && agree(sky->direction[0].value, record.sky.x, 1) &&
               agree(sky->direction[1].value, record.sky.y, 1) && agree(sky->direction[2].value, record.sky.z, 1) &&
               (!std::isfinite(record.delay) || agree(sky->delay.value, record.delay, 1 + std::fabs(record.delay)));
    }
    bool edge = found.off_critical < turn;
    const std::size_t crossings = std::min(record.crossings.size(), static_cast<std::size_t>(crossings_));
    for (std::size_t k = 0; same && k < crossings; ++k) {
        // Next to the horizon rays about a rotating hole cross a leaning plane without end.
        if (record.crossings[k].r * flow_->innermost() < 1 + kAtHorizon) {
            edge = true;
            break;
        }
        same = k < found.crossings.size();
        if (!same) break;
        const Number& r = found.crossings[k].r;
        same = agree(r.value, record.crossings[k].r, record.crossings[k].r);
        edge =
            edge || (scene_.disc && (near_rim(r, scene_.disc->inner, turn) || near_rim(r, scene_.disc->outer, turn)));
    }
    return !same ? DerivativeState::kLost : edge ? DerivativeState::kEdge : DerivativeState::kThere;
}

}  // namespace nullscope::cli
