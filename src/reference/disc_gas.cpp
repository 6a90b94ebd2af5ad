#include "reference/disc_gas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nullscope::reference {
namespace {

constexpr int kOctaves = 9;

// A permutation of the cells of one ring of one octave: the law of docs/light.md, in 32 bits.
class Ring {
public:
    Ring(long long number, unsigned octave) : cells_(8u << octave), half_bits_((4 + octave) / 2) {
        std::uint32_t key = (static_cast<std::uint32_t>(number) * 0x85157AF5u) ^ (octave * 0xC3D2E1F1u + 0x9E3779B1u);
        key = (key ^ (key >> 16)) * 0x7FEB352Du;
        key = (key ^ (key >> 15)) * 0x6C8E9CF5u;
        key_ = key ^ (key >> 16);
    }
    // n at so many turns from where its first cell begins.
    double noise(double turns) const {
        const double place = (turns - std::floor(turns)) * cells_, cell = std::floor(place);
        const auto first = static_cast<std::uint32_t>(cell);
        return blend(value(first % cells_), value((first + 1) % cells_), place - cell);
    }
    // Between neighbours; the squares of their shares add up to 1.
    static double blend(double a, double b, double part) {
        const double s = part * part * (3 - 2 * part);
        return ((1 - s) * a + s * b) / std::hypot(s, 1 - s);
    }

private:
    double value(std::uint32_t cell) const {
        const std::uint32_t most = cells_ - 1;
        std::uint32_t x = ((cell ^ key_) * 0x9E3779B1u) & most;
        x ^= x >> half_bits_;
        x = (x * ((key_ >> 9) | 1) + (key_ >> 20)) & most;
        x ^= x >> half_bits_;
        x = (x * 0x85157AF5u) & most;
        return (x + 0.5) / cells_ * 2 - 1;
    }
    std::uint32_t cells_, half_bits_, key_ = 0;
};

}  // namespace

GasFactors gas_at(const DiscSpec& disc, double r, double azimuth, double t, double whole,
                  const std::function<double(double r)>& rate) {
    const double depth = std::log(r);
    double moved = depth;
    GasFactors gas;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const double distance = 0.3 / (1 << octave), first = 0.37 * octave, row = moved / distance + first,
                     ring = std::floor(row);
        const auto noise_of = [&](double number) {
            const double middle = (number - first) * distance, angle = azimuth - disc.rotation +
                                                                       disc.gas.winding * (depth - middle) -
                                                                       (rate ? rate(std::exp(middle)) * t : 0.0);
            return Ring(static_cast<long long>(number), static_cast<unsigned>(octave)).noise(angle / (2 * M_PI));
        };
        const double n = Ring::blend(noise_of(ring), noise_of(ring + 1), row - ring);
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
