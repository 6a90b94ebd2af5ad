// Light in Kerr by Hamilton's equations in Cartesian Kerr-Schild coordinates, step by step at a tight tolerance: nothing
// is separated, no constant of Carter and no potential of 1/r or theta is known, which is what the shader works with.
//
// A ray that is traced backward and inward leaves the hole's past horizon, where the ingoing chart is singular. Its
// mirror image under (t, phi) -> (-t, -phi) is a photon that falls in: that one is traced, forward, and its azimuths
// are turned over. One that is traced outward has fallen in where the chart is regular, and is traced as it is, through
// the horizon if the camera is inside.
//
// What is integrated are angular momentum, direction and distance (kerr_flow.h), and they begin as constants of motion
// that are products (kerr_launch.h). So a ray's answers are those of a ray whose impact parameter differs by at most
// 4e-13 r_s, wherever the camera stands: not by roundings of its place. Whether a ray is captured is sure where the
// shadow's edge is farther than that from it. The condition number of a ray says the same of the camera: it is the
// distance to the shadow's edge in roundings of the view direction, 1.1e-16 rad or 1.1e-16 r of impact parameter; below 1
// no direction in double precision says which side of the edge is meant. The reference takes the direction that it is
// given as exact: from 3600 r_s on the view's own rounding is larger than the reference's error.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "base/vec.h"
#include "reference/kerr_chart.h"
#include "reference/traced_ray.h"
#include "scene/ray.h"

namespace nullscope::reference {

// A photon at the camera, as the camera at rest there (without angular momentum) measures it: where it comes from and
// how much.
struct KerrStart {
    double r, theta, phi;  // Boyer and Lindquist, r_s; outside the horizon
    // towards where the photon comes from, times its frequency: components along e_r, e_theta, e_phi
    Vec3 direction;
};

// A photon at a camera anywhere outside the inner horizon, by components in ingoing coordinates along d_v, d_r, d_theta
// and d_phi~/sin(theta). phi: that azimuth (observer/spin_frame.h).
struct KerrPhoton {
    double r, theta, phi;
    std::array<long double, 4> p;
};
// The same, less Boyer and Lindquist's; r outside the horizon.
double kerr_azimuth_ahead(const KerrHole& hole, double r);

struct KerrRay {
    Fate fate = Fate::kNoSky;
    Vec3 sky{kNotANumber, kNotANumber, kNotANumber};  // unit direction, world axes; escaped rays
    double phi_inf = kNotANumber;                     // its azimuth, windings kept
    double energy = 0;                                // of the photon, at infinity
    double l_z = 0;                                   // its angular momentum about the axis over its energy, r_s
    // of the equatorial plane, before the end; along: 0 at the camera; delay as KerrPlace
    std::vector<PlaneCrossing> crossings;
    // T = v at the camera less v at the sky, v = t + r_*; escaped rays. To 1e-8 r_s/c and some roundings of r
    double delay = kNotANumber;
};

// On a ray outside the outer horizon.
struct KerrPlace {
    double r, theta, phi;  // Boyer and Lindquist's
    double delay;          // the camera's clock less t there: of a camera that falls v - r, else t
    Vec3 flat() const;     // (r, theta, phi) taken as flat spherical coordinates, r_s
};
// Of the sphere that has the larger of two radii: how far apart, round it and along the radius. Above the chord,
// whatever winds between them.
double way_between(const KerrPlace& from, const KerrPlace& to);

// The same from an interpolant (kerr_between.h), as matter asks for it.
struct KerrGlance {
    double r;
    Vec3 direction;               // of (theta, phi): unit, world axes
    double delay;                 // 0 if it was not asked for
    double r_slope, theta_slope;  // by `along`
};

// A place, and how it moves by the affine parameter of a photon of unit frequency in the camera, away from the camera; t: the time of Boyer and
// Lindquist.
struct KerrMotion {
    KerrPlace place;
    double r, theta, phi, t;
};

// A step of the tracer, as far as it is outside the outer horizon: from one value of the tracer's own parameter to
// another. That is the affine parameter but for a factor: it grows by 1/kerr_distance(place)^2 of it.
struct KerrStep {
    double from, to;
    KerrPlace begin, end;
    double nearest;  // no place of it has a smaller r
    // Within trace_kerr only. at: the step integrated anew, some microsecond. The others by an interpolant: some
    // microseconds for the first look, then a fifth of one.
    std::function<KerrPlace(double along)> at, between;
    std::function<KerrGlance(double along, bool timed)> glance;
    std::function<KerrMotion(double along)> motion;
};
// |x| of Kerr and Schild's Cartesian coordinates.
inline double kerr_distance(const KerrHole& hole, double r, double sine_theta) {
    return std::hypot(r, hole.a * sine_theta);
}
// Is shown every step, in order.
using KerrWatch = std::function<void(const KerrStep& step)>;

// hole: a/M in [0, 1), or that and Q/M. Directions within 4e-13 rad and places within 4e-12 r, or what the ray makes of 4e-13 r_s of its
// impact parameter.
KerrRay trace_kerr(const KerrHole& hole, const KerrStart& start, int most_crossings, const KerrWatch& watch = {});
// falls: the camera's clock is v - r.
KerrRay trace_kerr(const KerrHole& hole, const KerrPhoton& photon, int most_crossings, bool falls = false,
                   const KerrWatch& watch = {});
// The same of many rays in any number of lanes (kerr_lanes.h), the same bits. watches: one for each photon, or none.
std::vector<KerrRay> trace_kerr(const KerrHole& hole, const std::vector<KerrPhoton>& photons, int most_crossings,
                                bool falls = false, const std::vector<KerrWatch>& watches = {});

}  // namespace nullscope::reference
