// A sky's visibilities, of a grid of pixels and what else there is, and up to which baseline they hold.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "telescope/light_points.h"
#include "telescope/visibility.h"

namespace nullscope {

struct SkySum {
    PictureVisibility grid;
    std::optional<LightPoints> band{};
    std::optional<PictureVisibility> coarse{};  // the grid with half as many pixels a side, drawn by itself

    Visibility at(Baseline baseline) const;
    VisibilitySum with_change(Baseline baseline) const;  // change: of I, the magnitudes of both parts' in one
    std::vector<VisibilitySum> with_change(std::span<const Baseline> baselines) const;  // on all cores
};

// Wavelengths: the shortest baseline where fewer pixels (of `coarse`, else every second one) and every second ray change V by more than kReachShare of
// the most that |V| is from there on; infinite: none.
inline constexpr double kReachShare = 0.01;
double reach_of(std::span<const Baseline> baselines, std::span<const VisibilitySum> sums);

}  // namespace nullscope
