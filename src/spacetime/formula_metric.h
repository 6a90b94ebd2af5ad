// A static spherical hole given by formulas: A, B and R of a scene file (metric_formulas.h).
//
// With zeta = 1/r, V = A/R^2, v_s = V(0) = -Lambda/3, V_c at the photon sphere:
//     V - v_s = (V_c - v_s) sin^2(chi),  h = sqrt(A B) (r/R)^2 2 (V - v_s)^(1/2) (V_c - V)^(1/2) / ((V_c - v_s)^(1/2) dV/dzeta).
// What cancels is taken from an expansion (metric_formulas.h) about the place where it vanishes: V - v_s far out and at the end, V_c - V
// about the photon sphere, A at the horizon.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "base/result.h"
#include "numeric/inverse_map.h"
#include "spacetime/formula_places.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

class FormulaMetric final : public SphericalMetric, public ChiMap, public OrbitEquation {
public:
    // Errors: no static spherical metric with a horizon and one photon sphere; of the key of one formula.
    static Result<std::shared_ptr<const Spacetime>> make(const std::map<std::string, std::string>& texts);

    std::string_view name() const override { return "formula"; }
    double lapse_squared(double r) const override;
    double areal_radius(double r) const override { return formulas_.areal_radius(r); }
    double radial_stretch2(double r) const override {
        return formulas_.tilted() ? formulas_.stretch2(r) : 1.0 / lapse_squared(r);
    }
    RadiusRange camera_range() const override;
    RadiusRange falling_range() const override;
    std::optional<double> horizon_radius() const override { return 1.0 / places_.horizon; }
    std::optional<PhotonSphere> photon_sphere() const override { return PhotonSphere{1.0 / places_.photon, q_crit_}; }
    double v_at_sky() const override { return places_.v_at_sky; }
    const ChiMap* chi() const override { return this; }
    const OrbitEquation* orbit_equation() const override { return formulas_.tilted() ? nullptr : this; }
    bool can_have_disc() const override { return stable_orbits_; }
    double chi_from_radius(double r) const override;  // r from its end on; aborts elsewhere
    double radius_from_chi(double chi) const override { return 1.0 / zeta_from_chi(chi); }
    double bending_density(double chi) const override;
    double half_v_slope(double zeta) const override;
    double half_v_curvature(double zeta) const override;
    double lapse_slope(double zeta) const override;
    double lapse_curvature(double zeta) const override;

private:
    static Result<std::shared_ptr<const Spacetime>> of_formulas(const std::map<std::string, std::string>& texts);
    FormulaMetric(MetricFormulas formulas, const FormulaPlaces& places);
    // off_end: zeta - places_.end, which keeps its digits there.
    double root_above(double zeta, double off_end) const;  // sqrt(V - v_s)
    double root_below(double zeta) const;                  // sqrt(V_c - V), below 0 behind the photon sphere
    double rate(double zeta) const;                        // dzeta/dchi
    double chi_of(double zeta, double off_end) const;
    double zeta_from_chi(double chi) const;
    bool far(double zeta) const;
    double innermost() const;

    MetricFormulas formulas_;
    FormulaPlaces places_;
    Expansion scaled_lapse_far_, v_far_, density_far_, about_photon_, at_end_, at_horizon_;
    PotentialPanels panels_;
    double v_crit_ = 0.0, q_crit_ = 0.0, root_range_ = 0.0;  // sqrt(V_c - v_s)
    double innermost_ = 0.0;                                 // of cameras that fall
    bool stable_orbits_ = false;
    InverseMap zeta_of_;
};

}  // namespace nullscope
