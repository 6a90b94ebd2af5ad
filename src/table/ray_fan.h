// The fan of all light rays through one camera radius, ordered by the angle from the radial direction.
//
// For a static camera at chi0 (spacetime.h) a ray at the angle beta from the INWARD radial has k = q/q_crit = sin(chi0)/sin(beta);
// it is critical at beta = chi0 (Synge 1966: the shadow's half-angle is chi0), captured below and escapes above.
// Everything is a function of w, the distance from the critical direction in rad, on either side of it; 1 - k^2 comes from the
// product sin(beta - chi0) sin(beta + chi0), so that rays next to the critical one keep their digits.
#pragma once
#include <memory>

#include "spacetime/spacetime.h"
#include "table/deflection_table.h"

namespace nullscope {

enum class Segment { kSky = 0, kCaptured = 1 };

struct FanRay {
    double beta;          // angle from the inward radial, (0, pi)
    double sin_beta, cos_beta;
    double phi_end;       // swept until infinity or until the horizon
};

class RayFan {
public:
    // Static camera at radius r (outside the horizon). The table must belong to the spacetime.
    RayFan(std::shared_ptr<const Spacetime> spacetime, std::shared_ptr<const DeflectionTable> table, double r);

    bool outside() const { return outside_; }               // of the photon sphere
    double axis() const { return outside_ ? -1.0 : 1.0; }   // strip angles are measured from axis * e_r: the near pole of the cone
    double critical_angle() const { return theta_c_; }      // from the axis, (0, pi/2]
    double w0() const { return kResolution * theta_c_; }    // innermost cell scale of the strip
    double w_limit(Segment segment) const;                  // largest w
    // w_limit < w < 2 w_limit is the ray beyond the radial one, the mirror image of 2 w_limit - w: what is even in the angle from
    // the radial direction stays smooth across it.
    double mirrored(Segment segment, double w) const;
    // 0 < w <= w_limit; the last 1e-9 rad before a radial ray are taken as 1e-9 (limits are finite ratios).
    FanRay ray(Segment segment, double w) const;

    double zeta0() const { return zeta0_; }
    double chi0() const { return chi0_; }
    const DeflectionTable& table() const { return *table_; }
    double sqrt_v0() const { return sqrt_v0_; }              // sqrt(V(zeta0)) = q sin(alpha)
    const Spacetime& spacetime() const { return *spacetime_; }

    // Distance from the critical direction, relative to its angle, below which windings are no longer told apart: 1e-6 of the
    // shadow's radius is 0.004 px for a shadow that fills a 4K screen.
    static constexpr double kResolution = 1e-6;

private:
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const DeflectionTable> table_;
    double zeta0_, chi0_, q_crit_, sqrt_v0_, theta_c_;
    bool outside_;
};

}  // namespace nullscope
