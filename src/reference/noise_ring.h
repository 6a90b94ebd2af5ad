// The noise of turbulent gas for the reference (docs/light.md).
#pragma once
#include <cmath>
#include <cstdint>

namespace nullscope::reference {

// A permutation of the cells of one ring of one octave: the law of docs/light.md, in 32 bits.
class NoiseRing {
public:
    NoiseRing(long long number, unsigned octave) : cells_(8u << octave), half_bits_((4 + octave) / 2) {
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
        return ((1 - s) * a + s * b) / std::sqrt(s * s + (1 - s) * (1 - s));
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

}  // namespace nullscope::reference
