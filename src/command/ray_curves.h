// Lists of rays as curves, what nullscope trace --points does (docs/ray-data.md, "Curves").
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "command/ray_trace.h"
#include "reference/ray_curve.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::cli {

using Curve = std::vector<reference::CurvePoint>;  // lengths in Spacetime::length_unit
inline constexpr int kMostCurvePoints = 100'000;   // of a ray
inline constexpr double kMostPointsInAll = 5e7;

struct CurveOutput {
    std::function<void(std::size_t ray, Curve&& curve)> take;  // empty: the ray has none
    std::function<void(long long rays)> done;                  // so many more; may throw
    std::function<Error(std::size_t ray, Error)> error;
};

// Lengths of spec: in Spacetime::length_unit. Errors: too many points in all; as trace_rays with the reference.
Status trace_curves(const Scene& scene, double length_unit, std::span<const RayQuery> rays,
                    const reference::CurveSpec& spec, const CurveOutput& output);

// (r, theta, phi) taken as flat spherical coordinates; in wormholes |l|.
Vec3 cartesian(const reference::CurvePoint& point);

// What is to be said of rays without a curve. Empty: nothing.
std::string no_curve_note(std::size_t without, std::size_t of, double farthest);

}  // namespace nullscope::cli
