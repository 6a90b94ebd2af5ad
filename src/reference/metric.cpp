#include "reference/metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "reference/plane_metrics.h"

namespace nullscope::reference {
namespace {

struct Entry {
    const char* key;
    Result<std::unique_ptr<Metric>> (*make)(const SpacetimeSpec& spec);
};
template <auto make>
Result<std::unique_ptr<Metric>> made(const SpacetimeSpec& spec) {
    return std::unique_ptr<Metric>(make(spec));
}
constexpr std::array kMetrics{
    Entry{"schwarzschild", made<make_schwarzschild_orbits>},
    Entry{"reissner-nordstrom", made<make_reissner_nordstrom_orbits>},
    Entry{"neutron-star", made<make_star_orbits>},
    Entry{"ellis", made<make_ellis_orbits>},
    Entry{"kerr", made<make_kerr_metric>},
    Entry{"kerr-newman", made<make_kerr_newman_metric>},
    Entry{"dneg-wormhole", made<make_dneg_orbits>},
    Entry{"janis-newman-winicour", made<make_janis_newman_winicour_orbits>},
    Entry{"formula", make_formula_orbits},
    Entry{"minkowski", made<make_minkowski_orbits>},
};

}  // namespace

// Round the axis N the place n moves by Omega N x n: its share of e_phi is cos(tilt)/sin(theta), the rest is along e_theta.
double Metric::leaning_u_t(double r, double rate, double tilt, double cosine) const {
    const double sine2 = std::max((1 - cosine) * (1 + cosine), 1e-30), c = std::cos(tilt), east = rate * c / sine2,
                 south2 = rate * rate * std::max(1 - c * c / sine2, 0.0);
    const PlaceMetric g = place(r, std::sqrt(sine2), cosine);
    return 1 / std::sqrt(-g.g_tt - east * (2 * g.g_tphi + g.g_phiphi * east) - g.g_thetatheta * south2);
}

double Metric::sense(OrbitSense of) const {
    if (of == OrbitSense::kEastward || of == OrbitSense::kWestward) return of == OrbitSense::kEastward ? 1 : -1;
    return (of == OrbitSense::kPrograde) != turns_westward() ? 1 : -1;
}

double Metric::kepler_rate(double r, double sense) const {
    const double h = 1e-3 * r;  // fourth order
    const auto slope = [&](double EquatorialMetric::*part) {
        const auto d = [&](double by) { return equator(r + by).*part - equator(r - by).*part; };
        return (8 * d(h) - d(2 * h)) / (12 * h);
    };
    const double tt = slope(&EquatorialMetric::g_tt), tp = slope(&EquatorialMetric::g_tphi),
                 pp = slope(&EquatorialMetric::g_phiphi);
    return (sense * std::sqrt(std::fmax(tp * tp - tt * pp, 0)) - tp) / pp;
}

Result<std::unique_ptr<Metric>> make_metric(const SpacetimeSpec& spec) {
    std::string known;
    for (const Entry& entry : kMetrics) {
        if (spec.metric == entry.key) return entry.make(spec);
        known += known.empty() ? entry.key : std::string(", ") + entry.key;
    }
    return bad_input("the reference tracer has no orbits for the metric '" + spec.metric + "' (it knows: " + known +
                     ")");
}

}  // namespace nullscope::reference
