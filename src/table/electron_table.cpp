#include "table/electron_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "table/synchrotron_kernels.h"

namespace nullscope {
namespace {

constexpr double kPanel = 0.5;  // of ln gamma
constexpr std::size_t kPanelPoints = 8;
constexpr double kDarkest = 700.0;  // x: no light
// Gauss and Legendre's of eight points on [-1, 1].
constexpr std::array<double, kPanelPoints / 2> kPlaces{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                       0.9602898564975363},
    kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

// f(ln gamma, weight) for each place of panels between two values of ln gamma.
template <class F>
void over_panels(double low, double high, const F& f) {
    if (!(high > low)) return;
    const int panels = static_cast<int>(std::ceil((high - low) / kPanel));
    const double half = 0.5 * (high - low) / panels;
    for (int p = 0; p < panels; ++p) {
        const double middle = low + (2 * p + 1) * half;
        for (std::size_t i = 0; i < kPanelPoints / 2; ++i)
            for (const double side : {-1.0, 1.0}) f(middle + side * half * kPlaces[i], half * kWeights[i]);
    }
}

// ln of N gamma, whose integral over ln gamma is 1 of a power law.
double log_number(const ElectronEnergies& e, double log_gamma) {
    if (e.kappa) return 3.0 * log_gamma - (e.index + 1.0) * std::log1p(std::exp(log_gamma));
    const double p = e.index - 1.0,
                 range = -std::expm1(-p * std::log(e.gamma_max / e.gamma_min)) / p;  // of gamma_min^-p
    return -p * (log_gamma - std::log(e.gamma_min)) - std::log(range);
}

struct Range {
    double low, high;  // ln gamma
};
Range range_of(const ElectronEnergies& e, double log_s) {
    if (!e.kappa) return {std::log(e.gamma_min), std::log(e.gamma_max)};
    constexpr double kLeast = 1e-11;  // of the integrals
    const double bright = 0.5 * std::max(log_s, 0.0);
    return {std::log(1e-4 / e.index), bright - std::log(kLeast) / (e.index - 2.0 + 2.0 / 3)};
}

struct Integrals {
    KernelValues of{};   // of the kernels, with the powers of gamma that belong to each
    double measure = 0;  // M
};
Integrals integrals(const ElectronEnergies& e, double log_s) {
    const KernelTable& kernels = kernel_table(e.isotropic);
    Integrals sum;
    const Range range = range_of(e, log_s);
    over_panels(range.low, range.high, [&](double log_gamma, double weight) {
        const double log_x = log_s - 2.0 * log_gamma, gamma = std::exp(log_gamma), square = gamma * gamma,
                     number = weight * std::exp(log_number(e, log_gamma));
        const KernelValues k = kernels.at(log_x);
        const KernelValues factors{1.0,         1.0,          1.0 / gamma, 2.0 / gamma,
                                   2.0 / gamma, 1.0 / square, 2.0 * gamma, 1.0 / square};
        for (std::size_t i = 0; i < kSynchrotronKernels; ++i) sum.of[i] += number * factors[i] * k[i];
        const double z2 = std::pow(1.5 * std::exp(log_x), 4.0 / 3);
        sum.measure += number * 2.0 * gamma * z2 / (1.0 + z2);
    });
    return sum;
}

// Of N itself: what it adds up to, and means.
struct Means {
    double all, rotation, inverse;
};
Means power_law_means(const ElectronEnergies& e) {
    Means sum{1.0, 0.0, 0.0};
    over_panels(std::log(e.gamma_min), std::log(e.gamma_max), [&](double log_gamma, double weight) {
        const double gamma = std::exp(log_gamma), number = weight * std::exp(log_number(e, log_gamma));
        sum.rotation += number * std::acosh(gamma) / (gamma * std::sqrt(gamma * gamma - 1.0));
        sum.inverse += number / gamma;
    });
    return sum;
}
// By the trapezoidal rule in ln(gamma - 1).
Means kappa_means(double kappa, double w) {
    constexpr double kStep = 0.25, kFirst = -36.0, kTail = 36.0;
    Means sum{0.0, 0.0, 0.0};
    const double last = std::max(std::log(kappa * w), 0.0) + kTail / (kappa - 2.0);
    for (double y = kFirst; y < last; y += kStep) {
        const double more = std::exp(y), gamma = 1.0 + more, root = std::sqrt(more * (2.0 + more)),
                     phase = kStep * more * std::exp(-(kappa + 1.0) * std::log1p(more / (kappa * w)));
        sum.all += phase * gamma * root;
        sum.rotation += phase * std::log1p(more + root);
        sum.inverse += phase * root;
    }
    sum.rotation /= sum.all, sum.inverse /= sum.all;
    return sum;
}

float log2_of(double value) { return static_cast<float>(std::log2(std::max(value, 1e-300))); }

}  // namespace

TexelGrid electron_texels(const ElectronEnergies& e) {
    constexpr std::size_t kRow = 4 * (kElectronCells + 1);
    TexelGrid grid{kElectronCells + 1, kElectronRows, std::vector<float>(kElectronRows * kRow)};
    const ElectronCells cells = electron_cells(e);
    const Means even = e.kappa ? Means{} : power_law_means(e);
    for (int cell = 0; cell <= kElectronCells; ++cell) {
        const Integrals found = integrals(e, std::log(2.0) * (cells.first + cell / cells.per_octave));
        const KernelValues& k = found.of;
        const double log2_w = kElectronColdest + (kElectronHottest - kElectronColdest) * cell / kElectronCells;
        const Means means = e.kappa ? kappa_means(e.index, std::exp2(log2_w)) : even;
        const float norm = e.kappa ? static_cast<float>(3.0 * log2_w - std::log2(means.all)) : 0.0F;
        const auto over = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
        const std::array<float, 4> rows[] = {
            {log2_of(k[kOfI]), log2_of(k[kAbsorbedI]), static_cast<float>(over(k[kOfQ], k[kOfI])),
             static_cast<float>(over(k[kAbsorbedQ], k[kAbsorbedI]))},
            {log2_of(over(k[kOfV], k[kOfI])), log2_of(over(k[kAbsorbedV], k[kAbsorbedI])), log2_of(found.measure),
             static_cast<float>(over(k[kConverted], found.measure))},
            {static_cast<float>(k[kTurned]), norm, log2_of(means.rotation), log2_of(means.inverse)}};
        for (std::size_t row = 0; row < kElectronRows; ++row)
            std::ranges::copy(rows[row], grid.texels.begin() + static_cast<std::ptrdiff_t>(
                                                                   row * kRow + 4 * static_cast<std::size_t>(cell)));
    }
    return grid;
}

}  // namespace nullscope
