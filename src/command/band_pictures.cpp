#include "command/band_pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compare/rotation_measure.h"
#include "image/channels.h"
#include "scene/medium_bands.h"

namespace nullscope::cli {
namespace {

Image<float> one_channel(const Image<float>& image, int channel, double factor) {
    Image<float> one(image.width, image.height, 1);
    one.data = channel_of(image, channel);
    for (float& value : one.data) value = static_cast<float>(factor * value);
    return one;
}

// Light 1 is then a brightness temperature of 1e9 K, of red, green and blue alike, and is seen without a polariser.
Scene plain(Scene scene) {
    scene.medium->colour = {1, 1, 1}, scene.medium->brightness = 1, scene.medium->shown_band = 0;
    scene.picture.polariser.reset();
    return scene;
}

Scene with_bands(Scene scene, std::size_t from, std::size_t count) {
    if (count == 1) return at_band(std::move(scene), from);
    std::vector<double>& bands = scene.medium->bands_GHz;
    const auto first = bands.begin() + static_cast<std::ptrdiff_t>(from);
    bands = std::vector<double>(first, first + static_cast<std::ptrdiff_t>(count));
    settle_bands(*scene.medium);
    return scene;
}

// Which of red, green and blue one of `count` bands has for itself.
int channel_of_band(std::size_t i, std::size_t count) { return count == 2 && i == 1 ? 2 : static_cast<int>(i); }

// A picture that shows all bands, in colours that all have some light.
bool has_all(const Scene& scene, const Image<float>& drawn) {
    const MediumSpec& medium = *scene.medium;
    const Vec3 light = medium.brightness * medium.colour;
    return shows_bands(scene) && !drawn.empty() && medium.bands_GHz.size() <= kBandsAtOnce &&
           std::min({light.x, light.y, light.z}) > 0;
}

Result<std::vector<BandPicture>> polarised_bands(const Exposure& shown, const BandDrawing& draw) {
    std::vector<BandPicture> bands;
    for (std::size_t i = 0; i < shown.scene.medium->bands_GHz.size(); ++i) {
        const Exposure one = changed(shown, [&](const Scene& scene) { return at_band(plain(scene), i); });
        BandPicture band{shown.scene.medium->bands_GHz[i], {}, {}};
        TRY(light, draw.stokes ? draw.stokes(one) : draw.light(one));
        band.light = one_channel(*light, 0, 1.0);
        if (draw.stokes) band.stokes = std::move(*light);
        bands.push_back(std::move(band));
    }
    return bands;
}

}  // namespace

Result<std::vector<BandPicture>> band_pictures(const Exposure& shown, const BandDrawing& draw,
                                               const Image<float>& drawn) {
    if (!has_bands(shown.scene)) return std::vector<BandPicture>();
    const MediumSpec& medium = *shown.scene.medium;
    if (is_polarised(medium)) return polarised_bands(shown, draw);
    const std::size_t all = medium.bands_GHz.size();
    const bool drawn_has_all = has_all(shown.scene, drawn);
    const std::array<double, 3> colour{medium.colour.x, medium.colour.y, medium.colour.z};
    std::vector<BandPicture> bands;
    for (std::size_t from = 0; from < all; from += kBandsAtOnce) {
        const std::size_t count = std::min(kBandsAtOnce, all - from);
        Image<float> some;
        if (!drawn_has_all) {
            TRY(light, draw.light(changed(shown, [&](const Scene& s) { return with_bands(plain(s), from, count); })));
            some = std::move(*light);
        }
        for (std::size_t i = 0; i < count; ++i) {
            const int channel = channel_of_band(i, count);
            const double unit =
                drawn_has_all ? 1.0 / (medium.brightness * colour[static_cast<std::size_t>(channel)]) : 1.0;
            bands.push_back({medium.bands_GHz[from + i], one_channel(drawn_has_all ? drawn : some, channel, unit), {}});
        }
    }
    return bands;
}

std::vector<std::optional<FluxUnit>> band_units(const Scene& scene, bool several) {
    std::vector<std::optional<FluxUnit>> units;
    if (!has_bands(scene)) return units;
    for (const Scene& one : scenes_of_bands(plain(scene))) units.push_back(flux_unit(one, several));
    return units;
}

std::string band_words(const Scene& scene, bool several, const std::vector<BandPicture>& bands) {
    std::vector<std::string> words;
    const auto units = band_units(scene, several);
    for (std::size_t i = 0; i < bands.size() && i < units.size(); ++i)
        if (units[i]) words.push_back(flux_words(bands[i].light, *units[i]));
    for (const RotationMeasure& rm : rotation_measures(bands)) words.push_back(words_of(rm));
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace nullscope::cli
