#include "command/reference_inputs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/assets.h"
#include "image/large_image.h"
#include "plan/effects.h"
#include "plan/medium.h"
#include "render/body_images.h"
#include "render/renderer.h"
#include "scene/bodies.h"
#include "sky/sky.h"
#include "spacetime/registry.h"

namespace nullscope::cli {

reference::Pictures ReferenceInputs::pictures(const Scene& scene) const {
    reference::Pictures all(disc ? &*disc : nullptr);
    for (const Body& body : scene.bodies)
        all.bodies.push_back(body.material.texture == TextureKind::kImage ? &bodies.at(body.material.source())
                                                                          : nullptr);
    return all;
}

Result<std::unique_ptr<const ReferenceInputs>> load_reference_inputs(const Scene& scene) {
    constexpr int kLeastFace = 2048, kMostFace = 4096;  // px
    const EffectSet effects = effect_set(required_effects(scene));
    const int face = std::max(kLeastFace, sky_faces(sky_asked(scene, effects), kMostFace).size);
    auto inputs = std::make_unique<ReferenceInputs>();
    const auto take_notes = [&](std::vector<std::string>& notes) {
        std::ranges::move(notes, std::back_inserter(inputs->notes));
    };
    SkySpec spec = scene.sky;
    if (spec.uniform_stars > 0) spec.kind = SkyKind::kBlack;  // there is nothing but these stars
    TRY(sky, build_sky(spec, assets_directory(), face));
    take_notes(sky->notes);
    inputs->sky = std::move(*sky);
    if (effects.contains(Effect::kFarSky)) {
        TRY(far_sky, build_sky(scene.far_sky, assets_directory(), face));
        take_notes(far_sky->notes);
        inputs->far_sky = std::move(*far_sky);
    }
    if (effects.contains(Effect::kDiscImage)) {
        TRY(image, load_disc_image(*scene.disc));
        take_notes(image->notes);
        inputs->disc = std::move(image->image);
    }
    for (const ImageSource& source : body_images(scene)) {
        TRY(image, load_fitted_image(source.file, body_image_limits(ImageLimits().max_side, source.layer)));
        take_notes(image->notes);
        inputs->bodies[source] = std::move(image->image);
    }
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    if (std::string word = medium_note(**spacetime, scene); !word.empty()) inputs->notes.push_back(std::move(word));
    return std::unique_ptr<const ReferenceInputs>(std::move(inputs));
}

}  // namespace nullscope::cli
