#include "scene/disc_shape.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kShapeDegree = M_PI / 180.0;

// As disc_plane() has it.
Vec3 warp_normal(double tilt, double node) {
    const double up = std::sin(tilt);
    return {up * std::sin(node), -up * std::cos(node), std::cos(tilt)};
}

// Turned by `angle` in its own plane.
DiscPlane turned_plane(const DiscPlane& plane, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * plane.x + s * plane.y, c * plane.y - s * plane.x, plane.normal};
}

}  // namespace

DiscShape::DiscShape(const DiscSpec& disc, double time) : base_(disc_plane(disc.lean, time)) {
    const DiscWarp& warp = disc.warp;
    if (warp.bends() && disc.lean.precession != 0.0) base_ = turned_plane(base_, disc.lean.precession * time);
    for (std::size_t i = 0; i < warp.radii.size(); ++i)
        rows_.push_back({std::log(warp.radii[i]),
                         warp_normal(kShapeDegree * warp.tilts_deg[i], kShapeDegree * warp.nodes_deg[i]),
                         {0, 0, 0}});
    for (std::size_t i = 1; i + 1 < rows_.size(); ++i) {
        const Row &a = rows_[i - 1], &b = rows_[i + 1];
        Row& row = rows_[i];
        const double before = row.x - a.x, after = b.x - row.x;
        row.slope =
            (after / before * (row.normal - a.normal) + before / after * (b.normal - row.normal)) / (before + after);
    }
    const std::vector<double> whole = {disc.inner, disc.outer};
    for (const double r : warp.rings.empty() ? whole : warp.rings) ends_.push_back(std::log(r));
}

Vec3 DiscShape::normal_in_base(double r) const {
    if (rows_.empty()) return {0, 0, 1};
    const double x = std::log(r);
    if (!(x > rows_.front().x)) return rows_.front().normal;
    if (!(x < rows_.back().x)) return rows_.back().normal;
    const auto above = std::ranges::upper_bound(rows_, x, {}, &Row::x);
    const Row &a = *(above - 1), &b = *above;
    const double h = b.x - a.x, t = (x - a.x) / h, u = 1.0 - t;
    return normalized(u * u * ((1.0 + 2.0 * t) * a.normal + (h * t) * a.slope) +
                      t * t * ((1.0 + 2.0 * u) * b.normal - (h * u) * b.slope));
}

DiscPlane DiscShape::plane(double r) const {
    const Vec3 n = normal_in_base(r), both{n.x, n.y, n.z + 1.0};
    const double x = n.x / both.z, y = n.y / both.z;
    return {in_world({1.0 - x * both.x, -x * both.y, -x * both.z}),
            in_world({-y * both.x, 1.0 - y * both.y, -y * both.z}), in_world(n)};
}

double DiscShape::within(double r) const {
    const double x = std::log(r);
    double nearest = INFINITY;
    bool on = false;
    for (const double end : ends_) {
        if (x >= end) on = !on;
        nearest = std::min(nearest, std::fabs(x - end));
    }
    return on || nearest == 0.0 ? nearest : -nearest;
}

}  // namespace nullscope
