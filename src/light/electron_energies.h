// Energies of the electrons of synchrotron light that is not thermal, and the cells of the table that the shader has of it
// (table/electron_table.h, shaders/medium/electron_table.glsl).
#pragma once
#include <cmath>

namespace nullscope {

struct ElectronEnergies {
    bool kappa = false;                       // else a power law
    double index = 3.0;                       // kappa, or p of gamma^-p ...
    double gamma_min = 1.0, gamma_max = 1e5;  // ... between these
    bool isotropic = false;                   // in a field of every direction: the mean
    friend bool operator==(const ElectronEnergies&, const ElectronEnergies&) = default;
};

// Cells of equal log2 of s = nu/(1.5 nu_B sine), over the square of the electrons' scale: 1 of a power law, kappa w - 1 of a kappa distribution,
// at least 1. Beyond them logarithms go on as straight lines.
inline constexpr int kElectronCells = 1024;
struct ElectronCells {
    double first, per_octave;  // log2 of the first s
};
inline ElectronCells electron_cells(const ElectronEnergies& e) {
    constexpr double kLow = 1e-6, kHigh = 300.0, kFar = 1e10;  // of s of the slowest and of the fastest
    const double slow = e.kappa ? 1.0 / e.index : e.gamma_min;
    const double first = std::log2(kLow * slow * slow),
                 last = e.kappa ? std::log2(kFar) : std::log2(kHigh) + 2.0 * std::log2(e.gamma_max);
    return {first, kElectronCells / (last - first)};
}
// And of w of a kappa distribution, log2 of it.
inline constexpr double kElectronColdest = -4.0, kElectronHottest = 15.0;

}  // namespace nullscope
