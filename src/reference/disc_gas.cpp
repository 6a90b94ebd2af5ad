#include "reference/disc_gas.h"

#include <algorithm>
#include <cmath>

#include "reference/noise_ring.h"

namespace nullscope::reference {
namespace {

constexpr int kOctaves = 9;

}  // namespace

GasFactors gas_at(const DiscSpec& disc, double r, double azimuth, double t, double whole,
                  const std::function<double(double r)>& rate, double sense) {
    const double depth = std::log(r);
    double moved = depth;
    GasFactors gas;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const double distance = 0.3 / (1 << octave), first = 0.37 * octave, row = moved / distance + first,
                     ring = std::floor(row);
        const auto noise_of = [&](double number) {
            const double middle = (number - first) * distance, angle = azimuth - disc.rotation +
                                                                       sense * disc.gas.winding * (depth - middle) -
                                                                       (rate ? rate(std::exp(middle)) * t : 0.0);
            return NoiseRing(static_cast<long long>(number), static_cast<unsigned>(octave)).noise(angle / (2 * M_PI));
        };
        const double n = NoiseRing::blend(noise_of(ring), noise_of(ring + 1), row - ring);
        const double within = std::min(1.0, 0.35 + 0.25 * octave),
                     c = disc.gas.contrast * std::pow(0.82, octave) * (1 - whole + whole * within),
                     mean = 1 + c * c / 3;
        gas.light *= (1 + c * n) * (1 + c * n) / mean;
        gas.gaps *= (1 - c * n) * (1 - c * n) / mean;
        moved += 0.4 * distance * n;
    }
    return gas;
}

}  // namespace nullscope::reference
