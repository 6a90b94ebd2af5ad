#include "command/ray_curves.h"

#include <fmt/format.h>

#include <cmath>

namespace nullscope::cli {

Status trace_curves(const Scene& scene, double length_unit, std::span<const RayQuery> rays,
                    const reference::CurveSpec& spec, const CurveOutput& output) {
    if (static_cast<double>(rays.size()) * spec.points > kMostPointsInAll)
        return bad_input(fmt::format("{} rays of {} points are too many", rays.size(), spec.points),
                         fmt::format("{:g} points in all", kMostPointsInAll));
    TRY(tracer, reference::CurveTracer::make(scene));
    reference::CurveSpec asked{spec.points, spec.farthest * length_unit, spec.to_r, spec.to_theta, spec.to_mino};
    if (asked.to_r) *asked.to_r *= length_unit;
    if (asked.to_mino) *asked.to_mino /= length_unit;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        auto curve = tracer->curve(rays[i], asked);
        if (!curve) return output.error(i, curve.error());
        if (length_unit != 1)
            for (reference::CurvePoint& point : *curve) {
                point.affine /= length_unit, point.r /= length_unit, point.t /= length_unit;
                point.theta_rate *= length_unit, point.phi_rate *= length_unit;
            }
        output.take(i, std::move(*curve));
        output.done(1);
    }
    return Done{};
}

Vec3 cartesian(const reference::CurvePoint& point) {
    const double r = std::abs(point.r), across = r * std::sin(point.theta);
    return {across * std::cos(point.phi), across * std::sin(point.phi), r * std::cos(point.theta)};
}

std::string no_curve_note(std::size_t without, std::size_t of, double farthest) {
    if (without == 0) return {};
    return fmt::format(
        "{} of {} rays have no curve: they do not come within r = {:g}, end nowhere, or have no positive energy",
        without, of, farthest);
}

}  // namespace nullscope::cli
