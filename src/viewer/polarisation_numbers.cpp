#include "viewer/polarisation_numbers.h"

#include <algorithm>
#include <utility>

#include "render/picture_layers.h"
#include "scene/medium_bands.h"
#include "scene/projection.h"
#include "viewer/small_light.h"

namespace nullscope::viewer {
namespace {

constexpr int kMostMeasured_px = 320;  // of the longer side

Image<float> stokes_at(Renderer& renderer, const Scene& scene) {
    return renderer.prepare(scene) ? draw_stokes(renderer) : Image<float>();
}

}  // namespace

bool has_polarisation_numbers(const Scene& scene) { return is_polarised(scene) && !scene.split; }

std::optional<PolarisationNumbers> polarisation_numbers(Renderer& renderer, const Scene& scene) {
    Scene small = in_fewer_pixels(scene, kMostMeasured_px);
    const auto [x, y] = line_of_sight(small.camera);
    const Image<float> shown = stokes_at(renderer, small);
    if (shown.empty()) return std::nullopt;
    PolarisationNumbers numbers{stokes_measures(shown, x, y), {}};
    if (!has_bands(small) || !has_polarised_medium(small)) return numbers;
    small.picture.polariser.reset();  // behind one all angles are its own
    std::vector<BandPicture> bands;
    for (std::size_t i = 0; i < small.medium->bands_GHz.size(); ++i)
        bands.push_back({small.medium->bands_GHz[i], {}, stokes_at(renderer, at_band(small, i))});
    if (std::ranges::none_of(bands, [](const BandPicture& band) { return band.stokes.empty(); }))
        numbers.rotations = rotation_measures(bands);
    return numbers;
}

}  // namespace nullscope::viewer
