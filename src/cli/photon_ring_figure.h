// nullscope figure photon-ring: the subrings of a scene's photon ring, measured and computed.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::cli {

struct RingFigure {
    std::string table;  // for a person
    std::string csv, svg;
    std::string columns;  // of which image of what
};

// Subring n, 1 to rings: the rays whose crossing n of the disc's plane lies on the disc, or from 3 to 10 r_s. angles: psi of
// observer/critical_light.h, degrees; none: 90 without spin, six about a rotating hole. Errors: as reference::PhotonRing::make.
Result<RingFigure> photon_ring_figure(const Scene& scene, int rings, std::vector<int> angles);

}  // namespace nullscope::cli
