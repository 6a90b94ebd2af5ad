#include "render/sky_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "render/picture_edges.h"
#include "sky/panorama.h"

namespace nullscope {

SkyAsked sky_asked(const Scene& scene, const EffectSet& effects) {
    const bool refined = effect_set(required_effects(scene)).contains(Effect::kRefine);
    const double ray = scene.camera.pixel() / scene.picture.samples;
    SkyAsked asked;
    if (effects.contains(Effect::kSky)) asked.near = scene.sky;
    if (effects.contains(Effect::kFarSky)) asked.far = scene.far_sky;
    asked.by_rays = std::min(2.0 / ray, 1e6);  // a texel in a face's middle spans 2/size rad
    asked.by_refined_rays = refined ? kRefined.front() * asked.by_rays : asked.by_rays;
    return asked;
}

SkyFaces sky_faces(const SkyAsked& asked, int largest) {
    constexpr double kLeast = 256, kUsual = kUsualSkyFace;  // px
    constexpr double kImageMost =
        sizeof(void*) > 4 ? 4096 : kUsual;  // 1 GB: more than a page's 32 bits of memory are for
    // So that texels show stripes of a pixel.
    constexpr double kTexelsAPixel = 1.5;
    std::vector<const SkySpec*> skies;
    for (const auto* sky : {&asked.near, &asked.far})
        if (*sky) skies.push_back(&**sky);
    const auto is_image = [](const SkySpec* sky) { return sky->kind == SkyKind::kImage; };
    SkyFaces faces{0, asked.by_rays, std::ranges::any_of(skies, is_image)};
    double size = std::min(asked.by_refined_rays, kUsual);
    if (asked.by_rays > kUsual && faces.halves && std::ranges::all_of(skies, is_image)) {
        double finest = 0.0;  // of the images; one that cannot be read is refused when it is loaded
        for (const SkySpec* sky : skies)
            if (const auto density = panorama_density(*sky)) finest = std::max(finest, 2.0 * kTexelsAPixel * *density);
        faces.asked = std::min(asked.by_rays, std::max(finest, kUsual));
        if (skies.size() == 1 && faces.asked > SkyFaces::kWorth * kUsual) size = kImageMost;
    }
    size = std::bit_ceil(static_cast<unsigned>(std::max(size, kLeast)));
    faces.size = std::min(static_cast<int>(size), largest);
    return faces;
}

std::string SkyFaces::words() const {
    if (!coarse()) return "camera.fov and camera.size: a texel a ray";
    return fmt::format("camera.fov and camera.size ask for faces of {:.0f} px, these have {}: details are lost", asked,
                       size);
}

}  // namespace nullscope
