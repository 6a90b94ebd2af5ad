#include "telescope/flux.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "annotate/annotations.h"
#include "image/luminance.h"
#include "observer/picture_scale.h"
#include "plan/medium.h"
#include "scene/medium_bands.h"
#include "spacetime/registry.h"

namespace nullscope {

std::optional<double> pixel_on_sky(const Scene& scene) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto scale = spacetime ? picture_scale(**spacetime, scene.camera) : std::nullopt;
    const auto microarcsecond = length_of_microarcsecond(scene.object);
    if (!scale || !microarcsecond) return std::nullopt;
    constexpr double kMicroarcsecond = M_PI / 180.0 / 3600.0 * 1e-6;  // rad
    return scale->length_per_px() / *microarcsecond * kMicroarcsecond;
}

std::optional<FluxUnit> flux_unit(const Scene& scene, bool several) {
    if (several || !scene.medium || !scene.medium->by_frequency() || shows_bands(scene)) return std::nullopt;
    if (scene.sky.kind != SkyKind::kBlack || scene.disc || !scene.bodies.empty()) return std::nullopt;
    const auto pixel = pixel_on_sky(scene);
    if (!pixel) return std::nullopt;
    const MediumSpec& medium = *scene.medium;
    const double colours[] = {medium.colour.x, medium.colour.y, medium.colour.z};
    const auto brightest = std::ranges::max_element(colours);
    if (!(*brightest * medium.brightness > 0)) return std::nullopt;
    constexpr double kJansky = 1e-23;  // erg/(s cm^2 Hz)
    const double light = medium_light_cgs(medium.frequency_GHz) / (*brightest * medium.brightness);
    const float rgb[] = {static_cast<float>(colours[0]), static_cast<float>(colours[1]),
                         static_cast<float>(colours[2])};
    const double jansky = light * *pixel * *pixel / kJansky;
    return FluxUnit{jansky, static_cast<int>(brightest - colours), medium.frequency_GHz,
                    jansky * *brightest / luminance_of(rgb)};
}

Image<float> in_jansky(const Image<float>& linear, const FluxUnit& unit) {
    Image<float> flux(linear.width, linear.height, 1);
    for (int y = 0; y < linear.height; ++y)
        for (int x = 0; x < linear.width; ++x)
            flux.at(x, y)[0] = static_cast<float>(unit.jansky * linear.at(x, y)[unit.channel]);
    return flux;
}

double flux_of(const Image<float>& linear, const FluxUnit& unit, const std::array<int, 4>& part) {
    double sum = 0;
    for (int y = part[1]; y < part[3]; ++y)
        for (int x = part[0]; x < part[2]; ++x) sum += linear.at(x, y)[unit.channel];
    return unit.jansky * sum;
}

std::string flux_words(const Image<float>& linear, const FluxUnit& unit) {
    return fmt::format("{:.4g} Jy at {} GHz", flux_of(linear, unit, {0, 0, linear.width, linear.height}),
                       unit.frequency_GHz);
}

}  // namespace nullscope
