#include "compare/stokes_measures.h"

#include <fmt/format.h>

#include <cmath>

namespace nullscope {

StokesMeasures stokes_measures(const Image<float>& stokes, double x, double y) {
    std::complex<double> sum, second;
    double light = 0, polarised = 0, circular = 0;
    for (int row = 0; row < stokes.height; ++row)
        for (int column = 0; column < stokes.width; ++column) {
            const float* of = stokes.at(column, row);
            const std::complex<double> linear(of[1], of[2]);
            const std::complex<double> place(column + 0.5 - x, y - row - 0.5);
            light += of[0], polarised += std::abs(linear), sum += linear, circular += of[3];
            if (std::norm(place) > 0) second += linear * std::conj(place * place) / std::norm(place);
        }
    if (!(light > 0)) return {0, 0, 0};
    return {std::abs(sum) / light, polarised / light, second / light, circular / light};
}

std::string words_of(const StokesMeasures& measures) {
    std::string words =
        fmt::format("polarised {:.3g} % net, {:.3g} % resolved, beta_2 {:.3g} at {:.4g} deg", 100 * measures.net,
                    100 * measures.resolved, std::abs(measures.beta_2), 180 / M_PI * std::arg(measures.beta_2));
    if (measures.circular != 0) words += fmt::format(", circular {:.3g} % net", 100 * measures.circular);
    return words;
}

}  // namespace nullscope
