#include "render/picture_layers.h"

#include <algorithm>
#include <cmath>

#include "image/channels.h"
#include "image/luminance.h"
#include "plan/effects.h"
#include "render/renderer.h"

namespace nullscope {

namespace {

// Behind a polariser all light is polarised along its axis.
void pass_polariser(double axis, Image<float>& stokes) {
    for (std::size_t i = 0; i < stokes.data.size() / kStokesParameters; ++i) {
        float* of = &stokes.data[kStokesParameters * i];
        of[1] = of[0] * static_cast<float>(std::cos(2.0 * axis));
        of[2] = of[0] * static_cast<float>(std::sin(2.0 * axis));
        of[3] = 0.0f;
    }
}

// Of Q, U and V of the layer kStokes.
Image<float> stokes_of(Renderer& renderer, const Image<float>& light) {
    const Image<float> polarised = renderer.layer(PictureLayer::kStokes);
    Image<float> stokes(light.width, light.height, kStokesParameters);
    for (std::size_t i = 0; i < light.data.size() / 3; ++i) {
        const float *rgb = &light.data[3 * i], *part = &polarised.data[3 * i];
        float* of = &stokes.data[kStokesParameters * i];
        of[0] = luminance_of(rgb);
        std::copy_n(part, 3, of + 1);
    }
    const auto& axis = renderer.tables().plan().scene.picture.polariser;
    if (axis) pass_polariser(*axis, stokes);
    return stokes;
}

}  // namespace

PictureLayers draw_layers(Renderer& renderer) {
    const EffectSet& effects = renderer.tables().effects();
    const bool bodies = has_solids(effects) || effects.contains(Effect::kStar);
    PictureLayers layers;
    layers.all = renderer.layer(PictureLayer::kAll);
    const auto add = [&](const char* name, PictureLayer layer, const Image<float>& shares, int channel) {
        layers.each.push_back({name, renderer.layer(layer), channel_of(shares, channel)});
        for (float& share : layers.each.back().share) share = std::clamp(share, 0.0f, 1.0f);  // of differences, rounded
    };
    if (effects.contains(Effect::kDisc)) {
        const Image<float> shares = renderer.layer(PictureLayer::kDiscShares);
        add("disc0", PictureLayer::kDisc0, shares, 0);
        add("disc1", PictureLayer::kDisc1, shares, 1);
        add("disc2", PictureLayer::kDisc2, shares, 2);
    }
    const Image<float> shares = renderer.layer(PictureLayer::kOtherShares);
    if (bodies) add("bodies", PictureLayer::kBodies, shares, 0);
    if (has_medium(effects)) add("medium", PictureLayer::kMedium, shares, 2);
    add("sky", PictureLayer::kSky, shares, 1);
    if (polarises(effects)) layers.stokes = stokes_of(renderer, layers.all);
    layers.covered = channel_of(shares, 1);
    for (float& part : layers.covered) part = std::clamp(1.0f - part, 0.0f, 1.0f);
    return layers;
}

Image<float> draw_stokes(Renderer& renderer) {
    const Image<float> light = renderer.layer(PictureLayer::kAll);
    return stokes_of(renderer, light);
}

}  // namespace nullscope
