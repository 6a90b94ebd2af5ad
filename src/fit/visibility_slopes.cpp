#include "fit/visibility_slopes.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "command/sky_light.h"
#include "gradient/picture_visibility.h"
#include "scenefile/scene_keys.h"

namespace nullscope::fit {
namespace {

constexpr double kRayTolerance = 1e-6;  // of a step: well below the quadrature's
constexpr double kSeenThrough = 0.01;   // opacity of discs whose rims hide nothing: for what is said of others
constexpr double kScaleStep = 1e-6;     // of a parameter's range: the scale is a closed form

// Derivatives are by radians.
double unit_of(const std::string& key) {
    const auto named = [&](const SceneKey& row) { return full_name(row) == key; };
    const auto row = std::ranges::find_if(scene_keys(), named);
    return row != scene_keys().end() && row->unit.starts_with("deg") ? M_PI / 180 : 1;
}

Status check_only_a_disc(const Scene& scene) {
    if (scene.sky.kind != SkyKind::kBlack) return bad_key("sky.kind", "a sky that is not black", "black");
    if (scene.disc && scene.disc->material.texture == TextureKind::kGas)
        return bad_key("disc.texture", "clumps of gas", "plain");
    return Done{};
}

// Of ln of a pixel's size on the sky, by the k-th parameter.
Result<double> scale_slope(const SceneFamily& family, std::vector<double> values, std::size_t k) {
    const FreeParameter& one = family.free()[k];
    const double at = values[k], step = kScaleStep * (one.high - one.low), low = std::max(at - step, one.low),
                 high = std::min(at + step, one.high);
    double logarithms[2];
    for (const int side : {0, 1}) {
        values[k] = side == 0 ? low : high;
        TRY(scene, family.at(values));
        TRY(pixel, cli::sky_scale(*scene));
        logarithms[side] = std::log(*pixel);
    }
    return (logarithms[1] - logarithms[0]) / (high - low);
}

}  // namespace

Result<std::vector<Prediction>> visibility_slopes(const SceneFamily& family, const std::vector<double>& values,
                                                  std::span<const Baseline> baselines, bool is_complex) {
    TRY(scene, family.at(values));
    TRY(alone, check_only_a_disc(*scene));
    std::vector<std::string> keys;
    for (const FreeParameter& one : family.free()) keys.push_back(one.key);
    TRY(light, PictureLight::make(*scene, keys, kRayTolerance));
    TRY(pixel, cli::sky_scale(*scene));
    std::vector<Fringes> fringes;  // east is left, north is up
    for (const Baseline& one : baselines) fringes.push_back({-2 * M_PI * *pixel * one.u, -2 * M_PI * *pixel * one.v});
    const auto found = visibility_gradient(**light, fringes);
    if (!found && scene->disc->opacity > kSeenThrough)
        return bad_key("disc.opacity", "images of an opaque disc hide parts of each other", "0.01 or less");
    if (!found) return found.error();
    std::vector<Prediction> columns(keys.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        TRY(wider, scale_slope(family, values, k));
        const double unit = unit_of(keys[k]);
        for (std::size_t i = 0; i < baselines.size(); ++i) {
            const std::complex<double> value = found->value[i] / found->flux,
                                       by = (unit * found->by[k][i] + *wider * found->by_scale[i] -
                                             unit * found->flux_by[k] * value) /
                                            found->flux;
            if (is_complex)
                columns[k].push_back(by.real()), columns[k].push_back(by.imag());
            else
                columns[k].push_back((std::conj(value) * by).real() / std::abs(value));
        }
    }
    return columns;
}

}  // namespace nullscope::fit
