// View directions whose rays, traced backward, spiral to the photon sphere, or about a rotating hole to a spherical photon orbit.
//
// Along the radial frame of the observer (observer.h; about a rotating hole spin_frame.h) a photon of energy 1 at infinity has
//     outward u + inward v = 2 F,   u v = T,   u = k0 - k1,   v = k0 + k1,   k2 = sqrt(T) sin(psi),   k3 = sqrt(T) cos(psi).
// Static, spherical: F = 1, T = (b/R)^2, b = 1/q_crit. Rotating: F = (r^2 + a^2 - a lambda)/Sigma, T = K/Sigma, and the orbit at r_p has
//     r_p^2 + a^2 - a lambda = 4 r_p Delta/Delta',   K = eta + (lambda - a)^2 = 16 r_p^2 Delta/Delta'^2
// (Bardeen 1973, Teo 2003; with charge in Delta). Light at the angle psi from e_phi belongs to the one r_p, for all a, theta and psi, of
//     (r_p^2 + a^2 cos^2(theta)) Delta' = 4 r_p (Delta + a sin(theta) cos(psi) sqrt(Delta)).
// Nothing is divided by a or sin(theta). Where the camera is outside of the orbit light comes from it outward, else inward.
#pragma once
#include <memory>
#include <optional>

#include "observer/lorentz.h"
#include "observer/observer.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// The photon sphere that light can reach: not one below a star's surface.
std::optional<PhotonSphere> open_photon_sphere(const Spacetime& spacetime);

class CriticalLight {
public:
    // spacetime outlives what is returned. Nothing where there is no photon sphere, light runs straight, or no such camera can be.
    static std::optional<CriticalLight> make(const Spacetime& spacetime, const CameraSpec& camera,
                                             const LightSpec& light);
    // Unit view direction along the camera's (right, up, backward), as the camera in its motion sees it. angle: psi, rad; over a full turn
    // the curve is closed. Within 1e-13 for slow cameras. A microsecond about a rotating hole, else less.
    Vec3 direction(double angle) const;

private:
    CriticalLight() = default;
    const AxialMetric* spinning_ = nullptr;
    CameraSpec camera_;
    PhotonSphere sphere_{};  // without spin
    double reach_ = 1;       // R of the camera, without spin
    Observer observer_;
    Lorentz to_camera_{};  // from the observer's own frame
    Mat3 axes_;            // of the camera
};

}  // namespace nullscope
