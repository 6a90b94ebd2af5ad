#include "reference/seen_light.h"

#include <cmath>

#include "light/black_body.h"

namespace nullscope::reference {

Vec3 seen_black_body(double temperature_K, double g, const LightSpec& light) {
    const Vec3 hue = black_body_xyz(light.shift ? g * temperature_K : temperature_K);
    if (!(hue.y > 0)) return {0, 0, 0};
    return std::exp2(log2_brightness(light.beaming ? g * temperature_K : temperature_K, light.bolometric)) *
           into_gamut(rec709_from_xyz(hue / hue.y));
}

}  // namespace nullscope::reference
