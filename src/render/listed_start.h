// Rays of a list that start as the camera of a frame does: what each is told, and what its crossings tell of the disc's matter.
#pragma once
#include <complex>
#include <optional>

#include "observer/screen_form.h"
#include "render/frame_tables.h"
#include "spacetime/circular_orbit.h"
#include "table/disc_light.h"

namespace nullscope {

class ListedStart {
public:
    // Of the last update; tables: outlives this. sense: of a disc's matter.
    ListedStart(const FrameTables& tables, Sense sense);
    // theta, phi: where it starts, of a rotating hole at the camera's theta. n: unit, in the observer's frame. at_angle: a swept angle for which
    // zeta is asked, 0 for none.
    RayNumbers numbers(double theta, double phi, Vec3 n, double at_angle) const;
    // The camera's frequency over that in a disc's matter where such a ray crosses the disc's plane, whatever parts of it the scene's light
    // leaves out. Outside of a horizon; not a
    // number where a leaning disc's matter would outrun light.
    double g(const RayNumbers& ray, const ListedRay::Crossing& met) const;

    // Q + iU over I of a disc's light there that is polarised so, on the screen of a camera that looks at the centre, north up. n: as numbers() was given it.
    // number: which crossing it is, 1 for the first.
    std::complex<double> polarised(const PolarisationSpec& spec, const RayNumbers& ray, Vec3 n,
                                   const ListedRay::Crossing& met, int number) const;

private:
    Vec3 velocity(const ListedRay::Crossing& met) const;  // u^t, u^phi about the disc's axis, g_rr u^r

    const FrameTables& tables_;
    Sense sense_;
    ScreenForm screen_;
    FrameData frame_;
    std::optional<DiscMatterFlow> flow_;  // where there may be discs
};

}  // namespace nullscope
