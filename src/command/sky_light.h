// A picture as astronomers have it: north up, east left, in Jy where that is known; of a scene, or of a FITS file.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "command/capture_picture.h"
#include "image/band_picture.h"
#include "image/fits_input.h"
#include "scene/known_object.h"
#include "telescope/flux.h"
#include "telescope/sky_picture.h"

namespace nullscope::cli {

// The planes of the picture's FITS file (docs/fits.md): I, or I, Q, U, V with angles from north through east; in Jy by the unit, else relative.
Image<float> sky_planes(const Captured& captured, const std::optional<FluxUnit>& unit);
Image<float> sky_planes(const BandPicture& band, double unit);  // unit: of light 1

struct SkyLight {
    SkyPicture picture;  // where it is not in Jy its I adds up to 1
    bool in_jansky = false;
    std::optional<double> frequency_GHz;
    std::optional<SkyPlace> place;
};

Status one_frequency(const Scene& scene);  // bad input where its picture shows several (scene/medium_bands.h)

// pixel_on_sky(), or what is missing (bad input).
Result<double> sky_scale(const Scene& scene);

// Errors (bad input): the picture has no scale on the sky of Earth, several frequencies, or no light.
Result<SkyLight> sky_light(const Scene& scene, const Captured& captured);
// Errors (bad input): its header has no coordinates of the sky with square pixels, east to the left; it has no light. file: what errors call it.
Result<SkyLight> sky_light(const FitsPicture& fits, const std::string& file);

}  // namespace nullscope::cli
