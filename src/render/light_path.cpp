#include "render/light_path.h"

#include <fmt/format.h>

#include <cmath>

#include "observer/pose.h"
#include "render/frame_numbers.h"
#include "render/mino_path.h"
#include "render/planar_path.h"
#include "scene/leaning_disc.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

// Every method draws straight light, as none is compiled in.
constexpr double kLeastFrequency = 1e-6;  // as the shaders have it

DiscPlane plane_of(const FrameData& frame) {
    const auto vector = [](const FrameVector& v) { return Vec3{v.x, v.y, v.z}; };
    return {vector(frame.disc_x), vector(frame.disc_y), vector(frame.disc_normal)};
}

class StraightPath final : public LightPath {
public:
    Start start(const FramePlan& plan, const Mat3& world) const override {
        return {world, plan.straight() ? RadialFrame{} : plan.observer.frame};
    }
    void give(const FramePlan&, CoreInput& input) const override { input.lensing = false; }
    Status check(const Method& method, const FramePlan&) const override {
        return counts_steps(method) ? Status(rotating_only(method)) : Status(Done{});
    }
};

}  // namespace

// As frame_numbers() has the middle of a picture: in the ray's own meridian.
RayNumbers LightPath::ray_numbers(const FramePlan& plan, double theta, double phi, Vec3 n) const {
    const Mat3 world = world_from_static(theta, phi), shown = start(plan, world).axes;
    const Vec3 ahead = plan.observer.turn * n, radial{1, 0, 0};
    const double off_axis = std::hypot(ahead.y, ahead.z);
    const Vec3 meridian = off_axis > 0.0 ? Vec3{0, ahead.y, ahead.z} / off_axis : Vec3{0, 1, 0};
    const double critical_cosine = family() != nullptr ? family()->critical_cosine() : -1.0;
    const double critical_sine = family() != nullptr ? family()->critical_sine() : 0.0;
    return {{off_axis, 0, ahead.x, critical_sine * ahead.x - critical_cosine * off_axis},
            {world * radial, height_over(disc_plane_of(plan.scene), world * radial)},
            {world * meridian, 0},
            {direction_without_rounding(shown * ahead), 0}};
}

// shaders/planar/disc.glsl, disc_g
double LightPath::ray_g(const FramePlan& plan, const FrameData& frame, const RayNumbers& ray,
                        const ListedRay::Crossing& met, Vec3 u) const {
    const double sine = ray.start.x, energy = frame.shift.x + frame.shift.z * ray.start.z,
                 inverse_v = 1.0 / (frame.shift.y * energy);
    const Vec3 e{ray.radial.x, ray.radial.y, ray.radial.z}, m{ray.meridian.x, ray.meridian.y, ray.meridian.z};
    const double momentum = -sine * dot(cross(e, m), plane_of(frame).normal) * inverse_v;
    const double frequency = u.x - momentum * u.y - sine * inverse_v * met.climb * u.z;
    // Straight light starts in a frame at rest where there is no gravity.
    return 1.0 / (plan.straight() ? plan.observer.frame.energy() : 1.0) / energy /
           std::fmax(frequency, kLeastFrequency);
}

// shaders/planar/disc.glsl, disc_photon
PolarisedPhoton LightPath::photon_of(const FrameData& frame, const RayNumbers& ray, const ListedRay::Crossing& met,
                                     int) const {
    const double sine = ray.start.x, inverse_v = 1.0 / (frame.shift.y * (frame.shift.x + frame.shift.z * ray.start.z));
    const Vec3 e{ray.radial.x, ray.radial.y, ray.radial.z}, m{ray.meridian.x, ray.meridian.y, ray.meridian.z};
    const DiscPlane plane = plane_of(frame);
    const Vec3 momentum = -sine * inverse_v * cross(e, m), outward = normalized(plane.place(met.x, met.y));
    return {1.0, dot(momentum, plane.normal), sine * inverse_v * met.climb,
            -dot(cross(momentum, outward), plane.normal)};
}

std::unique_ptr<LightPath> make_light_path(const std::shared_ptr<const Spacetime>& light) {
    if (!light->bends_light()) return std::make_unique<StraightPath>();
    if (const AxialMetric* axial = light->axial())
        return std::make_unique<MinoPath>(std::shared_ptr<const AxialMetric>(light, axial));
    return std::make_unique<PlanarPath>(std::shared_ptr<const SphericalMetric>(light, light->spherical()));
}

bool has_method(const Spacetime& spacetime, const Method& method) {
    if (!spacetime.planar_rays()) return counts_steps(method);      // no table: nothing else
    const bool seen = spacetime.inner_end() == InnerEnd::kHorizon;  // others have rays to the inside to follow too
    switch (method.kind) {
        case MethodKind::kStrip: return true;
        case MethodKind::kTable: return seen && spacetime.spherical()->v_at_sky() == 0.0;  // its chi ends at pi
        case MethodKind::kClosedForm: return has_shader("method/closed_form", spacetime.name());
        case MethodKind::kIntegrate: return seen && has_shader("spacetime", spacetime.name());
        case MethodKind::kMino:
        case MethodKind::kKerrSchild: return false;
    }
    return false;
}

std::string methods_of(const Spacetime& spacetime) {
    std::string list = "strip, strip:cubic";
    for (const auto& [kind, name] : {std::pair{MethodKind::kTable, "table"},
                                     {MethodKind::kIntegrate, "integrate"},
                                     {MethodKind::kClosedForm, "closed-form"}})
        if (has_method(spacetime, Method{.kind = kind})) list += fmt::format(", {}", name);
    return list;
}

Error rotating_only(const Method& method) {
    return bad_input(fmt::format("method {} works for rotating holes only", method_name(method)), "auto");
}

}  // namespace nullscope
