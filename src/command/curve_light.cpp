#include "command/curve_light.h"

#include <fmt/format.h>

#include "command/band_pictures.h"
#include "scene/medium_bands.h"
#include "scene/projection.h"
#include "scene/stereo.h"

namespace nullscope::cli {

std::array<double, 4> light_in(const Image<float>& picture, const CameraSpec& camera, const PicturePixels& region) {
    std::array<double, 4> sum{};
    for (int y = region[1]; y < region[3]; ++y)
        for (int x = region[0]; x < region[2]; ++x) {
            const double angle = pixel_solid_angle(camera, x + 0.5, y + 0.5);
            const float* p = picture.at(x, y);
            for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c) + 1] += angle * p[c];
        }
    sum[0] = 0.2126 * sum[1] + 0.7152 * sum[2] + 0.0722 * sum[3];  // Rec. 709
    return sum;
}

std::vector<FluxColumn> flux_columns(const Scene& scene) {
    const bool several = scene.split || scene.camera.stereo != Stereo::kOff;
    std::vector<FluxColumn> columns;
    for (const auto& unit : band_units(scene, several))
        if (unit) columns.push_back({fmt::format("jansky_{}GHz", unit->frequency_GHz), *unit});
    if (has_bands(scene)) return columns;
    if (const auto unit = flux_unit(scene, several)) columns.push_back({"jansky", *unit});
    return columns;
}

std::vector<double> fluxes_in(const Captured& drawn, const std::vector<FluxColumn>& columns,
                              const PicturePixels& region) {
    std::vector<double> fluxes;
    for (std::size_t k = 0; k < columns.size(); ++k)
        fluxes.push_back(flux_of(drawn.bands.empty() ? drawn.linear : drawn.bands[k].light, columns[k].unit, region));
    return fluxes;
}

}  // namespace nullscope::cli
