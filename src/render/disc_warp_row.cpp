#include "render/disc_warp_row.h"

#include <cmath>

#include "scene/disc_shape.h"

namespace nullscope {

TexelGrid disc_warp_row(const DiscSpec& disc) {
    const DiscShape shape(disc, 0.0);
    TexelGrid row{kDiscWarpCells + 1, 1, {}};
    const double from = std::log(disc.inner) - kDiscWarpBeside,
                 all = std::log(disc.outer / disc.inner) + 2.0 * kDiscWarpBeside;
    for (int i = 0; i <= kDiscWarpCells; ++i) {
        const double r = std::exp(from + all * i / kDiscWarpCells);
        const Vec3 normal = shape.normal_in_base(r);
        for (const double value : {normal.x, normal.y, normal.z, shape.within(r)})
            row.texels.push_back(static_cast<float>(value));
    }
    return row;
}

}  // namespace nullscope
