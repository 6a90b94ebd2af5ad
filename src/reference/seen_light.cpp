#include "reference/seen_light.h"

#include <cmath>

#include "light/black_body.h"

namespace nullscope::reference {

Vec3 seen_black_body(double temperature_K, double g, const LightSpec& light) {
    const double coloured_K = light.shift ? g * temperature_K : temperature_K,
                 bright_K = light.beaming ? g * temperature_K : temperature_K;
    const Vec3 hue = black_body_xyz(coloured_K);
    if (!(hue.y > 0)) return {0, 0, 0};
    // Of one temperature one sum over wavelengths tells both.
    const double log2_bright =
        bright_K == coloured_K && !light.bolometric ? std::log2(hue.y) : log2_brightness(bright_K, light.bolometric);
    return std::exp2(log2_bright) * into_gamut(rec709_from_xyz(hue / hue.y));
}

}  // namespace nullscope::reference
