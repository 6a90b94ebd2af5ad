#include "telescope/sky_sum.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nullscope {

Visibility SkySum::at(Baseline baseline) const {
    Visibility found = grid.at(baseline);
    if (!band) return found;
    const Visibility more = band->at(baseline).all;
    for (std::size_t plane = 0; plane < found.size(); ++plane) found[plane] += more[plane];
    return found;
}

VisibilitySum SkySum::with_change(Baseline baseline) const {
    VisibilitySum sum = grid.with_change(baseline);
    double change = std::abs(coarse ? sum.all[0] - coarse->at(baseline)[0] : sum.change[0]);
    if (band) {
        const VisibilitySum more = band->at(baseline);
        for (std::size_t plane = 0; plane < sum.all.size(); ++plane) sum.all[plane] += more.all[plane];
        change += std::abs(more.change[0]);
    }
    sum.change[0] = change;
    return sum;
}

std::vector<VisibilitySum> SkySum::with_change(std::span<const Baseline> baselines) const {
    std::vector<VisibilitySum> sums(baselines.size());
    tbb::parallel_for(std::size_t{0}, baselines.size(), [&](std::size_t i) { sums[i] = with_change(baselines[i]); });
    return sums;
}

double reach_of(std::span<const Baseline> baselines, std::span<const VisibilitySum> sums) {
    std::vector<std::size_t> order(baselines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto length = [&](std::size_t i) { return std::hypot(baselines[i].u, baselines[i].v); };
    std::ranges::sort(order, std::ranges::greater(), length);
    double most = 0, reach = INFINITY;
    for (const std::size_t i : order) {
        most = std::max(most, std::abs(sums[i].all[0]));
        if (std::abs(sums[i].change[0]) > kReachShare * most) reach = length(i);
    }
    return reach;
}

}  // namespace nullscope
