// Spacetime: what the host asks of a metric, whichever symmetry it has. Units r_s = c = 1 (wormholes have no r_s: any
// unit), signature (-,+,+,+). r is the metric's own radial coordinate, regular wherever a camera can be; it grows
// outward, to the sky at r = infinity. What spherical metrics have beyond this is in spherical_metric.h, what rotating
// ones have in axial_metric.h; what a metric can do is asked for here.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace nullscope {

class SphericalMetric;
class AxialMetric;
class OrbitEquation;

struct PhotonSphere {
    double radius;  // r of the unstable circular light orbit
    double q_crit;  // E r_s / L of the rays that spiral to it
};

// Where light ends that passes the photon sphere inward.
// kSameSky: it does not end there, but turns and comes back to the sky (Barrier).
enum class InnerEnd { kHorizon, kOtherSky, kSurface, kSameSky };

// Radii at which a camera can be at rest: low < r < high.
inline constexpr double kAnyRadius = 1e300;
struct RadiusRange {
    double low, high;
};

using Matrix4 = std::array<std::array<double, 4>, 4>;

// The metric in the equatorial plane, and the first and second derivatives by r: circular_orbit.h needs no more.
struct Equator {
    struct Components {
        double tt, tphi, phiphi;
    };
    Components g, slope, curvature;
    double across2;  // g_tphi^2 - g_tt g_phiphi, without cancellation at a horizon, where it is 0
    double radial;   // g_rr across2
};

class Spacetime {
public:
    virtual ~Spacetime() = default;
    virtual std::string_view name() const = 0;
    // -g_tt of observers without angular momentum in the equatorial plane: their energy squared. Any r that the metric
    // has; negative inside a horizon.
    virtual double lapse_squared(double r) const = 0;
    virtual double areal_radius(double r) const { return r; }
    virtual RadiusRange camera_range() const { return {horizon_radius().value_or(0.0), kAnyRadius}; }
    // Where a camera can be at all, falling if it cannot rest.
    virtual RadiusRange falling_range() const { return camera_range(); }
    // Outer horizon's radius; nothing if there is none.
    virtual std::optional<double> horizon_radius() const { return std::nullopt; }
    virtual std::optional<PhotonSphere> photon_sphere() const {
        return std::nullopt;
    }  // nothing: light runs straight,
       // or no single orbit divides it
    virtual bool bends_light() const { return true; }
    virtual InnerEnd inner_end() const { return InnerEnd::kHorizon; }
    virtual std::optional<double> surface_radius() const { return std::nullopt; }  // of a star; kSurface
    // What ray files count lengths in (docs/ray-data.md): the throat's radius of wormholes.
    virtual double length_unit() const { return 1.0; }
    // Wormholes: r is the proper distance from the throat, and ray files have l0 where others have zeta0.
    bool by_proper_length() const { return inner_end() == InnerEnd::kOtherSky; }

    // One of the two is there.
    virtual const SphericalMetric* spherical() const { return nullptr; }
    virtual const AxialMetric* axial() const { return nullptr; }

    // What it can do.
    bool planar_rays() const { return spherical() != nullptr; }  // every ray stays in a plane through the centre
    bool rotates() const { return !planar_rays(); }              // prograde is not retrograde
    virtual double a() const { return 0.0; }                     // angular momentum per mass, r_s
    // Azimuth of the ingoing coordinates, which are regular at a horizon, less the metric's own: 0 where nothing rotates, and far away.
    virtual double azimuth_ahead(double) const { return 0.0; }
    virtual bool knows_light_time() const = 0;  // the shader can tell how long light takes
    virtual bool can_have_disc() const = 0;
    virtual bool can_have_bodies() const = 0;

    // Covariant metric g_{mu nu} and its inverse in (t, r, theta, phi).
    virtual Matrix4 metric(double r, double theta) const = 0;
    virtual Matrix4 inverse_metric(double r, double theta) const = 0;
    // Nothing where no matter is put on orbits: r is not the areal radius.
    virtual std::optional<Equator> equator(double r) const = 0;
    // Of 1/r, by which what falls and what rays meet is followed; nullptr where rays are no planar orbits or r is not
    // the areal radius.
    virtual const OrbitEquation* orbit_equation() const { return nullptr; }
};

// Can a camera be at rest at r? And where it can, as a message says it: "r > 1".
bool camera_can_rest(const Spacetime& spacetime, double r);
bool camera_can_be(const Spacetime& spacetime, double r);  // at rest or falling
std::string allowed_radii(const Spacetime& spacetime);
std::string allowed_falling_radii(const Spacetime& spacetime);

}  // namespace nullscope
