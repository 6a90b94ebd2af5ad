#include "render/light_path.h"

#include <fmt/format.h>

#include "render/mino_path.h"
#include "render/planar_path.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

// Every method draws straight light, as none is compiled in.
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
