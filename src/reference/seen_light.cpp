#include "reference/seen_light.h"

#include <array>
#include <cmath>

#include "light/black_body.h"
#include "reference/chebyshev.h"

namespace nullscope::reference {
namespace {

struct Colour {
    double log2_luminance;
    Vec3 hue;  // tristimulus values over the luminance; black: 0
};

Colour colour_by_sum(double temperature_K) {
    const Vec3 xyz = black_body_xyz(temperature_K);
    if (!(xyz.y > 0)) return {-INFINITY, {0, 0, 0}};
    return {std::log2(xyz.y), xyz / xyz.y};
}

// Matter asks for some thousand temperatures a ray, and the sum over wavelengths is 81 exponentials. Its logarithm is a smooth function of
// that of the temperature: within 1e-12 of it (test_black_body.cpp).
Colour colour_of(double temperature_K) {
    constexpr double kColdest = 7, kHottest = 33;  // log2 of K
    constexpr std::size_t kTerms = 12, kPieces = 4 * static_cast<std::size_t>(kHottest - kColdest);
    static const ChebyshevPieces<3, kTerms> pieces(
        [](double log2_K) {
            const Colour colour = colour_by_sum(std::exp2(log2_K));
            return std::array{colour.log2_luminance, std::log2(colour.hue.x), std::log2(colour.hue.z)};
        },
        kColdest, kHottest, kPieces);
    const double log2_K = std::log2(temperature_K);
    if (!pieces.holds(log2_K)) return colour_by_sum(temperature_K);
    const auto [luminance, x, z] = pieces(log2_K);
    return {luminance, {std::exp2(x), 1, std::exp2(z)}};
}

}  // namespace

double seen_log2_brightness(double temperature_K, bool bolometric) {
    return bolometric ? log2_brightness(temperature_K, true) : colour_of(temperature_K).log2_luminance;
}

Vec3 seen_black_body(double temperature_K, double g, const LightSpec& light) {
    const double coloured_K = light.shift ? g * temperature_K : temperature_K,
                 bright_K = light.beaming ? g * temperature_K : temperature_K;
    const Colour colour = colour_of(coloured_K);
    if (!(colour.hue.y > 0)) return {0, 0, 0};
    const double log2_bright = bright_K == coloured_K && !light.bolometric
                                   ? colour.log2_luminance
                                   : seen_log2_brightness(bright_K, light.bolometric);
    return std::exp2(log2_bright) * into_gamut(rec709_from_xyz(colour.hue));
}

}  // namespace nullscope::reference
