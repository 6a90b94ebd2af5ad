// The flux of a picture whose only light is matter seen at one frequency, about an object of known mass and distance.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "image/image.h"
#include "scene/scene.h"

namespace nullscope {

struct FluxUnit {
    double jansky;  // of a pixel whose light in `channel` is 1
    int channel;    // of the picture's three
    double frequency_GHz;
    double luminance_jansky;  // of a pixel whose luminance is 1
};
// What a pixel spans as seen from Earth, rad. Nothing where the picture has no scale (observer/picture_scale.h) or no distance.
std::optional<double> pixel_on_sky(const Scene& scene);

// Nothing where a picture has other light (sky, disc, bodies), shows several frequencies as colours (command/band_pictures.h) or has no
// pixel_on_sky(); several: where two pictures are side by side.
std::optional<FluxUnit> flux_unit(const Scene& scene, bool several);

Image<float> in_jansky(const Image<float>& linear, const FluxUnit& unit);  // Jy a pixel, one channel
// Jy of the pixels from x0, y0 to before x1, y1.
double flux_of(const Image<float>& linear, const FluxUnit& unit, const std::array<int, 4>& part);
std::string flux_words(const Image<float>& linear, const FluxUnit& unit);  // "0.4467 Jy at 230 GHz"

}  // namespace nullscope
