// Views into the photon ring, given by ZoomSpec: the picture's middle lies on the critical curve, and its directions are exp(-depth) as
// wide as the camera's field of view.
//
// Next to the critical direction a ray at the angle delta from it sweeps
//     phi = -a ln e + b + O(e ln e),   e = |delta|/sin(critical angle from the radial direction):
// its way to the photon sphere and its way from there are the same for all of them, only how often it goes round in between differs. Rays
// at delta and at delta exp(2 pi m / a) show the same, but for m turns: images of an order higher by 2 m, light that is later by m
// 2 pi b_c, with b_c = 1/q_crit the critical impact parameter. So a deep view is the view 2 pi m / a less deep, and depth costs
// nothing. What that leaves out is some kSimilar of a picture's size: less than 1e-4 px.
//
// About a rotating hole the same holds of each point of the critical curve with its spherical photon orbit (spacetime/photon_shell.h), whose
// light swings between two polar angles: e is spin_ring.h's, and a "turn" a whole swing of two half orbits, 2 gamma in ln e, in which the
// azimuth grows by twice the orbit's. Bodies that such an orbit meets are drawn in the turns that are left alone.
#pragma once
#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

inline constexpr double kDeepestZoom = 1000.0;  // depth; e^-1000 = 10^-434

// Largest e in a picture that stands for deeper ones.
inline constexpr double kSimilar = 1e-8;

struct RingView {
    // Without a zoom: yaw, pitch and plane_width of a view that shows the same; the middle is on the critical curve to 1e-16 rad.
    CameraSpec camera;
    double turns = 0;     // m
    double depth = 0;     // the zoom's own
    double lag = 0;       // m 2 pi b_c, or m times that of a swing, r_s/c
    double azimuth = 0;   // of m swings about a rotating hole, backward in time, modulo a turn; rad
    double half_way = 0;  // swept angle at which every ray of a view with m > 0 is next to the photon sphere, rad
};

// What to trace for a camera with a zoom. Errors: no photon sphere that light can reach, lensing off, a photon sphere with a tube or of light
// that winds other than by a logarithm, a spherical orbit whose images shrink too little each.
Result<RingView> ring_view(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light);

// The camera as one without a zoom: the same view to the digits of yaw and pitch. As it is without one. Errors: those of ring_view(), and
// pixels below kFinestDirection, rad, which no double direction tells apart.
inline constexpr double kFinestDirection = 1e-12;
Result<CameraSpec> without_zoom(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light);

}  // namespace nullscope
