// Matter that is seen at several frequencies at once, medium.frequency = [86, 230, 345]: bands, ascending (docs/matter.md).
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/scene.h"

namespace nullscope {

// Bands that one march along a ray follows.
inline constexpr std::size_t kBandsAtOnce = 3;

// After frequencies or shown_band were set: frequency_GHz is then that of the band that is shown, or the first one.
void settle_bands(MediumSpec& medium);

// Whether its matter is seen at several frequencies, and whether pictures show them as colours: light that is not polarised, all bands.
bool has_bands(const Scene& scene);
bool shows_bands(const Scene& scene);

// Which of them a picture has as colours, red first, blue last: all of two or three, else the lowest, the middle and the highest; and what of
// red, green and blue the light of number i of these has. Of two green is half of both.
std::vector<std::size_t> bands_as_colours(const MediumSpec& medium);
Vec3 colour_of_band(std::size_t i, std::size_t count);

// The scene seen at one of its frequencies alone; a scene without bands as it is.
Scene at_band(Scene scene, std::size_t band);
// All of them.
std::vector<Scene> scenes_of_bands(const Scene& scene);

// Of GHz: "86GHz", of names of channels and files: a fraction follows a comma.
std::string band_name(double frequency);
// "86, 230, 345 GHz"
std::string frequency_words(const MediumSpec& medium);

}  // namespace nullscope
