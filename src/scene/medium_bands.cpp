#include "scene/medium_bands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace nullscope {

void settle_bands(MediumSpec& medium) {
    if (medium.bands_GHz.empty()) return;
    const std::size_t band = medium.shown_band > 0 ? static_cast<std::size_t>(medium.shown_band) - 1 : 0;
    medium.frequency_GHz = medium.bands_GHz[std::min(band, medium.bands_GHz.size() - 1)];
}

bool has_bands(const Scene& scene) {
    return scene.medium && scene.medium->by_frequency() && scene.medium->bands_GHz.size() > 1;
}

bool shows_bands(const Scene& scene) {
    return has_bands(scene) && scene.medium->shown_band == 0 && !is_polarised(*scene.medium);
}

std::vector<std::size_t> bands_as_colours(const MediumSpec& medium) {
    const std::size_t count = medium.bands_GHz.size();
    if (count < kBandsAtOnce) return {0, count - 1};
    return {0, count / 2, count - 1};
}

Vec3 colour_of_band(std::size_t i, std::size_t count) {
    if (count < kBandsAtOnce) return i == 0 ? Vec3{1, 0.5, 0} : Vec3{0, 0.5, 1};
    return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
}

Scene at_band(Scene scene, std::size_t band) {
    if (!has_bands(scene)) return scene;
    MediumSpec& medium = *scene.medium;
    medium.frequency_GHz = medium.bands_GHz[band];
    medium.bands_GHz.clear(), medium.shown_band = 0;
    return scene;
}

std::vector<Scene> scenes_of_bands(const Scene& scene) {
    std::vector<Scene> scenes;
    for (std::size_t band = 0; has_bands(scene) && band < scene.medium->bands_GHz.size(); ++band)
        scenes.push_back(at_band(scene, band));
    return scenes;
}

std::string band_name(double frequency) {
    std::string name = fmt::format("{}GHz", frequency);
    std::ranges::replace(name, '.', ',');
    return name;
}

std::string frequency_words(const MediumSpec& medium) {
    if (medium.bands_GHz.empty()) return fmt::format("{} GHz", medium.frequency_GHz);
    return fmt::format("{} GHz", fmt::join(medium.bands_GHz, ", "));
}

}  // namespace nullscope
