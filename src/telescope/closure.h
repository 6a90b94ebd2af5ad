// Closure phases and log closure amplitudes: what no station's own gain or delay changes.
#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "telescope/observation.h"

namespace nullscope {

struct ClosurePhase {
    double hour = 0;
    std::array<std::size_t, 3> stations{};  // ascending
    double phase = 0;                       // arg(V_12 V_23 V_31), rad, (-pi, pi]
};
// Of every three stations of every scan. visibilities: of seen.baselines.
std::vector<ClosurePhase> closure_phases(const Observation& seen, std::span<const std::complex<double>> visibilities);

struct ClosureAmplitude {
    double hour = 0;
    std::array<std::size_t, 4> stations{};  // ascending
    // ln(|V_12| |V_34|/(|V_13| |V_24|)) and ln(|V_12| |V_34|/(|V_14| |V_23|)); the third ratio's is their difference.
    std::array<double, 2> log{};
};
// Of every four stations.
std::vector<ClosureAmplitude> closure_amplitudes(const Observation& seen,
                                                 std::span<const std::complex<double>> visibilities);

}  // namespace nullscope
