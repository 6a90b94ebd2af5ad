// The fan of all light rays through one camera radius, ordered by the angle from the radial direction.
//
// For a static camera at chi0 (spacetime.h) a ray at the angle beta from the INWARD radial has k = q/q_crit = sin(chi0)/sin(beta);
// it is critical at beta = chi0 (Synge 1966: the shadow's half-angle is chi0), captured below and escapes above.
// A star outside of its photon sphere: critical is the ray that grazes its surface. Where there is a wall the captured rays turn and come
// back to the sky; a camera further in than what divides has no critical direction, and delta is the angle from the centre's.
// Everything is a function of delta, the angle from the critical direction, on either side of it; 1 - k^2 comes from the
// product sin(beta - chi0) sin(beta + chi0), so that rays next to the critical one keep their digits.
#pragma once
#include <cmath>
#include <memory>
#include <optional>

#include "spacetime/spacetime.h"
#include "table/bounce.h"
#include "table/deflection_table.h"

namespace nullscope {

enum class Segment { kSky = 0, kCaptured = 1 };

struct FanRay {
    double beta;          // angle from the inward radial, (0, pi)
    double sin_beta, cos_beta;
    double phi_end;       // swept until infinity or until the horizon
    double in_tube;       // what of it is swept in a wormhole's tube
};

class RayFan {
public:
    // Static camera at radius r (outside the horizon). The table must belong to the spacetime; nullptr where there is a wall. pixel: angle that the frame's
    // smallest pixel spans, rad: deep zooms get finer cells next to the critical ray.
    RayFan(std::shared_ptr<const Spacetime> spacetime, std::shared_ptr<const DeflectionTable> table, double r, double pixel = 1.0);

    bool outside() const { return outside_; }               // of the photon sphere
    double critical_angle() const { return theta_c_; }      // from the nearer radial direction (inward outside), (0, pi/2]
    double critical_cosine() const { return outside_ ? -std::cos(theta_c_) : std::cos(theta_c_); }   // from the outward radial
    double critical_sine() const { return std::sin(theta_c_); }
    double delta_limit(Segment segment) const;              // largest delta
    // delta_limit < delta is the ray beyond the radial one, the mirror image of 2 delta_limit - delta: what is even in the angle
    // from the radial direction stays smooth across it.
    double mirrored(Segment segment, double delta) const;
    // 0 < delta <= delta_limit; the last 1e-9 rad before a radial ray are taken as 1e-9 (limits are finite ratios).
    FanRay ray(Segment segment, double delta) const;
    // Its sin_beta and in_tube alone, at the price of three sines; only of use where there is a tube.
    FanRay tube_ray(Segment segment, double delta) const;
    bool has_tube() const { return tube_out_ + tube_in_ > 0.0; }

    // The place u >= 1 in the cells of shaders/core/strip.glsl: u = 1 + w/w0, w = 2 tan(delta/2).
    double w0() const { return w0_; }                       // innermost cell scale, rad
    double delta_at(double u) const { return 2.0 * std::atan(0.5 * w0() * (u - 1.0)); }
    double delta_slope(double u) const;                     // d delta / d u
    int octaves(Segment segment) const;                     // of u, until delta_limit

    double zeta0() const { return zeta0_; }                 // 1/R
    double chi0() const { return chi0_; }
    const DeflectionTable& table() const { return *table_; }   // where there is one
    bool has_table() const { return table_ != nullptr; }
    double sqrt_v0() const { return sqrt_v0_; }              // sqrt(V(zeta0)) = q sin(alpha)
    const Spacetime& spacetime() const { return *spacetime_; }

    // Distance from the critical direction, relative to its angle, below which windings are no longer told apart: 1e-6 of the
    // shadow's radius is 0.004 px for a shadow that fills a 4K screen. Less for pixels of less than 1/kPixelPart of that, in steps
    // of 16, down to what doubles tell apart.
    static constexpr double kResolution = 1e-6, kPixelPart = 1.0 / 16, kFinest = 1e-13;

private:
    void start_at_wall(const Wall& wall);
    double to_surface(const FanRay& ray, double k, double one_minus_k2, double delta) const;
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const DeflectionTable> table_;
    double zeta0_, chi0_, q_crit_, sqrt_v0_, theta_c_, w0_;
    bool outside_;
    std::optional<Bounce> bounce_;        // where there is a wall
    double wall_v_ = 0, over_wall_ = 0;   // its V, and V(zeta0) minus that
    double tube_out_ = 0, tube_in_ = 0;   // a wormhole's tube on the way to the sky and to the other one, over its radius
    double chi_end_ = M_PI;   // where captured rays end: horizon, other sky, or the surface of a star,
    bool grazes_ = false;     //   which outside the photon sphere has the critical direction to itself
};

}  // namespace nullscope
