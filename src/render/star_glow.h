// How bright stars are: what they shine with before anything shifts it, and how bright the brightest primary of a black body is, from a table,
// which decides whether a star is worth an image.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "light/black_body.h"
#include "sky/point_stars.h"

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

// Of each star.
struct StarLight {
    double light;        // log2 of flux over a black body's brightness
    double temperature;  // log2 of K
};
inline std::vector<StarLight> star_lights(const std::vector<PointStar>& stars, bool bolometric) {
    std::vector<StarLight> lights;
    std::unordered_map<double, double> brightness;  // by temperature: the catalogue has few
    for (const PointStar& star : stars) {
        const auto [known, is_new] = brightness.try_emplace(star.temperature_K, 0.0);
        if (is_new) known->second = log2_brightness(star.temperature_K, bolometric);
        lights.push_back({std::log2(star.flux) - known->second, std::log2(star.temperature_K)});
    }
    return lights;
}

}  // namespace nullscope
