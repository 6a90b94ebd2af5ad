#include "spacetime/formula_metric.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "spacetime/circular_orbit.h"
#include "spacetime/open_formula_metric.h"

namespace nullscope {
namespace {

constexpr int kTerms = Expansion::kTerms + 4;
constexpr double kWidest = 0.5;    // of an expansion, over the distance of its centre from zeta = 0
constexpr double kOffEnd = 1e-12;  // of r, that a radius may lie further in than the end: some roundings

// 1/r - 1/at
double apart(double r, double at) { return std::isinf(r) ? -1.0 / at : (at - r) / (r * at); }

}  // namespace

FormulaMetric::FormulaMetric(MetricFormulas formulas, const FormulaPlaces& places)
    : formulas_(std::move(formulas)),
      places_(places),
      scaled_lapse_far_(formulas_.scaled_lapse2<kTerms>(0.0), 2, kWidest * places.photon),
      v_far_(formulas_.v<kTerms>(0.0), 2, kWidest * places.photon),
      density_far_(formulas_.density<kTerms>(0.0), 0, kWidest * places.photon),
      about_photon_(formulas_.v<kTerms>(places.photon), 2, kWidest * places.photon),
      at_end_(formulas_.v<kTerms>(places.end), 1, kWidest * places.end),
      at_horizon_(formulas_.scaled_lapse2<kTerms>(places.horizon), 1, kWidest * places.horizon),
      panels_(formulas_, 1.1 * places.end) {
    v_crit_ = about_photon_.term(0);
    q_crit_ = std::sqrt(v_crit_);
    root_range_ = std::sqrt(v_crit_ - places_.v_at_sky);
    zeta_of_ = InverseMap([this](double zeta) { return chi_of(zeta, zeta - places_.end); }, places_.end);
    innermost_ = innermost();
    stable_orbits_ = orbit_equation() != nullptr && innermost_stable_orbit(*this).has_value();
}

// A hole with a table where there can be one.
Result<std::shared_ptr<const Spacetime>> FormulaMetric::of_formulas(const std::map<std::string, std::string>& texts) {
    TRY(formulas, MetricFormulas::parse(texts));
    MetricFormulas hole = *formulas;
    const auto places =
        find_places(hole, Expansion(hole.v<kTerms>(0.0), 2, 1.0), Expansion(hole.density<kTerms>(0.0), 0, 1.0));
    if (!places) return OpenFormulaMetric::make(*formulas);
    return std::shared_ptr<const Spacetime>(new FormulaMetric(std::move(hole), *places));
}

// The last few metrics: scene files ask for theirs a dozen times while they are read.
Result<std::shared_ptr<const Spacetime>> FormulaMetric::make(const std::map<std::string, std::string>& texts) {
    using Made = std::pair<std::map<std::string, std::string>, std::shared_ptr<const Spacetime>>;
    constexpr std::size_t kKept = 4;
    static std::mutex mutex;
    static std::vector<Made> kept;
    {
        const std::lock_guard lock(mutex);
        for (const Made& made : kept)
            if (made.first == texts) return made.second;
    }
    TRY(made_now, of_formulas(texts));
    const std::shared_ptr<const Spacetime> made = *made_now;
    const std::lock_guard lock(mutex);
    if (kept.size() == kKept) kept.erase(kept.begin());
    kept.emplace_back(texts, made);
    return made;
}

bool FormulaMetric::far(double zeta) const {
    return v_far_.holds(zeta) && scaled_lapse_far_.holds(zeta) && density_far_.holds(zeta);
}

double FormulaMetric::lapse_squared(double r) const {
    const double off = apart(r, 1.0 / places_.horizon), zeta = 1.0 / r;
    if (at_horizon_.holds(off)) return off * at_horizon_.over_lead(off) * r * r;
    if (!far(zeta)) return formulas_.lapse2(r);
    const double rest = scaled_lapse_far_.over_lead(zeta);
    return places_.v_at_sky == 0.0 ? rest : rest + scaled_lapse_far_.term(0) / (zeta * zeta);
}

RadiusRange FormulaMetric::camera_range() const {
    return {1.0 / places_.horizon, places_.outer_horizon > 0.0 ? 1.0 / places_.outer_horizon : kAnyRadius};
}

// Where rays that come in end at the horizon the table can be followed through it.
RadiusRange FormulaMetric::falling_range() const { return {innermost_, camera_range().high}; }

double FormulaMetric::innermost() const {
    if (formulas_.tilted() || places_.v_at_sky != 0.0) return 1.0 / places_.horizon;
    constexpr double kStep = 0.99;
    double r = 1.0 / places_.horizon;
    while (r > FormulaPlaces::kNearest) {
        const double next = kStep * r, a = formulas_.lapse2(next);
        if (!(a < 1.0 && a < v_crit_ * next * next)) break;
        r = next;
    }
    return r;
}

double FormulaMetric::root_above(double zeta, double off_end) const {
    if (far(zeta)) return zeta * std::sqrt(std::max(v_far_.over_lead(zeta), 0.0));
    if (at_end_.holds(off_end))  // in this order: at the end itself 0, not -0
        return std::sqrt(std::max(0.0, off_end * at_end_.over_lead(off_end)));
    return std::sqrt(std::max(panels_(formulas_, zeta).v - places_.v_at_sky, 0.0));
}

double FormulaMetric::root_below(double zeta) const {
    const double x = zeta - places_.photon;
    if (about_photon_.holds(x)) return -x * std::sqrt(std::max(-about_photon_.over_lead(x), 0.0));
    const double v = far(zeta) ? places_.v_at_sky + zeta * zeta * v_far_.over_lead(zeta) : panels_(formulas_, zeta).v,
                 root = std::sqrt(std::max(v_crit_ - v, 0.0));
    return x < 0.0 ? root : -root;
}

double FormulaMetric::rate(double zeta) const {
    const double x = zeta - places_.photon;
    if (far(zeta)) {
        const double part = v_far_.over_lead(zeta);
        return 2.0 * std::sqrt(part) * root_below(zeta) / (2.0 * part + zeta * v_far_.over_lead_slope(zeta));
    }
    const double above = root_above(zeta, zeta - places_.end);
    if (about_photon_.holds(x)) {
        const double part = -about_photon_.over_lead(x);
        return 2.0 * above * std::sqrt(part) / (2.0 * part - x * about_photon_.over_lead_slope(x));
    }
    return 2.0 * above * root_below(zeta) / panels_(formulas_, zeta).slope;
}

double FormulaMetric::chi_of(double zeta, double off_end) const {
    return std::atan2(root_above(zeta, off_end), root_below(zeta));
}

double FormulaMetric::chi_from_radius(double r) const {
    const double end = 1.0 / places_.end;
    require_chi("FormulaMetric", r, end * (1.0 - kOffEnd));
    return chi_of(1.0 / r, std::min(apart(r, end), 0.0));
}

double FormulaMetric::zeta_from_chi(double chi) const {
    return zeta_of_(
        chi, [this](double zeta) { return chi_of(zeta, zeta - places_.end); },
        [this](double zeta) { return rate(zeta); });
}

double FormulaMetric::bending_density(double chi) const {
    const double zeta = zeta_from_chi(chi),
                 density = far(zeta) ? density_far_.over_lead(zeta) : formulas_.density<2>(zeta).of_power(0);
    return density * rate(zeta) / root_range_;
}

double FormulaMetric::half_v_slope(double zeta) const {
    if (far(zeta)) return zeta * (v_far_.over_lead(zeta) + 0.5 * zeta * v_far_.over_lead_slope(zeta));
    return 0.5 * panels_(formulas_, zeta).slope;
}

double FormulaMetric::half_v_curvature(double zeta) const {
    if (far(zeta))
        return v_far_.over_lead(zeta) +
               zeta * (2.0 * v_far_.over_lead_slope(zeta) + 0.5 * zeta * v_far_.over_lead_curvature(zeta));
    return 0.5 * panels_(formulas_, zeta).curvature;
}

// A = v_s r^2 + what over_lead says.
double FormulaMetric::lapse_slope(double zeta) const {
    if (far(zeta)) return scaled_lapse_far_.over_lead_slope(zeta) - 2.0 * places_.v_at_sky / (zeta * zeta * zeta);
    const auto z = expr::Series<double, 2>::variable(zeta);
    return formulas_.lapse2(expr::Series<double, 2>(1.0) / z).of_power(1);
}

double FormulaMetric::lapse_curvature(double zeta) const {
    if (far(zeta))
        return scaled_lapse_far_.over_lead_curvature(zeta) + 6.0 * places_.v_at_sky / (zeta * zeta * zeta * zeta);
    const auto z = expr::Series<double, 3>::variable(zeta);
    return 2.0 * formulas_.lapse2(expr::Series<double, 3>(1.0) / z).of_power(2);
}

}  // namespace nullscope
