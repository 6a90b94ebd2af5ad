// Spacetime: what the host needs to know of a static, spherically symmetric metric
//     ds^2 = -A dt^2 + B dr^2 + R^2 dOmega^2,   units r_s = c = 1 (wormholes have no r_s: any unit), signature (-,+,+,+).
// r is the metric's own radial coordinate, regular wherever a camera can be: the areal radius of holes and stars (R = r), the
// proper distance from the throat of wormholes (r < 0 on the far side). It grows outward, to the sky at r = infinity.
//
// Light is governed by V = A/R^2 alone. Where V has a greatest value q_crit^2, at the photon sphere, it defines the angle chi,
//     V = q_crit^2 sin^2(chi):  0 at infinity, pi/2 on the photon sphere, pi where V vanishes again (horizon, other sky),
//     dphi = h(chi) dchi / sqrt(k^2 - sin^2 chi),   k = q/q_crit,  q = E/L:
// the metric enters the deflection table only through the smooth function h.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace nullscope {

struct PhotonSphere {
    double radius;  // r of the unstable circular light orbit
    double q_crit;  // E r_s / L of the rays that spiral to it
};

// Where light ends that passes the photon sphere inward.
// kSameSky: it does not end there, but turns and comes back to the sky (Wall).
enum class InnerEnd { kHorizon, kOtherSky, kSurface, kSameSky };

// V where it grows without bound inward and every ray turns (metrics with R = r, V a quartic): about zeta_d, where rays divide, V = v +
// x (c[0] + x (c[1] + x (c[2] + x c[3]))), x = zeta - zeta_d. c[0] = 0: a photon sphere, the only one that cameras stand outside of.
struct Wall {
    double zeta, v;
    std::array<double, 4> c;
};

// A = (1 - outer zeta)(1 - inner zeta), outer >= inner.
struct LapseRoots {
    double outer, inner;
};

// Radii at which a camera can be at rest: low < r < high.
inline constexpr double kAnyRadius = 1e300;
struct RadiusRange {
    double low, high;
};

using Matrix4 = std::array<std::array<double, 4>, 4>;

class Spacetime {
public:
    virtual ~Spacetime() = default;
    virtual std::string_view name() const = 0;
    // A = -g_tt. Any r that the metric has; negative inside a horizon.
    virtual double lapse_squared(double r) const = 0;
    virtual double areal_radius(double r) const { return r; }                          // R
    virtual double radial_stretch2(double r) const { return 1.0 / lapse_squared(r); }  // B = g_rr
    virtual RadiusRange camera_range() const { return {horizon_radius().value_or(0.0), kAnyRadius}; }
    // Where a camera can be at all, falling if it cannot rest.
    virtual RadiusRange falling_range() const { return camera_range(); }
    // Outer horizon's radius; nothing if there is none.
    virtual std::optional<double> horizon_radius() const = 0;
    virtual std::optional<PhotonSphere> photon_sphere()
        const = 0;  // the one that defines chi; nothing: light runs straight, or wall()
    virtual std::optional<Wall> wall() const { return std::nullopt; }
    virtual bool bends_light() const = 0;
    // Of metrics with R = r and A of this form, for which the shader knows how long light takes.
    virtual std::optional<LapseRoots> lapse_roots() const { return std::nullopt; }
    bool has_inner_horizon() const { return lapse_roots().value_or(LapseRoots{0, 0}).inner > 0.0; }
    // a, the hole's angular momentum over its mass, r_s: where it is not 0 the metric is symmetric about the axis only, no ray stays in a
    // plane, and what is said here of V, chi and orbits does not hold (spacetime/kerr.h).
    virtual double spin() const { return 0.0; }
    virtual InnerEnd inner_end() const { return InnerEnd::kHorizon; }
    virtual std::optional<double> surface_radius() const { return std::nullopt; }  // of a star; kSurface
    // The angle chi of a radius and back; only where there is a photon sphere. Relative error < 1e-15 near infinity.
    virtual double chi_from_radius(double r) const = 0;
    virtual double radius_from_chi(double chi) const = 0;
    virtual double bending_density(double chi) const = 0;  // h(chi), chi in [0, pi]
    // h holds chi ln(chi) at its ends (R = l + ln l far out): the table's nodes crowd there.
    virtual bool logarithm_at_sky() const { return false; }
    // A wormhole's tube, where R and V are constant: what of its length lies between r and the sky, over R. All of it has chi = pi/2,
    // and rays with k > 1 sweep this divided by sqrt(k^2 - 1) there. r = -infinity: the whole tube.
    virtual double tube_beyond(double) const { return 0.0; }
    // What ray files count lengths in (docs/ray-data.md): the throat's radius of wormholes.
    virtual double length_unit() const { return 1.0; }

    // The orbit equation zeta'' = -half_v_slope(zeta) of zeta = 1/r, by which objects are found; metrics with R = r only.
    virtual bool has_orbit_equation() const { return true; }
    virtual double half_v_slope(double zeta) const = 0;      // d(A zeta^2)/dzeta / 2
    virtual double half_v_curvature(double zeta) const = 0;  // its derivative

    // Wormholes: r is the proper distance from the throat, and ray files have l0 where others have zeta0.
    bool by_proper_length() const { return inner_end() == InnerEnd::kOtherSky; }
    // dR/dl and d2R/dl2 there, by which objects are found (table/throat_orbit.h); and M where R = |l| - M ln |l| + const far out.
    virtual double radius_slope(double) const { return 1.0; }
    virtual double radius_curvature(double) const { return 0.0; }
    virtual double logarithm_length() const { return 0.0; }
    // In a longer tube rays wind so often that the rows of the orbit map, even in the angle, leave out what lies before and behind it.
    static constexpr double kLongestHalfTube = 0.25;  // over the throat's radius
    // Where rays that miss the sky end in a horizon the orbit map of objects can follow them; through a wormhole it follows them by l.
    bool can_have_disc() const { return has_orbit_equation() && inner_end() == InnerEnd::kHorizon; }
    bool can_have_bodies() const {
        return can_have_disc() || (by_proper_length() && tube_beyond(0.0) <= kLongestHalfTube);
    }

    // sqrt(V): q sin(alpha) of every ray through r, alpha its angle from the radial direction for a camera at rest.
    double root_v(double r) const;
    // Covariant metric g_{mu nu} and its inverse in (t, r, theta, phi).
    virtual Matrix4 metric(double r, double theta) const;
    virtual Matrix4 inverse_metric(double r, double theta) const;
};

// Can a camera be at rest at r? And where it can, as a message says it: "r > 1".
bool camera_can_rest(const Spacetime& spacetime, double r);
bool camera_can_be(const Spacetime& spacetime, double r);  // at rest or falling
std::string allowed_radii(const Spacetime& spacetime);
std::string allowed_falling_radii(const Spacetime& spacetime);

}  // namespace nullscope
