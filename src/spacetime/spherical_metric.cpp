#include "spacetime/spherical_metric.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace nullscope {

void require_chi(const char* metric, double r, double first) {
    if (r >= first) return;
    std::fprintf(stderr, "%s::chi_from_radius: r = %.17g is not >= %.17g\n", metric, r, first);
    std::abort();
}

double SphericalMetric::root_v(double r) const { return std::sqrt(lapse_squared(r)) / areal_radius(r); }

Matrix4 SphericalMetric::metric(double r, double theta) const {
    const double across = areal_radius(r), sine = std::sin(theta);
    Matrix4 g{};
    g[0][0] = -lapse_squared(r);
    g[1][1] = radial_stretch2(r);
    g[2][2] = across * across;
    g[3][3] = across * across * sine * sine;
    return g;
}

Matrix4 SphericalMetric::inverse_metric(double r, double theta) const {
    Matrix4 g = metric(r, theta);
    for (std::size_t i = 0; i < g.size(); ++i) g[i][i] = 1.0 / g[i][i];
    return g;
}

// By zeta = 1/r: d/dr = -zeta^2 d/dzeta.
std::optional<Equator> SphericalMetric::equator(double r) const {
    const OrbitEquation* orbit = orbit_equation();
    if (orbit == nullptr) return std::nullopt;
    const double zeta = 1.0 / r, z2 = zeta * zeta, a = lapse_squared(r), first = orbit->lapse_slope(zeta);
    const double second = z2 * zeta * (2.0 * first + zeta * orbit->lapse_curvature(zeta));
    return Equator{{-a, 0.0, r * r}, {z2 * first, 0.0, 2.0 * r}, {-second, 0.0, 2.0}, r * r * a, r * r};
}

}  // namespace nullscope
