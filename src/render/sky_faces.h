// How fine the faces of the sky are.
#pragma once
#include <optional>
#include <string>

#include "plan/effects.h"
#include "scene/scene.h"

namespace nullscope {

// What a scene asks of the faces of its skies, px along a side: by its rays, and by those of pixels that are refined.
struct SkyAsked {
    std::optional<SkySpec> near, far;
    double by_rays = 0.0, by_refined_rays = 0.0;
    friend bool operator==(const SkyAsked&, const SkyAsked&) = default;
};
SkyAsked sky_asked(const Scene& scene, const EffectSet& effects);

// Faces of the skies, px along a side: as fine as the rays, a power of two from 256 to 2048, of the image of one sky to 4096, if it is so fine;
// at most `largest`. Looks into the image's file where the rays ask for more than 2048.
inline constexpr int kUsualSkyFace = 2048;
struct SkyFaces {
    static constexpr double kWorth = 1.2;  // a fifth more is not worth four times the memory: 1 GB at 4096
    int size = 0;
    double asked = 0.0;   // what rays, and the image, ask for
    bool halves = false;  // half floats: there is an image
    bool coarse() const { return asked > kWorth * size; }
    std::string words() const;  // why they have this size, and what they lack
};
SkyFaces sky_faces(const SkyAsked& asked, int largest);

}  // namespace nullscope
