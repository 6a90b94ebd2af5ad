#include "scene/sides.h"

#include <fmt/format.h>

#include "expr/formula.h"
#include "scene/named_surface.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

using Faults = std::vector<SideFault>;

void check_one_side(const Spacetime& spacetime, const Scene& scene, Faults& faults) {
    const auto check = [&](const char* key, bool far) {
        if (far)
            faults.push_back(
                {key, fmt::format("metric \"{}\" has no far side", spacetime.name()), "near, or a wormhole"});
    };
    if (scene.cylinder) check("cylinder.side", scene.cylinder->far);
    if (scene.ball) check("ball.side", scene.ball->far);
    if (scene.surface) check("surface.side", scene.surface->far);
}

}  // namespace

std::vector<SideFault> side_faults(const Spacetime& spacetime, const Scene& scene) {
    Faults faults;
    if (!spacetime.by_proper_length()) {
        check_one_side(spacetime, scene, faults);
        return faults;
    }
    if (scene.disc)
        faults.push_back({"disc", "no discs in a wormhole", "a [cylinder], which is a disc of finite thickness"});
    if (scene.sphere)
        faults.push_back(
            {"sphere", "about the throat it would reach across it", "a [ball], [cylinder] or [surface] on one side"});
    if (!scene.cylinder && !scene.ball && !scene.surface) return faults;
    if (!spacetime.can_have_bodies())
        faults.push_back({"spacetime.length",
                          fmt::format("{} is too long for bodies: rays wind in the tube",
                                      2.0 * spacetime.spherical()->tube_beyond(0.0)),
                          fmt::format("[0, {}] with bodies", 2.0 * SphericalMetric::kLongestHalfTube)});
    if (!scene.light.lensing)
        faults.push_back({"light.lensing", "off, but straight light passes no throat", "on with bodies in a wormhole"});
    if (scene.surface) {
        const auto shape = expr::Formula::parse(surface_shape(*scene.surface), {"x", "y", "z", "t"});
        const double throat[] = {0.0, 0.0, 0.0, scene.time};
        const double value = shape ? shape->value(throat) : 1.0;
        if (!(value > 0.0))
            faults.push_back({scene.surface->kind == SurfaceKind::kFormula ? "surface.shape" : "surface.kind",
                              fmt::format("reaches across the throat: f is {} at [0, 0, 0]", value),
                              "f above 0 there"});
    }
    return faults;
}

Status check_sides(const Spacetime& spacetime, const Scene& scene) {
    const Faults faults = spacetime.by_proper_length() ? side_faults(spacetime, scene) : Faults{};
    if (faults.empty()) return Done{};
    const SideFault& fault = faults.front();
    return bad_input(fmt::format("{}: {}; allowed: {}", fault.key, fault.what, fault.allowed));
}

}  // namespace nullscope
