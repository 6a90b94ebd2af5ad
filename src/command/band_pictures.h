// Pictures of matter at each of several frequencies, and what is told of them.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/band_picture.h"
#include "image/image.h"
#include "scene/exposure.h"
#include "scene/scene.h"
#include "telescope/flux.h"

namespace nullscope::cli {

// How a scene's light is drawn: linear, three channels; and Stokes parameters, where they can be.
struct BandDrawing {
    std::function<Result<Image<float>>(const Exposure&)> light, stokes;
};

// Of a scene with bands (scene/medium_bands.h), ascending; of others none. Light that is not polarised is drawn three frequencies at once, else each
// alone. drawn: the linear light of the picture, which has up to three of them already; empty: it is not there.
Result<std::vector<BandPicture>> band_pictures(const Exposure& shown, const BandDrawing& draw,
                                               const Image<float>& drawn);

// The unit of each band's light, where pictures have a flux (telescope/flux.h): channel 0 is BandPicture::light.
std::vector<std::optional<FluxUnit>> band_units(const Scene& scene, bool several);

// "1.2 Jy at 86 GHz, 0.5 Jy at 230 GHz", and of polarised light the rotation measure between each two
// (compare/rotation_measure.h). Empty where there is neither.
std::string band_words(const Scene& scene, bool several, const std::vector<BandPicture>& bands);

}  // namespace nullscope::cli
