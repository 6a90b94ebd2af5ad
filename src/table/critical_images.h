// Where the images of a disc of high order lie, in the limit of many windings: shaders/planar/disc_thin.glsl draws them by it.
//
// A ray at the angle delta from the critical direction winds until phi = -a ln |delta| + B. So the radius r is met at the swept angle
// phi by the ray at delta = C(r) exp(-phi / a), C = +-exp((B - T(r)) / a), with T(r) what the ray still sweeps behind r: to the sky
// outside the photon sphere (C > 0), to the horizon inside it (C < 0). The image of crossing k is the ring between C(inner) and
// C(outer), times exp(-phi_k / a).
//
// The next term of that limit: with x = C(r) exp(-phi / a) the ray is at delta = x (1 + |x| (bend + log_bend log2 |x|)).
#pragma once
#include "table/ray_family.h"

namespace nullscope {

struct CriticalImages {
    double inner = 0, outer = 0;  // C of the rims, rad; positive on the sky's side
    double per_angle = 1;         // 1/a
    struct Bend {
        double constant = 0, logarithm = 0;  // 1/rad
    } inner_bend, outer_bend;
    double from_angle = 0;  // swept angle from which the critical ray is past the disc, close to the photon sphere
};

// Relative error of C some 1e-6: limits are taken at |delta| = 1e-7 of the critical angle. Of delta below 5e-4 for |x| up to 0.03 of the
// critical angle.
CriticalImages critical_images(const RayFamily& family, double inner, double outer);

// Swept from the camera to where the ray at delta is at r for the last time: on its way to the sky, or to its end. NaN: it does not come
// there. Outside the horizon.
double swept_to(const RayFamily& family, Segment segment, double delta, double r);
// The ray that is at r for the last time after the swept angle phi, without the limit: its delta, below 0 where r is within the photon
// sphere, down to 1e-300 of the critical angle. NaN: none next to the critical direction. Some microseconds.
double delta_of_image(const RayFamily& family, double r, double phi);

// What a ray that winds about the photon sphere sweeps at most within reach of a disc, between that and the sky, the horizon or the camera:
// further from both of its ends it meets none. Without bound where the disc comes within kDiscAside of the photon sphere's chi. rad.
inline constexpr double kDiscAside = 0.02;
double angle_about_disc(const RayFamily& family, double inner, double outer);

}  // namespace nullscope
