// Minkowski: A = 1, light runs straight.
#pragma once
#include "spacetime/spherical_metric.h"

namespace nullscope {

class Minkowski final : public SphericalMetric, public OrbitEquation {
public:
    std::string_view name() const override { return "minkowski"; }
    double lapse_squared(double) const override { return 1.0; }
    bool bends_light() const override { return false; }
    const OrbitEquation* orbit_equation() const override { return this; }
    double half_v_slope(double zeta) const override { return zeta; }
    double half_v_curvature(double) const override { return 1.0; }
    double lapse_slope(double) const override { return 0.0; }
    double lapse_curvature(double) const override { return 0.0; }
};

}  // namespace nullscope
