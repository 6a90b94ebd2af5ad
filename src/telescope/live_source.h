// What telescopes on Earth would have of the scene in a window: how large a pixel is, where in the sky it is, at which frequency.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "image/image.h"
#include "scene/known_object.h"
#include "scene/scene.h"
#include "telescope/flux.h"
#include "telescope/sky_picture.h"

namespace nullscope {

struct LiveSource {
    double pixel = 0;             // rad, as seen from Earth
    std::string object;           // whose mass and distance these are
    bool assumed_object = false;  // the scene says none: M87*'s
    bool assumed_place = false;   // in the sky: M87*'s
    bool rough = false;  // the camera is near, moves or looks aside: a pixel spans what it does for one far away
    SkyPlace place{};    // ICRS
    double mass_suns = 0;
    double frequency_GHz = 230;    // of the light, or where that has none the Event Horizon Telescope's
    std::optional<FluxUnit> unit;  // of the scene's light; nothing: it is relative

    double hours(double time) const {  // of a scene's time, r_s/c
        return time * schwarzschild_radius_m(mass_suns) / kLight_m_s / 3600;
    }
};

// scene: with the size of the picture that is measured. Errors (bad input): a pixel has no size there: of a wormhole, inside a horizon, of another
// projection than a pinhole's.
Result<LiveSource> live_source(const Scene& scene);

// Linear light of that picture, RGB, as telescopes have it: in Jy, or so that it adds up to 1 (to 0 where all is dark).
SkyPicture live_picture(const Image<float>& linear, const LiveSource& source);

}  // namespace nullscope
