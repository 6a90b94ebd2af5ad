#include "table/density_fit.h"

#include <algorithm>
#include <cmath>

#include "table/chebyshev.h"

namespace nullscope {

DensityFit::DensityFit(const SphericalMetric& spacetime) {
    constexpr double kWidth = M_PI / kPanels;
    const auto panel = [](double low, double high, const auto& h) {
        const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
        return Panel{middle, 1.0 / half,
                     powers_through_chebyshev<kTerms>([&](double t) { return h(middle + half * t); })};
    };
    const auto from_sky = [&](double chi) { return spacetime.chi()->bending_density(chi); };
    const auto from_end = [&](double rest) { return spacetime.chi()->bending_density(M_PI - rest); };
    for (int i = 0; i < kPanels; ++i) inner_.push_back(panel(i * kWidth, (i + 1) * kWidth, from_sky));
    for (int k = 0; k <= kHalvings; ++k) {
        const double high = std::ldexp(kWidth, -k), low = k == kHalvings ? 0.0 : 0.5 * high;
        first_.push_back(panel(low, high, from_sky));
        last_.push_back(panel(low, high, from_end));
    }
}

double DensityFit::operator()(double chi) const {
    const double place = chi * (kPanels / M_PI);
    const int i = std::clamp(static_cast<int>(place), 0, kPanels - 1);
    const bool near_sky = i == 0, near_end = i == kPanels - 1;
    const Panel* panel = &inner_[static_cast<std::size_t>(i)];
    double at = chi;
    if (near_sky || near_end) {
        at = near_sky ? chi : std::max(M_PI - chi, 0.0);
        const double part = at * (kPanels / M_PI);  // of the panel, 0 ... 1
        const int k = part > 0.0 ? std::clamp(-std::ilogb(part) - 1, 0, kHalvings) : kHalvings;
        panel = &(near_sky ? first_ : last_)[static_cast<std::size_t>(k)];
    }
    const double t = (at - panel->middle) * panel->per_half;
    double sum = panel->c.back();
    for (int p = kTerms - 2; p >= 0; --p) sum = panel->c[static_cast<std::size_t>(p)] + t * sum;
    return sum;
}

}  // namespace nullscope
