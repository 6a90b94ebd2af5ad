#include "plan/sides.h"

#include <fmt/format.h>

#include "expr/formula.h"
#include "plan/body_kind.h"
#include "scene/bodies.h"
#include "scene/named_surface.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

using Faults = std::vector<SceneFault>;

constexpr double kFarthestBody = 1e5;  // throats: beyond, swept angles in float no longer tell places apart

void check_one_side(const Spacetime& spacetime, const Scene& scene, Faults& faults) {
    const auto without = [&](const std::string& key) {
        const bool formula = spacetime.name() == "formula";
        faults.push_back({key, fmt::format("metric \"{}\" has neither discs nor bodies", spacetime.name()),
                          formula ? "a hole without B and R, with one photon sphere and powers of 1/r far out"
                                  : "a scene without it, or another metric"});
    };
    if (scene.disc && !spacetime.can_have_disc()) without("disc");
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].far)
            faults.push_back({body_section(scene, i) + ".side",
                              fmt::format("metric \"{}\" has no far side", spacetime.name()), "near, or a wormhole"});
        if (!spacetime.can_have_bodies()) without(body_section(scene, i));
    }
}

void check_throat(const SurfaceSpec& surface, const std::string& section, double time, Faults& faults) {
    const auto shape = expr::Formula::parse(surface_shape(surface), {"x", "y", "z", "t"});
    const double throat[] = {0.0, 0.0, 0.0, time}, value = shape ? shape->value(throat) : 1.0;
    if (!(value > 0.0))
        faults.push_back({fmt::format("{}.{}", section, surface.kind == SurfaceKind::kFormula ? "shape" : "kind"),
                          fmt::format("reaches across the throat: f is {} at [0, 0, 0]", value), "f above 0 there"});
}

void check_distance(const Spacetime& spacetime, const Scene& scene, std::size_t i, Faults& faults) {
    const Body& body = scene.bodies[i];
    const double farthest = kind_of(body).extent(body).to, most = kFarthestBody * spacetime.spherical()->length_unit();
    const char* key = std::holds_alternative<BallSpec>(body.shape)       ? "position"
                      : std::holds_alternative<CylinderSpec>(body.shape) ? "outer"
                                                                         : "bound";
    if (farthest > most)
        faults.push_back({fmt::format("{}.{}", body_section(scene, i), key),
                          fmt::format("reaches as far as {:.6g} from so narrow a throat", farthest),
                          fmt::format("bodies within {:.6g} of it, or a wider throat", most)});
}

}  // namespace

std::vector<SceneFault> side_faults(const Spacetime& spacetime, const Scene& scene) {
    Faults faults;
    if (!spacetime.by_proper_length()) {
        check_one_side(spacetime, scene, faults);
        return faults;
    }
    if (scene.disc)
        faults.push_back({"disc", "no discs in a wormhole", "a [cylinder], which is a disc of finite thickness"});
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (std::holds_alternative<SphereSpec>(body.shape))
            faults.push_back({body_section(scene, i), "about the throat it would reach across it",
                              "a [ball], [cylinder] or [surface] on one side"});
        if (const auto* surface = std::get_if<SurfaceSpec>(&body.shape))
            check_throat(*surface, body_section(scene, i), scene.time, faults);
        check_distance(spacetime, scene, i, faults);
    }
    if (scene.bodies.empty()) return faults;
    if (!spacetime.can_have_bodies())
        faults.push_back({"spacetime.length",
                          fmt::format("{} is too long for bodies: rays wind in the tube",
                                      2.0 * spacetime.spherical()->tube_beyond(0.0)),
                          fmt::format("[0, {}] with bodies", 2.0 * SphericalMetric::kLongestHalfTube)});
    if (!scene.light.lensing)
        faults.push_back(
            {"light.lensing", "off, but straight rays do not pass through a throat", "on with bodies in a wormhole"});
    return faults;
}

Status check_sides(const Spacetime& spacetime, const Scene& scene) {
    const Faults faults = spacetime.by_proper_length() ? side_faults(spacetime, scene) : Faults{};
    if (faults.empty()) return Done{};
    const SceneFault& fault = faults.front();
    return bad_key(fault.key, fault.what, fault.allowed);
}

}  // namespace nullscope
