// How the camera's axes stand to what is conserved of polarised light.
//
// Along a null geodesic with tangent k a vector f that is carried along it (and f.k = 0) keeps
//     kappa = F(k, f),   F = (r - i a cos(theta)) (e^0 ^ e^1 + i e^2 ^ e^3)
// (Walker and Penrose 1970), e^0 ... e^3 those of observer/spin_frame.h. That holds about Kerr's hole and Kerr and Newman's; in a
// spherical metric, where a = 0, it says that the angle between f and the normal of the ray's plane stays, with |kappa| for a measure.
// F is dual to itself: it is known by the complex vector G_i = F(e_0, e_i) of any frame. A photon of frequency w that reaches a camera
// from the direction n has, with f = cos(chi) a + sin(chi) b in the plane across n, a x b = -n,
//     kappa = w e^(-i chi) G.(a + i b).
#pragma once
#include <array>
#include <complex>

#include "observer/observer.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// G over r, along the camera's right, up and forward.
using ScreenForm = std::array<std::complex<double>, 3>;

// observer: of this camera. aberration: whether directions are those that the moving camera sees. Relative error: gamma^2 roundings.
ScreenForm screen_form(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer, bool aberration);

// G.(a + i b) of a direction n = (right, up, forward), unit: a and b are right and up, turned as forward is to n by the shortest way.
// Behind the camera there is none, and the result is of no use.
std::complex<double> screen_phase(const ScreenForm& form, Vec3 n);

}  // namespace nullscope
