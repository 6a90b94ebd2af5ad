#include "spacetime/potential_panels.h"

#include <algorithm>
#include <cmath>

namespace nullscope {

PotentialPanels::PotentialPanels(const MetricFormulas& formulas, double end) : end_(end), panels_(kPanels) {
    constexpr double kPanelEnds = 1e-17;  // of the slope over a panel
    const double half = 0.5 * end / kPanels;
    for (int i = 0; i < kPanels; ++i) {
        Panel& panel = panels_[static_cast<std::size_t>(i)];
        const auto series = formulas.v<kTerms>((2 * i + 1) * half);
        double largest = 0.0;
        for (int k = 0; k < kTerms; ++k) {
            panel.c[static_cast<std::size_t>(k)] = series.of_power(k);
            largest =
                std::max(largest, std::fabs(panel.c[static_cast<std::size_t>(k)]) * std::pow(half, std::max(k - 1, 0)));
        }
        panel.good = true;
        for (int k = kTerms - 3; k < kTerms; ++k)
            panel.good = panel.good && std::fabs(panel.c[static_cast<std::size_t>(k)]) * k * std::pow(half, k - 1) <=
                                           kPanelEnds * largest;
    }
}

Potential PotentialPanels::operator()(const MetricFormulas& formulas, double zeta) const {
    const double place = zeta / end_ * kPanels;
    if (place >= 0.0 && place < kPanels) {
        const auto i = static_cast<std::size_t>(place);
        const Panel& panel = panels_[i];
        if (panel.good) {
            const double x = zeta - (2.0 * static_cast<double>(i) + 1.0) * (0.5 * end_ / kPanels);
            double v = 0.0, slope = 0.0, bend = 0.0;
            for (int k = kTerms - 1; k >= 0; --k) {  // Horner's rule, of the polynomial and its derivatives
                bend = slope + x * bend;
                slope = v + x * slope;
                v = panel.c[static_cast<std::size_t>(k)] + x * v;
            }
            return {v, slope, 2.0 * bend};
        }
    }
    const auto series = formulas.v<3>(zeta);
    return {series.of_power(0), series.of_power(1), 2.0 * series.of_power(2)};
}

}  // namespace nullscope
