// The family of all light rays through one camera radius, ordered by the angle alpha from the outward radial in a radial frame
// (spacetime/radial_frame.h): that of a camera at rest, or of one that falls, on the horizon and inside as well.
//
// With t = tan(alpha/2), o = outward, i = inward, R the areal radius and q_d the q of the ray that divides those that come from the sky
// from the others (q_crit; a star outside of its photon sphere: the ray that grazes its surface; a barrier: the one that winds about it)
//     q = (o + i t^2)/(2 R t),   d zeta/d phi at the camera = -(o - i t^2)/(2 R t),
//     t_d = o/(q_d R (1 - c)),   c^2 = 1 - V(zeta0)/q_d^2,  c > 0 further out than where the dividing ray winds,
//     1 - (q/q_d)^2 = (t - t_d) (-2 q_d R c - i (t - t_d)) (2 q_d R t + o + i t^2)/(2 q_d R t)^2,
// a product: rays next to the dividing one keep their digits, on the photon sphere and on the horizon too. For a camera at rest
// t_d = cot(chi0/2) (Synge 1966: the shadow's half-angle is chi0).
// A camera further in than what divides, where there is a barrier, has no dividing direction: delta is the angle from the centre's.
#pragma once
#include <cmath>
#include <memory>
#include <optional>

#include "spacetime/radial_frame.h"
#include "spacetime/spherical_metric.h"
#include "table/deflection_table.h"

namespace nullscope {

enum class Segment { kSky = 0, kCaptured = 1 };

struct FanRay {
    double beta;  // angle from the inward radial, pi - alpha, (0, pi)
    double sin_beta;
    double q;           // below 0: light from no sky that ever was (inside the horizon)
    double slope;       // d zeta / d phi at the camera
    double phi_end;     // swept until infinity or until the horizon
    double in_tube;     // what of it is swept in a wormhole's tube
    double tube_slope;  // |dl/d phi| there over the throat's radius, sqrt((q/q_crit)^2 - 1); 0 of rays that do not pass
};

class RayFamily {
public:
    // frame: of a camera at radius r. The table must belong to the spacetime; nullptr where there is a barrier. pixel: angle that the
    // frame's smallest pixel spans, rad: small ones get finer cells next to the critical ray. zoom: of a view whose directions are counted
    // from the critical one; no ray is further from that, rad.
    RayFamily(std::shared_ptr<const SphericalMetric> spacetime, std::shared_ptr<const DeflectionTable> table, double r,
              RadialFrame frame, double pixel = 1.0, std::optional<double> zoom = {});

    bool beyond() const { return c_ > 0.0; }            // of where the dividing ray winds: outside the photon sphere
    double critical_angle() const { return theta_c_; }  // from the nearer radial direction, (0, pi/2]
    // Of its angle from the outward radial.
    double critical_cosine() const { return from_inward_ ? -std::cos(theta_c_) : std::cos(theta_c_); }
    double critical_sine() const { return std::sin(theta_c_); }
    double delta_limit(Segment segment) const;  // largest delta
    // delta_limit < delta is the ray beyond the radial one, the mirror image of 2 delta_limit - delta: what is even in the angle
    // from the radial direction stays smooth across it.
    double mirrored(Segment segment, double delta) const;
    // 0 < delta <= delta_limit; the last 1e-9 of the critical angle (at most 1e-9 rad) before a radial ray are taken
    // as that (limits are finite ratios).
    FanRay ray(Segment segment, double delta) const;
    // Its sin_beta and in_tube alone, at the price of three sines; only of use where there is a tube.
    FanRay tube_ray(Segment segment, double delta) const;
    bool has_tube() const { return tube_out_ + tube_in_ > 0.0; }

    // The place u >= 1 in the cells of shaders/core/strip.glsl: u = 1 + w/w0, w = 2 tan(delta/2).
    double w0() const { return w0_; }  // innermost cell scale, rad
    double delta_at(double u) const { return 2.0 * std::atan(0.5 * w0() * (u - 1.0)); }
    double delta_slope(double u) const;  // d delta / d u
    int octaves(Segment segment) const;  // of u, until delta_limit, or what a zoom sees
    // Of the orbit table: cells of the swept angle, and of u in an octave.
    int orbit_rows() const { return zoom_ ? 256 : 128; }  // ORBIT_ROWS
    int orbit_cells() const { return zoom_ ? 24 : 12; }   // ORBIT_CELLS_PER_OCTAVE
    bool same_cells(const RayFamily& other) const;        // whether the tables of both have the same nodes in delta
    void add_octave() { spare_octaves_ = 1; }             // one more of each, of rays beyond the radial one

    double zeta0() const { return zeta0_; }  // 1/R
    double camera_r() const { return r_; }
    double chi0() const { return chi0_; }        // pi inside the horizon
    double chi_end() const { return chi_end_; }  // where rays end that do not reach the sky
    // |d zeta/d phi| of a ray at zeta = 0, sqrt(q^2 - V).
    double slope_at_sky(double q) const { return std::sqrt(q * q - v_sky_); }
    const RadialFrame& frame() const { return frame_; }
    // Tangent of half the angle from the outward radial of the inward ray with this q, the last of larger q on that side: where a
    // sphere's edge is seen. Only outside the horizon and of rays that pass here.
    double half_tangent_inward(double q) const;
    // Swept on a ray of this q > 0 between the horizon and the camera; 0 outside the horizon.
    double swept_inside(double q) const;
    const DeflectionTable& table() const { return *table_; }  // where there is one
    const SphericalMetric& spacetime() const { return *spacetime_; }

    // Distance from the critical direction, relative to its angle, below which windings are no longer told apart: 1e-6 of the
    // shadow's radius is 0.004 px for a shadow that fills a 4K screen. Less for pixels of less than 1/kPixelPart of that, in steps
    // of 16, down to what doubles tell apart, of a zoom to kFinestRing.
    static constexpr double kResolution = 1e-6, kPixelPart = 1.0 / 16, kFinest = 1e-13, kFinestRing = 1e-25;

private:
    struct Separatrix {
        double reach, c, t;  // q_d R, c and t_d of above
    };
    Separatrix separatrix(double q, double c, double v_over_q2) const;
    double one_minus_k2(const Separatrix& separatrix, double t, double t_minus) const;
    struct Place;
    Place place_at(Segment segment, double delta) const;
    void separate_at_barrier();
    void separate_at_ridge();
    void separate_at(double top, double over, bool outside);
    double swept(Segment segment, const FanRay& ray, double d) const;
    double to_surface(double k, double one_minus_k2, double one_minus_kd2, double alpha, double beta) const;
    std::shared_ptr<const SphericalMetric> spacetime_;
    std::shared_ptr<const DeflectionTable> table_;
    RadialFrame frame_;
    std::optional<double> zoom_;
    double r_, radius_, zeta0_, chi0_ = 0, q_crit_, theta_c_, c_, w0_;
    int spare_octaves_ = 0;
    double lapse_ = 0;                   // sqrt(A); 0 inside the horizon
    bool inside_ = false, from_inward_;  // of the horizon; whether the inward radial is the nearer one
    Separatrix separatrix_;              // sky from the rest
    std::optional<Barrier> barrier_;
    const PotentialSurvey* potential_ = nullptr;
    double top_ = 0, over_top_ = 0;  // V of what divides, a barrier or a ridge, and V(zeta0) less that
    double tube_out_ = 0,
           tube_in_ = 0;  // a wormhole's tube on the way to the sky and to the other one, over its radius
    double v_sky_ = 0.0,
           of_range_ = 1.0;  // V far out, and q_crit^2/(q_crit^2 - that): the table's k and chi are of V less v_sky_
    double chi_end_ = M_PI;  // where captured rays end: horizon, other sky, or the surface of a star,
    bool grazes_ = false;    //   which outside the photon sphere has the critical direction to itself:
    Separatrix photon_;      //   then of the photon sphere
};

}  // namespace nullscope
