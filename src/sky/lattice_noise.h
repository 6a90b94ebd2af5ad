// Fractal noise in space from one table of random numbers.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace nullscope {

// Random numbers, the same for the same seed on every machine.
class SeededRandom {
public:
    explicit SeededRandom(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x2545f4914f6cdd1du) {}
    double next() {  // [0, 1)
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
    }
    Vec3 direction() {  // uniform over the sphere
        const double z = 2.0 * next() - 1.0, phi = 6.283185307179586 * next(), rho = std::sqrt((1.0 - z) * (1.0 + z));
        return {rho * std::cos(phi), rho * std::sin(phi), z};
    }

private:
    std::uint64_t state_;
};

class LatticeNoise {
public:
    explicit LatticeNoise(SeededRandom& random);

    // Values of the lattice's points, interpolated smoothly: [0, 1], about 1/2; of period kSide.
    double value(Vec3 p) const;
    // Octaves added, each turned, half as large and half as strong: [0, 1].
    double fractal(Vec3 p, int octaves) const;
    // Of ridges where octaves pass through 1/2, the finer ones on the coarser: [0, 1].
    double ridged(Vec3 p, int octaves) const;

private:
    static constexpr int kSide = 32;  // 128 KiB: what a core's cache holds
    std::vector<float> table_;
};

}  // namespace nullscope
