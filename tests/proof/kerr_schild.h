// A second formulation of light rays: Hamilton's equations in Cartesian Kerr-Schild coordinates, integrated step by step.
//
// ds^2 = -dt^2 + dx^2 + f (dt + e x.dx/r)^2 with f = 1 - A. The chart e = +1 is regular where matter falls in, e = -1 where light
// comes out: a ray traced backward in time to the horizon crosses it in the second, one that came through the horizon in the
// first. Nothing is taken from src/ but the question and the answer's type: no orbital plane, no impact parameter, no elliptic
// function. In long double, so that what is compared is the rounding of the reference.
#pragma once
#include <optional>
#include <vector>

#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::proof {

using Long = long double;

struct LongVec {
    Long x = 0, y = 0, z = 0;
};

struct IntegratedRay {
    Fate fate = Fate::kNoSky;
    LongVec direction;  // to the sky, or of the place on the horizon; unit, world axes
    Long angle = 0;     // swept, windings kept
    Long delay = 0;     // v_camera - v_infinity; escaped rays
    struct Crossing {
        Long angle, r, slope;  // slope: dr / d angle
        LongVec place;
    };
    std::vector<Crossing> crossings;  // of the equatorial plane, in order
    int steps = 0;
};

// A camera's view direction in its static or raindrop frame, not normalised; r - 1 apart, because a small change of it is lost
// in r.
struct LongQuery {
    Long r_minus_1, theta, phi;
    LongVec n;
    LocalFrame frame = LocalFrame::kStatic;
};
LongQuery long_query(const RayQuery& query);

// f(r) = mass/r - charge2/r^2 in units of r_s; nothing for a metric that is not known here.
struct KerrSchildMetric {
    Long mass = 0, charge2 = 0;
};
std::optional<KerrSchildMetric> kerr_schild_metric(const SpacetimeSpec& spec);

// tolerance: of each step, relative.
IntegratedRay integrate(const KerrSchildMetric& metric, const LongQuery& query, int crossings, Long tolerance = 1e-18L);

}  // namespace nullscope::proof
