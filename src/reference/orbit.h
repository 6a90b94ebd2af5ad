// What the tracer asks of a metric: the plane orbit of a light ray, traced backward in time from the camera.
//
// A metric is added by one file pair (..._orbit.h, .cpp) and one line in orbit.cpp. It formulates its orbits in its own
// way; nothing here is shared with the deflection table or the shader core.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::reference {

// Swept angles are counted from the camera, in rad, with windings; zeta = r_s / r; q = E r_s / L. In wormholes q is 1 over the
// impact parameter and l, the proper distance from the throat, stands wherever zeta is written.
class Orbit {
public:
    virtual ~Orbit() = default;
    Fate fate() const { return fate_; }      // kEscaped, kOtherSide, kCaptured, kHit (a star) or kNoSky
    double angle() const { return angle_; }  // to the sky or the inward crossing of the horizon; NaN: no such end
    double turn() const { return turn_; }    // zeta at the turning point on the traced part; NaN: there is none
    double turn_angle() const {
        return turn_angle_;
    }  // swept to the turning point on the traced part; NaN: there is none
    // zeta after a swept angle >= 0; NaN if the ray has ended before or there. A few elliptic functions.
    virtual double zeta_at(double angle) const = 0;
    // T = v_cam - v_inf in r_s/c of an escaped ray, NaN for others. Some microseconds.
    virtual double delay() const = 0;

protected:
    bool has_ended(double angle) const { return !(angle < angle_); }
    Fate fate_ = Fate::kNoSky;
    double angle_ = kNotANumber;
    double turn_ = kNotANumber;
    double turn_angle_ = kNotANumber;
};

// A look direction in a local frame at radius r: components outward and across, n_r^2 + n_t^2 = 1, n_t >= 0.
// Both are given because near the radial (transverse) direction only n_t (n_r) tells the direction.
struct LocalRay {
    double r, n_r, n_t;
};

struct RainOrbit {
    std::unique_ptr<Orbit> orbit;
    double g;  // camera frequency over frequency at infinity; NaN where the ray's energy is not positive
};

// The metric in the equatorial plane: what a disc's matter feels.
struct EquatorialMetric {
    double g_tt, g_tphi, g_phiphi, g_rr;
};

class OrbitMetric {
public:
    virtual ~OrbitMetric() = default;
    // a/M of a spinning hole: where it is not 0 there are no plane orbits, and rays are those of kerr_ray.h.
    virtual double spin() const { return 0; }
    virtual EquatorialMetric equator(double r) const {
        const double l = lapse(r);
        return {-l * l, 0, r * r, 1 / (l * l)};
    }
    virtual std::optional<double> horizon_radius() const = 0;  // of the outer horizon
    virtual bool by_proper_length() const { return false; }    // places are l (wormholes), not zeta
    virtual double lapse(double r) const = 0;  // sqrt(-g_tt); not a number where no camera can be at rest
    // Errors: no ray with this q passes through zeta0 (q^2 < V(zeta0) by more than rounding). Infinite q: radial.
    virtual Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const = 0;
    virtual std::unique_ptr<Orbit> from_static(const LocalRay& ray) const = 0;  // r outside the horizon
    virtual RainOrbit from_rain(const LocalRay& ray) const = 0;                 // r > 0
};

// Errors: a metric this tracer has no orbits for.
Result<std::unique_ptr<OrbitMetric>> make_orbit_metric(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
