// Where a ray about a rotating hole meets a disc's plane that leans: shown the ray's steps one by one, it looks along them.
//
// The plane is that of Boyer and Lindquist's coordinates taken as flat spherical ones, as solid bodies are (kerr_bodies.h).
#pragma once
#include <optional>
#include <vector>

#include "reference/kerr_ray.h"
#include "scene/disc_plane.h"

namespace nullscope::reference {

class LeaningWatch {
public:
    // Of one ray.
    LeaningWatch(const KerrHole& hole, const DiscPlane& plane, int most) : hole_(hole), plane_(plane), most_(most) {}
    // Looks at a step, some microseconds.
    void see(const KerrStep& step);
    // Not those of light that comes out of the horizon to a camera that fell, within 1.04 of its radius.
    // In order, at most `most`, of the ray that was traced: `l` and `climb` over its energy.
    std::vector<PlaneCrossing> crossings(const KerrRay& ray) const;

private:
    struct Sample {
        double along, height, phi;
    };
    struct Met {
        KerrPlace place;
        double along, r_slope, theta_slope;  // by the affine parameter
    };
    Sample sample(double along, const KerrStep& step) const;
    void look_on(Sample next, const KerrStep& step, int halvings);
    void look_between(Sample from, Sample to, const KerrStep& step);
    void look_for_dip(Sample before, Sample middle, Sample after, const KerrStep& step);
    void meet(Sample from, Sample to, const KerrStep& step);

    KerrHole hole_;
    DiscPlane plane_;
    int most_;
    std::optional<Sample> before_, last_;
    std::optional<KerrStep> previous_;
    bool comes_out_ = false;
    std::vector<Met> met_;
};

}  // namespace nullscope::reference
