// The stars of a sky as points: render and reference draw the same list, each with its own images.
#pragma once
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope {

struct PointStar {
    Vec3 direction;  // world axes, unit
    double
        flux;  // luminance times solid angle, in the unit of SkyCube's radiance times sr; SkySpec::brightness included
    double temperature_K;  // of the black body of its colour
};

// How a point is drawn: the display's point spread, a Gaussian of this width sampled in the middles of pixels (their sum is 1 within
// 2e-4 wherever it lies); and how far outside of the picture a star's middle may be.
inline constexpr double kPointSigma_px = 0.7;
inline constexpr int kPointMargin_px = 16;
// Light of a pixel, white is 1, below which a star is left out: half of the first step of 8 bits in sRGB.
inline constexpr double kFaintestPoint = 1.0 / 6587.0;
// Of a point's light, what falls on a square pixel about its middle.
inline double point_peak() { return 1.0 / (2.0 * M_PI * kPointSigma_px * kPointSigma_px); }

// Of kind kPoints: the catalogue down to SkySpec::magnitude_limit, brightest first; or uniform_stars on a spiral of Fibonacci, each of
// magnitude `magnitude_limit`. Others: none. Errors: the catalogue is missing or damaged. 20 ms for the catalogue.
Result<std::vector<PointStar>> point_stars(const SkySpec& spec, const std::filesystem::path& assets);

}  // namespace nullscope
