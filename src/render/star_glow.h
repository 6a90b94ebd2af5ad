// How bright the brightest primary of a black body is, from a table: what decides whether a star is worth an image.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "light/black_body.h"

namespace nullscope {

class StarGlow {
public:
    explicit StarGlow(bool bolometric) {
        for (std::size_t i = 0; i < brightness_.size(); ++i) {
            const double kelvin = std::exp2(kColdest + kStep * static_cast<double>(i));
            const Vec3 xyz = black_body_xyz(kelvin), rgb = into_gamut(rec709_from_xyz(xyz / xyz.y));
            brightness_[i] = log2_brightness(kelvin, bolometric);
            part_[i] = std::log2(std::max({rgb.x, rgb.y, rgb.z}));
        }
    }
    // log2 of a black body's brightness, and of its brightest primary over that, at a temperature (log2 of K), within 0.01.
    double brightness(double log2_K) const { return at(brightness_, log2_K); }
    double part(double log2_K) const { return at(part_, log2_K); }
    static constexpr double kMostPart = 2.3;  // of part(): red of the coldest

private:
    static constexpr double kColdest = 9.0, kStep = 0.1;  // 512 K to 524288 K
    using Row = std::array<double, 101>;
    static double at(const Row& row, double log2_K) {
        const double x = std::clamp((log2_K - kColdest) / kStep, 0.0, static_cast<double>(row.size()) - 1.001);
        const auto i = static_cast<std::size_t>(x);
        return row[i] + (x - static_cast<double>(i)) * (row[i + 1] - row[i]);
    }
    Row brightness_{}, part_{};
};

}  // namespace nullscope
