// Numbers of a spacetime that textbooks give names, and those of a camera in it.
#pragma once
#include <array>
#include <optional>

#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// Radii in r_s (of wormholes: in their own unit); nothing where the spacetime has none, or a star covers it. About a rotating hole orbits are those in the
// equatorial plane, towards growing phi (prograde where a > 0) and, as "retrograde", towards falling phi. Cost: 20 us, 40 us about a rotating hole.
struct Landmarks {
    std::optional<double> horizon, photon_orbit, isco;
    bool singular = false;                                           // the horizon is a singular surface, of no area
    std::optional<double> retrograde_photon_orbit, retrograde_isco;  // about rotating holes alone
    std::optional<double>
        critical_impact;  // b = L/E of the light that spirals to the photon sphere (not about rotating holes)
};
Landmarks landmarks_of(const Spacetime& spacetime);

// Of the camera's place and motion.
struct CameraNumbers {
    // dtau/dt of an observer there who does not rotate about the hole against the local frames (of a static one without spin); 1 over it is the
    // blueshift of light that comes from far away to it. Nothing inside a horizon.
    std::optional<double> lapse;
    // dtau/dt of the camera itself, outside of a horizon: every observer where rays are planar, about a rotating hole zamo. Of a frame of
    // energy eps and proper velocity w inward (spacetime/radial_frame.h) and a velocity v in it: A/(gamma (eps - w v_r)).
    std::optional<double> clock_rate;
    // Angular radius of the shadow, rad, seen at rest there: sin = sqrt(A)/R / q_crit (Synge 1966), more than pi/2 inside the photon sphere.
    std::optional<double> shadow;
    // Of a rotating hole: angular width (along e_phi) and height of the shadow, rad, seen by an observer without angular momentum (zamo) there:
    // extent of the critical curve (critical_light.h). Nothing where such an observer sees it fill half of the sky, or cannot be.
    std::optional<std::array<double, 2>> shadow_size;
    std::optional<double> orbit_speed,
        orbit_period;  // of a circular geodesic, by observers at rest and in coordinate time, r_s/c
};
// Cost: 20 us, about a rotating hole 0.1 ms.
CameraNumbers camera_numbers(const Spacetime& spacetime, const CameraSpec& camera);

}  // namespace nullscope
