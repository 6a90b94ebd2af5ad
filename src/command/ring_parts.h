// A picture in two parts, for baselines that see its photon ring: a grid of pixels, and rays in a band along the critical curve (telescope/ring_chart.h).
#pragma once
#include "base/result.h"
#include "command/shot.h"
#include "command/sky_light.h"
#include "telescope/light_points.h"
#include "telescope/ring_chart.h"

namespace nullscope::cli {

struct SkyParts {
    SkyLight grid;  // without what the band has of the light
    LightPoints band;
    int across = 0, around = 0;  // rays of the band
    double share = 1;  // of light whose unit is its own picture's: by how much of both parts' the grid's was divided
};

// The band's places, before anything is drawn: as many across as ever, and along the curve a few for each fringe of the longest baseline,
// wavelengths. Errors (bad input): the picture has no scale on the sky; no critical curve, or the picture does not hold the band along it; [zoom], meshes.
inline constexpr int kBandAcross = 512, kLeastAround = 512, kMostAround = 4096;
Result<RingChart> ring_chart(const Scene& scene, double longest);

// captured: the shot's picture. Draws one more, of the chart's rays. Errors: those of sky_light().
Result<SkyParts> sky_parts(const Shot& shot, Session* session, const Exposure& shown, const DrawOptions& drawing,
                           const Captured& captured, const RingChart& chart);
// What the window leaves of a picture's light, of other pixels than the grid's: times SkyParts::share it is the same.
void take_band(const CameraSpec& camera, const RingChart& chart, SkyPicture& picture);

}  // namespace nullscope::cli
