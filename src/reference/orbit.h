// The plane orbit of a light ray in a static, spherically symmetric metric, traced backward in time from the camera.
//
// A metric is added by one file NAME_orbit.cpp and a line in plane_metrics.h and in metric.cpp. It formulates its
// orbits in its own terms; nothing here is shared with the deflection table or the shader core.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "reference/metric.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::reference {

// Swept angles are counted from the camera, in rad, with windings; zeta = r_s / r; q = E r_s / L. In wormholes q is 1
// over the impact parameter and l, the proper distance from the throat, stands wherever zeta is written.
class Orbit {
public:
    explicit Orbit(double place) : place_(place) {}  // the camera's
    virtual ~Orbit() = default;
    Fate fate() const { return fate_; }      // kEscaped, kOtherSide, kCaptured, kHit (a star) or kNoSky
    double angle() const { return angle_; }  // to the sky or the inward crossing of the horizon; NaN: no such end
    double turn() const { return turn_; }    // zeta at the turning point on the traced part; NaN: there is none
    double turn_angle() const { return turn_angle_; }  // swept to it; NaN: there is none
    // zeta after a swept angle >= 0; NaN if the ray has ended before or there. A few elliptic functions.
    virtual double zeta_at(double angle) const {
        return angle == 0 ? place_ : angle < angle_ ? place_at(angle) : kNotANumber;
    }
    // T = v_cam - v_inf in r_s/c of an escaped ray, NaN for others. Some microseconds.
    virtual double delay() const = 0;

protected:
    virtual double place_at(double angle) const = 0;  // zeta_at where 0 < angle < angle()
    double place_;
    Fate fate_ = Fate::kNoSky;
    double angle_ = kNotANumber;
    double turn_ = kNotANumber;
    double turn_angle_ = kNotANumber;
};

// A view direction in a local frame at radius r: components outward and across, n_r^2 + n_t^2 = 1, n_t >= 0.
// Both are given because near the radial (transverse) direction only n_t (n_r) tells the direction.
struct LocalRay {
    double r, n_r, n_t;
};

struct RainOrbit {
    std::unique_ptr<Orbit> orbit;
    double g;  // camera frequency over frequency at infinity; NaN where the ray's energy is not positive
};

class OrbitMetric : public Metric {
public:
    virtual bool by_proper_length() const { return false; }  // places are l (wormholes), not zeta
    virtual double lapse(double r) const = 0;                // sqrt(-g_tt); not a number where no camera can be at rest
    // Errors: no ray with this q passes through zeta0 (q^2 < V(zeta0) by more than rounding). Infinite q: radial.
    virtual Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const = 0;
    virtual std::unique_ptr<Orbit> from_static(const LocalRay& ray) const = 0;  // r outside the horizon
    // r > 0. Where nothing falls the rain is at rest.
    virtual RainOrbit from_rain(const LocalRay& ray) const { return {from_static(ray), 1.0}; }

    double lapse2(double r) const {
        const double l = lapse(r);
        return l * l;
    }
    virtual double lapse2_slope(double r) const;  // by r; here differences of eighth order, r outside the horizon

    // Of metrics whose r is the areal radius, and g_rr = 1/lapse^2.
    EquatorialMetric equator(double r) const override {
        const double l = lapse(r);
        return {-l * l, 0, r * r, 1 / (l * l)};
    }
    double kepler_rate(double r, double sense) const override {
        return sense * std::sqrt(std::fmax(lapse2_slope(r), 0) / (2 * r));
    }
    double within_last_circle() const override { return 1.75 * horizon_radius().value_or(0.0); }  // outside light's
    double rest_lapse(double r) const override { return lapse(r); }
    const OrbitMetric* orbits() const final { return this; }
    Result<std::unique_ptr<RayFamily>> rays(const Scene& scene, const Spacetime& spacetime,
                                            const RayTask& task) const final;
    Result<RayPtr> ray(const RayQuery& query, const RayTask& task) const final;
};

}  // namespace nullscope::reference
