// A disc whose rings lie in different planes, and which has gaps: as a scene says it (scene/disc_shape.h says what that means).
#pragma once
#include <vector>

namespace nullscope {

struct DiscWarp {
    // A row for each radius, r_s, growing: tilt and node of the ring there, deg, from the plane that DiscLean gives. All as long; none: flat.
    std::vector<double> radii{}, tilts_deg{}, nodes_deg{};
    std::vector<double> rings{};  // where they begin and end, r_s, growing, in pairs; none: one, from rim to rim
    bool bends() const { return !radii.empty(); }
    bool there() const { return bends() || !rings.empty(); }
    friend bool operator==(const DiscWarp&, const DiscWarp&) = default;
};

}  // namespace nullscope
