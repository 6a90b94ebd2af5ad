#include "command/reference_inputs.h"

#include "base/assets.h"
#include "image/large_image.h"
#include "plan/effects.h"
#include "render/renderer.h"
#include "scene/bodies.h"
#include "sky/sky.h"

namespace nullscope::cli {

reference::Pictures ReferenceInputs::pictures(const Scene& scene) const {
    reference::Pictures all(disc ? &*disc : nullptr);
    for (const Body& body : scene.bodies)
        all.bodies.push_back(body.material.texture == TextureKind::kImage ? &bodies.at(body.material.image) : nullptr);
    return all;
}

Result<std::unique_ptr<const ReferenceInputs>> load_reference_inputs(const Scene& scene) {
    constexpr int kSkyFace = 2048;
    auto inputs = std::make_unique<ReferenceInputs>();
    TRY(sky, build_sky(scene.sky, assets_directory(), kSkyFace));
    inputs->sky = std::move(*sky);
    const EffectSet effects = effect_set(required_effects(scene));
    if (effects.contains(Effect::kFarSky)) {
        TRY(far_sky, build_sky(scene.far_sky, assets_directory(), kSkyFace));
        inputs->far_sky = std::move(*far_sky);
    }
    if (effects.contains(Effect::kDiscImage)) {
        TRY(image, load_disc_image(*scene.disc));
        inputs->disc = std::move(image->image);
    }
    for (const auto& file : body_images(scene)) {
        TRY(image, load_fitted_image(file));
        inputs->bodies[file] = std::move(image->image);
    }
    return std::unique_ptr<const ReferenceInputs>(std::move(inputs));
}

}  // namespace nullscope::cli
