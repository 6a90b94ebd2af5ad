// Star catalogues: assets/sky/stars.bin, which ships, and stars-tycho-2.bin, which scripts/fetch_stars.py makes; layout in
// scripts/make_sky_assets.py.
#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope {

struct Star {
    Vec3 direction;            // unit; equatorial J2000: x to RA 0 Dec 0, z to the north celestial pole
    double magnitude = 0.0;    // Johnson V
    unsigned colour_code = 0;  // B-V + 0.5 in steps of 0.01; kColourCodes - 1: not measured
};

constexpr int kColourCodes = 1024;

// Brightest first. Errors: missing, another magic or version, a length that does not fit the count.
Result<std::vector<Star>> load_stars(const std::filesystem::path& file);
// Of the assets' folder; if the file is not there, the error says how it is made.
Result<std::vector<Star>> load_stars(StarCatalogue catalogue, const std::filesystem::path& assets);

// B-V of a code: 0 ... kColourCodes - 1; the Sun's for a star without a measured one.
double b_minus_v(int code);

// K of a star of that B-V: Ballesteros (2012), EPL 97, 34008, within its range of B-V.
double star_temperature(double colour_index);

// Linear Rec. 709 colour of a star of that B-V, luminance 1: a black body of star_temperature.
Vec3 star_colour(double colour_index);

}  // namespace nullscope
