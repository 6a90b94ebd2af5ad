#include "reference/ray_plane.h"

#include <cmath>
#include <limits>

namespace nullscope::reference {
namespace {

// A camera this close to the equator is on it: cos(theta) of the double nearest to pi/2 is 6e-17, not 0.
constexpr double kAlongEquator = 1e-12;
// A motion this close to the plane stays in it: less than the rounding of a direction.
constexpr double kPlaneOfRay = 1e-15;

}  // namespace

RayPlane::RayPlane(double theta, double phi, Vec3 n, Vec3 normal)
    : sin_theta_(std::sin(theta)), cos_theta_(std::cos(theta)), phi_(phi) {
    const double across = std::hypot(n.y, n.z);
    across_theta_ = across > 0 ? n.y / across : -1.0;
    across_phi_ = across > 0 ? n.z / across : 0.0;
    // Height begin cos(a) - fall sin(a) = 0; over the equatorial plane cos(theta) cos(a) - across_theta sin(theta) sin(a).
    const bool leans = normal != Vec3{0, 0, 1};
    const double begin = leans ? dot(normal, direction(0)) : cos_theta_,
                 fall = leans ? -dot(normal, cross(axis(), direction(0))) : across_theta_ * sin_theta_;
    if (std::abs(begin) < kAlongEquator) {
        first_crossing_ = std::abs(fall) < kPlaneOfRay ? std::numeric_limits<double>::infinity() : M_PI;
    } else {
        first_crossing_ = std::atan2(begin, fall);
        if (first_crossing_ <= 0) first_crossing_ += M_PI;
    }
}

Vec3 RayPlane::axis() const {
    const double x = -across_phi_ * cos_theta_, y = across_theta_;  // azimuth 0 at the camera
    const double cp = std::cos(phi_), sp = std::sin(phi_);
    return {cp * x - sp * y, sp * x + cp * y, across_phi_ * sin_theta_};
}

Vec3 RayPlane::direction(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const double x = sin_theta_ * c + across_theta_ * cos_theta_ * s, y = across_phi_ * s;  // azimuth 0 at the camera
    const double cp = std::cos(phi_), sp = std::sin(phi_);
    return {cp * x - sp * y, sp * x + cp * y, cos_theta_ * c - across_theta_ * sin_theta_ * s};
}

double RayPlane::azimuth(double angle) const {
    const double half_turns = std::floor(angle / M_PI), rest = angle - half_turns * M_PI;
    const double c = std::cos(rest), s = std::sin(rest);
    const double x = sin_theta_ * c + across_theta_ * cos_theta_ * s, y = std::abs(across_phi_) * s;
    const double swept = half_turns * M_PI + std::atan2(std::abs(y), x);
    return across_phi_ < 0 ? phi_ - swept : phi_ + swept;
}

double RayPlane::crossing(int k) const { return first_crossing_ + (k - 1) * M_PI; }

}  // namespace nullscope::reference
