#include "render/picture_layers.h"

#include <algorithm>

#include "image/channels.h"
#include "plan/effects.h"
#include "render/renderer.h"

namespace nullscope {

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
    layers.covered = channel_of(shares, 1);
    for (float& part : layers.covered) part = std::clamp(1.0f - part, 0.0f, 1.0f);
    return layers;
}

}  // namespace nullscope
