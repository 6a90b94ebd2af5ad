// Numbers of a spacetime that textbooks give names, and those of a camera in it.
#pragma once
#include <optional>

#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// Radii in r_s (of wormholes: in their own unit); nothing where the spacetime has none. About a rotating hole orbits are those towards
// growing phi, in the equatorial plane. Cost: 20 us.
struct Landmarks {
    std::optional<double> horizon, photon_orbit, isco;
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
    std::optional<double> orbit_speed,
        orbit_period;  // of a circular geodesic, by observers at rest and in coordinate time, r_s/c
};
CameraNumbers camera_numbers(const Spacetime& spacetime, const CameraSpec& camera);

}  // namespace nullscope
