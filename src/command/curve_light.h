// What a light curve has of a picture.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "command/capture_picture.h"
#include "scene/scene.h"
#include "telescope/flux.h"

namespace nullscope::cli {

using PicturePixels = std::array<int, 4>;  // x, y of the first pixel, x, y behind the last

// Sums of light times the solid angle of each pixel: luminance, red, green, blue; 1 is a steradian of white.
std::array<double, 4> light_in(const Image<float>& picture, const CameraSpec& camera, const PicturePixels& region);

// Of pictures that have a flux (telescope/flux.h): "jansky", or of several frequencies "jansky_86GHz" and so on.
struct FluxColumn {
    std::string name;
    FluxUnit unit;
};
std::vector<FluxColumn> flux_columns(const Scene& scene);
// Jy, by these columns. drawn: with its bands, where the columns are several.
std::vector<double> fluxes_in(const Captured& drawn, const std::vector<FluxColumn>& columns,
                              const PicturePixels& region);

}  // namespace nullscope::cli
