// Minkowski: A = 1, light runs straight. There is no photon sphere, so the angle chi does not exist: asking for it
// aborts.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "spacetime/spacetime.h"

namespace nullscope {

class Minkowski final : public Spacetime {
public:
    std::string_view name() const override { return "minkowski"; }
    double lapse_squared(double) const override { return 1.0; }
    std::optional<double> horizon_radius() const override { return std::nullopt; }
    std::optional<PhotonSphere> photon_sphere() const override { return std::nullopt; }
    bool bends_light() const override { return false; }
    double chi_from_radius(double r) const override;
    double radius_from_chi(double chi) const override;
    double bending_density(double chi) const override;
    double half_v_slope(double zeta) const override { return zeta; }
    double half_v_curvature(double) const override { return 1.0; }
};

std::unique_ptr<Spacetime> make_minkowski(const std::map<std::string, double>& parameters);

}  // namespace nullscope
