#include "studio/embedding.h"

#include <algorithm>
#include <cmath>

namespace nullscope::viewer {
namespace {

constexpr int kCircles = 240;
constexpr double kRounding = 1e-9;  // of B - R'^2

double areal_slope(const SphericalMetric& metric, double r, double step) {
    if (metric.by_proper_length()) return metric.radius_slope(r);
    return (metric.areal_radius(r + step) - metric.areal_radius(r - step)) / (2.0 * step);
}

}  // namespace

// In equal steps of s, r = low + s^2 s: of a horizon's singular B nothing is left in dz/ds.
std::vector<EmbeddedCircle> embedding(const SphericalMetric& metric, double high) {
    const bool two_sides = metric.by_proper_length();
    const double low =
        two_sides ? -high : std::max(metric.horizon_radius().value_or(0.0), metric.surface_radius().value_or(0.0));
    high = std::min(high, metric.camera_range().high);
    if (!(high > low)) return {};
    const double end = two_sides ? high - low : std::sqrt(high - low), step = end / kCircles;
    const auto place = [&](double s) { return low + (two_sides ? s : s * s); };
    std::vector<EmbeddedCircle> surface{{high, metric.areal_radius(high), 0.0}};
    for (int i = kCircles; i-- > 0;) {
        const double s = (i + 0.5) * step, r = place(s), stretch = two_sides ? 1.0 : 2.0 * s;
        const double slope = areal_slope(metric, r, 1e-3 * (r - low)),
                     rise2 = metric.radial_stretch2(r) - slope * slope;
        if (!(rise2 > -kRounding) || !std::isfinite(rise2)) break;
        const double inner = place(i * step),
                     z = surface.back().z - (rise2 > kRounding ? std::sqrt(rise2) : 0.0) * stretch * step;
        surface.push_back({inner, metric.areal_radius(inner), z});
    }
    std::ranges::reverse(surface);
    const double ground = two_sides ? height_at(surface, 0.0).value_or(0.0) : surface.front().z;
    for (EmbeddedCircle& circle : surface) circle.z -= ground;
    return surface;
}

std::optional<double> height_at(const std::vector<EmbeddedCircle>& surface, double r) {
    if (surface.size() < 2 || r < surface.front().r || r > surface.back().r) return std::nullopt;
    const auto above = std::ranges::lower_bound(surface.begin() + 1, surface.end() - 1, r, {}, &EmbeddedCircle::r);
    const EmbeddedCircle &a = *(above - 1), &b = *above;
    return std::lerp(a.z, b.z, (r - a.r) / (b.r - a.r));
}

}  // namespace nullscope::viewer
