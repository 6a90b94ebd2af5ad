// Where the rings of a disc lie: a disc may be warped, each ring in a plane of its own through the centre, and have gaps.
//
// The unit normal of the ring at r is N/|N|, N a cubic in ln r between two rows of DiscWarp through both normals, with the three-point slope at each row
// (what a parabola through it and its neighbours has) and level at the first and the last row, beyond which it does not change. So the surface
// n(r) . x = 0 has no crease, and equal rows are a plane.
#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "scene/disc_plane.h"
#include "scene/scene.h"

namespace nullscope {

inline constexpr double kMostWarpTilt_deg =
    170.0;  // of a ring from the disc's own plane, whose axes reach each ring by the shortest turn
// Between the normals of neighbouring rows, rad; and for each unit of ln r, so that both tracers find all meetings by their steps.
inline constexpr double kMostWarpTurn = 1.0471975511965976, kSteepestWarp = 4.0;

class DiscShape {
public:
    // Of a disc of scene files' checks, where a time of the scene has it. A row costs a sine and a cosine.
    DiscShape(const DiscSpec& disc, double time);
    // Axes that its table is along: right-handed, in world axes. A warped disc precesses as a body.
    const DiscPlane& base() const { return base_; }
    Vec3 normal_in_base(double r) const;  // unit; r > 0
    // Of the ring: x and y are the base's, turned by the shortest way.
    DiscPlane plane(double r) const;
    Vec3 normal(double r) const { return in_world(normal_in_base(r)); }
    // ln of the radius to the nearest end of a ring: above 0 on one, below 0 beside all.
    double within(double r) const;

    // Radii of the first and the last row; of a flat one none.
    double innermost() const { return rows_.empty() ? INFINITY : std::exp(rows_.front().x); }
    double outermost() const { return rows_.empty() ? 0.0 : std::exp(rows_.back().x); }

private:
    struct Row {
        double x;  // ln r
        Vec3 normal, slope;
    };
    Vec3 in_world(Vec3 v) const { return v.x * base_.x + v.y * base_.y + v.z * base_.normal; }

    DiscPlane base_;
    std::vector<Row> rows_;
    std::vector<double> ends_;  // ln r
};

inline bool disc_warps(const Scene& scene) { return scene.disc && scene.disc->warp.there(); }
// Nothing of a disc that is flat and has no gaps.
inline std::optional<DiscShape> disc_shape_of(const Scene& scene) {
    return disc_warps(scene) ? std::optional<DiscShape>(std::in_place, *scene.disc, scene.time) : std::nullopt;
}

}  // namespace nullscope
