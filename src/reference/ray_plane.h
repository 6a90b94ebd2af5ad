// The plane of a ray's motion: from swept angles to directions in world axes, unwrapped azimuths, equatorial crossings.
#pragma once
#include "base/vec.h"

namespace nullscope::reference {

class RayPlane {
public:
    // The camera's polar angle and azimuth, the view direction (n_r, n_theta, n_phi) in the static or rain frame.
    // An exactly radial direction has no plane: the meridian's is taken.
    // normal: of the plane that crossing() asks about, the equatorial one if not given.
    RayPlane(double theta, double phi, Vec3 n, Vec3 normal = {0, 0, 1});
    // Unit vector, world axes, of the ray's place after a swept angle.
    Vec3 direction(double angle) const;
    // Its azimuth, continuous along the ray, starting at the camera's phi: every half turn of the ray adds pi. (Through
    // the axis the azimuth jumps by pi, towards growing phi.)
    double azimuth(double angle) const;
    // Direction of the orbital angular momentum of a particle that leaves the camera along the ray: unit vector, world axes.
    Vec3 axis() const;
    // Swept angle of the k-th crossing of the plane after the camera, k >= 1; infinite if it stays there.
    double crossing(int k) const;

private:
    double sin_theta_, cos_theta_, phi_;
    double across_theta_, across_phi_;  // unit vector of the motion across the radius, along (e_theta, e_phi)
    double first_crossing_;
};

}  // namespace nullscope::reference
