#include "reference/medium_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plan/medium.h"

namespace nullscope::reference {
namespace {

// Nodes beside a place, and the second one's weight.
struct Beside {
    std::array<int, 2> node;
    double part;
};

Beside between(const MediumGrid::Axis& axis, double at) {
    const double last = axis.count - 1, number = std::clamp((at - axis.first) / axis.step, 0.0, last),
                 low = std::min(std::floor(number), last - 1);
    return {{static_cast<int>(low), static_cast<int>(low) + 1}, number - low};
}

Beside all_round(const MediumGrid::Axis& axis, double at) {
    const double number = (at - axis.first) / axis.step, low = std::floor(number);
    const int first = static_cast<int>(low - axis.count * std::floor(low / axis.count)) % axis.count;
    return {{first, (first + 1) % axis.count}, number - low};
}

}  // namespace

MatterState grid_matter(const GridMoment& moment, double scale, double horizon, double r, double theta, double phi) {
    const MediumGrid& grid = moment.before;
    r = std::max(r, horizon + 1e-9);
    if (grid.kerr_schild() && grid.spin() != 0 && horizon > 0) {  // d phi = d phi_BL + a/Delta dr, lengths in r_s = 2M
        const double a = 0.5 * grid.spin(), inner = 1 - horizon, apart = horizon - inner;
        phi += apart > 1e-9 ? a / apart * std::log1p(-apart / (r - inner)) : -a / (r - inner);
    }
    const Beside rings = between(grid.rings(), std::log(r)), polar = between(grid.polar(), theta),
                 around = all_round(grid.around(), phi);
    std::array<double, MediumGrid::kNumbers> mean{};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double weight = (i != 0 ? rings.part : 1 - rings.part) * (j != 0 ? polar.part : 1 - polar.part) *
                              (k != 0 ? around.part : 1 - around.part);
        const float *node = grid.node(rings.node[i], polar.node[j], around.node[k]),
                    *later = moment.after.node(rings.node[i], polar.node[j], around.node[k]);
        for (std::size_t n = 0; n < mean.size(); ++n) {
            const double first = node[n], second = later[n];
            mean[n] += weight * (first + moment.part * (second - first));
        }
    }
    const double field = std::hypot(mean[5], mean[6], mean[7]), over = field > 0 ? 1 / field : 0;
    return {std::min(scale * std::exp2(mean[0]), MediumGrid::kDensest),
            std::exp2(mean[4]),
            std::sqrt(scale) * field,
            {over * mean[5], over * mean[6], over * mean[7]},
            {std::clamp(mean[1] / grid.fall(r), -kFastestMatter, kFastestMatter), mean[2], mean[3]}};
}

}  // namespace nullscope::reference
