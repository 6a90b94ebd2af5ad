// A metric given by formulas that is not a hole in space that is flat far out (formula_metric.h): without horizon, with a double zero of A,
// in isotropic coordinates, without a limit far out, or a wormhole. Its rays are followed by quadrature, each for itself (ray_potential.h).
#pragma once
#include <memory>
#include <utility>

#include "spacetime/potential_survey.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

class OpenFormulaMetric final : public SphericalMetric {
public:
    // Errors: of the key of one formula.
    static Result<std::shared_ptr<const Spacetime>> make(const MetricFormulas& formulas);

    std::string_view name() const override { return "formula"; }
    double lapse_squared(double r) const override { return formulas_.lapse2(r); }
    double areal_radius(double r) const override { return formulas_.areal_radius(r); }
    double radial_stretch2(double r) const override { return formulas_.stretch2(r); }
    RadiusRange camera_range() const override;
    std::optional<double> horizon_radius() const override { return survey_.horizon; }
    std::optional<PhotonSphere> photon_sphere() const override;
    InnerEnd inner_end() const override { return survey_.comes_back ? InnerEnd::kSameSky : InnerEnd::kHorizon; }
    const PotentialSurvey* potential() const override { return &survey_; }

private:
    OpenFormulaMetric(const MetricFormulas& formulas, PotentialSurvey survey)
        : formulas_(formulas), survey_(std::move(survey)) {}
    MetricFormulas formulas_;
    PotentialSurvey survey_;
};

}  // namespace nullscope
