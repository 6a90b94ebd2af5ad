#include "telescope/closure.h"

#include <cmath>

namespace nullscope {

std::vector<ClosurePhase> closure_phases(const Observation& seen, std::span<const std::complex<double>> visibilities) {
    std::vector<ClosurePhase> found;
    for (const Scan& scan : seen.scans)
        for (std::size_t a = 0; a < scan.up.size(); ++a)
            for (std::size_t b = a + 1; b < scan.up.size(); ++b)
                for (std::size_t c = b + 1; c < scan.up.size(); ++c) {
                    const auto product = visibilities[scan.at(a, b)] * visibilities[scan.at(b, c)] *
                                         std::conj(visibilities[scan.at(a, c)]);
                    found.push_back({scan.hour, {scan.up[a], scan.up[b], scan.up[c]}, std::arg(product)});
                }
    return found;
}

std::vector<ClosureAmplitude> closure_amplitudes(const Observation& seen,
                                                 std::span<const std::complex<double>> visibilities) {
    std::vector<ClosureAmplitude> found;
    for (const Scan& scan : seen.scans) {
        const auto log_of = [&](std::size_t a, std::size_t b) {
            return std::log(std::abs(visibilities[scan.at(a, b)]));
        };
        for (std::size_t a = 0; a < scan.up.size(); ++a)
            for (std::size_t b = a + 1; b < scan.up.size(); ++b)
                for (std::size_t c = b + 1; c < scan.up.size(); ++c)
                    for (std::size_t d = c + 1; d < scan.up.size(); ++d) {
                        const double pair = log_of(a, b) + log_of(c, d);
                        found.push_back({scan.hour,
                                         {scan.up[a], scan.up[b], scan.up[c], scan.up[d]},
                                         {pair - log_of(a, c) - log_of(b, d), pair - log_of(a, d) - log_of(b, c)}});
                    }
    }
    return found;
}

}  // namespace nullscope
