// What a static, spherically symmetric metric has beyond Spacetime:
//     ds^2 = -A dt^2 + B dr^2 + R^2 dOmega^2.
// r is the areal radius of holes and stars (R = r), the proper distance from the throat of wormholes (r < 0 on the far
// side).
//
// Light is governed by V = A/R^2 alone. Where V has a greatest value q_crit^2, at the photon sphere, it defines the
// angle chi,
//     V = q_crit^2 sin^2(chi):  0 at infinity, pi/2 on the photon sphere, pi where V vanishes again (horizon, other sky),
//     dphi = h(chi) dchi / sqrt(k^2 - sin^2 chi),   k = q/q_crit,  q = E/L:
// the metric enters the deflection table only through the smooth function h.
//
// With a cosmological constant A falls as -Lambda r^2/3 and V goes to v_s = -Lambda/3 far out, where it is as regular as elsewhere. Orbits
// depend on q^2 - V alone: with V - v_s, q^2 - v_s and q_crit^2 - v_s in the place of V, q^2 and q_crit^2 all of the above holds. The
// horizon then lies at V = 0 before chi = pi, and static cameras between it and the cosmological one.
#pragma once
#include "spacetime/spacetime.h"

namespace nullscope {

struct PotentialSurvey;

// V where it grows without bound inward and every ray turns (metrics with R = r, V a quartic): about zeta_d, where rays
// divide, V = v + x (c[0] + x (c[1] + x (c[2] + x c[3]))), x = zeta - zeta_d. c[0] = 0: a photon sphere, the only one
// that cameras stand outside of.
struct Barrier {
    double zeta, v;
    std::array<double, 4> c;
};

// A = (1 - outer zeta)(1 - inner zeta), outer >= inner.
struct LapseRoots {
    double outer, inner;
};

// The angle chi of a radius and back, where there is a photon sphere. Relative error < 1e-15 near infinity.
class ChiMap {
public:
    virtual double chi_from_radius(double r) const = 0;
    virtual double radius_from_chi(double chi) const = 0;
    virtual double bending_density(double chi) const = 0;  // h(chi), chi in [0, pi]
    // h holds chi ln(chi) at its ends (R = l + ln l far out): the table's nodes crowd there.
    virtual bool logarithm_at_sky() const { return false; }

protected:
    ~ChiMap() = default;
};

// Of chi_from_radius: aborts with the name of the metric's class unless r >= first, where its chi begins.
void require_chi(const char* metric, double r, double first);

// The orbit equation zeta'' = -half_v_slope(zeta) of zeta = 1/r; metrics with R = r.
class OrbitEquation {
public:
    virtual double half_v_slope(double zeta) const = 0;      // d(A zeta^2)/dzeta / 2
    virtual double half_v_curvature(double zeta) const = 0;  // its derivative
    virtual double lapse_slope(double zeta) const = 0;       // dA/dzeta
    virtual double lapse_curvature(double zeta) const = 0;   // d2A/dzeta2

protected:
    ~OrbitEquation() = default;
};

class SphericalMetric : public Spacetime {
public:
    const SphericalMetric* spherical() const final { return this; }
    virtual double radial_stretch2(double r) const { return 1.0 / lapse_squared(r); }  // B = g_rr
    // V far out: -Lambda/3, 0 where space is flat there. chi is of V less this.
    virtual double v_at_sky() const { return 0.0; }
    // nullptr: light runs straight, or barrier(), or potential().
    virtual const ChiMap* chi() const { return nullptr; }
    virtual std::optional<Barrier> barrier() const { return std::nullopt; }
    virtual const PotentialSurvey* potential() const { return nullptr; }
    // Of metrics with R = r and A of this form, for which the shader knows how long light takes.
    virtual std::optional<LapseRoots> lapse_roots() const { return std::nullopt; }
    bool has_inner_root() const { return lapse_roots().value_or(LapseRoots{0, 0}).inner != 0.0; }
    bool knows_light_time() const final { return !bends_light() || lapse_roots().has_value(); }
    // A wormhole's tube, where R and V are constant: what of its length lies between r and the sky, over R. All of it
    // has chi = pi/2, and rays with k > 1 sweep this divided by sqrt(k^2 - 1) there. r = -infinity: the whole tube.
    virtual double tube_beyond(double) const { return 0.0; }
    // Wormholes: dR/dl and d2R/dl2, by which objects are found (table/throat_orbit.h); and M where
    // R = |l| - M ln |l| + const far out.
    virtual double radius_slope(double) const { return 1.0; }
    virtual double radius_curvature(double) const { return 0.0; }
    virtual double logarithm_length() const { return 0.0; }
    // In a longer tube rays wind so often that the rows of the orbit table, even in the angle, leave out what lies before
    // and behind it.
    static constexpr double kLongestHalfTube = 0.25;  // over the throat's radius
    // Where rays that miss the sky end in a horizon the orbit table of objects can follow them; through a wormhole it
    // follows them by l.
    bool can_have_disc() const override { return follows_orbits(); }
    bool can_have_bodies() const final {
        return follows_orbits() || (by_proper_length() && tube_beyond(0.0) <= kLongestHalfTube);
    }
    // sqrt(V): q sin(alpha) of every ray through r, alpha its angle from the radial direction for a camera at rest.
    double root_v(double r) const;
    Matrix4 metric(double r, double theta) const final;
    Matrix4 inverse_metric(double r, double theta) const final;
    std::optional<Equator> equator(double r) const final;

private:
    bool follows_orbits() const { return orbit_equation() != nullptr && inner_end() == InnerEnd::kHorizon; }
};

}  // namespace nullscope
