// What the reference knows of any metric: what matter in the equatorial plane feels, and how its rays are made.
//
// Two kinds of metric follow: those whose rays stay in a plane (orbit.h), and rotating holes (kerr_metric.cpp).
#pragma once
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "reference/ray_stretch.h"
#include "reference/traced_ray.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::reference {

class OrbitMetric;

// In (t, r, phi) at theta = pi/2.
struct EquatorialMetric {
    double g_tt, g_tphi, g_phiphi, g_rr;
    double lapse2() const { return g_tphi * g_tphi / g_phiphi - g_tt; }  // -1/g^tt, of who has no angular momentum
};

// Anywhere outside the horizon.
struct PlaceMetric {
    double g_tt, g_tphi, g_phiphi, g_rr, g_thetatheta;
};

class Metric {
public:
    virtual ~Metric() = default;
    virtual EquatorialMetric equator(double r) const = 0;
    virtual PlaceMetric place(double r, double sine, double) const {  // of the polar angle; here of what is spherical
        const EquatorialMetric g = equator(r);
        return {g.g_tt, 0, g.g_phiphi * sine * sine, g.g_rr, r * r};
    }
    virtual std::optional<double> horizon_radius() const { return {}; }  // of the outer horizon, r_s
    // Omega of the circular geodesic at r, sense 1 towards growing phi and -1 towards falling phi:
    // g_tt' + 2 g_tphi' Omega + g_phiphi' Omega^2 = 0.
    virtual double kepler_rate(double r, double sense = 1) const;
    virtual double a() const { return 0; }                 // of a rotating hole, r_s
    virtual bool turns_westward() const { return false; }  // does the hole rotate towards falling phi?
    double sense(OrbitSense of) const;                     // 1 or -1
    // Omega about the axis of a disc with this tilt: s w/(1 + s a cos(tilt) w) where kepler_rate() is s w/(1 + s a w).
    double leaning_rate(double r, double sense_of, double tilt) const {
        const double rate = kepler_rate(r, sense_of);
        return a() == 0 || tilt == 0 ? rate : 1 / (1 / rate - a() + a() * std::cos(tilt));
    }
    // And u^t of what goes round so, at cos(theta) on that disc's plane.
    double leaning_u_t(double r, double rate, double tilt, double cosine) const;
    // A radius within the last stable circle, r_s, where the search for that begins.
    virtual double within_last_circle() const = 0;
    // And one up to which the energy of circles grows from there on, where the search ends.
    virtual double beyond_last_circle() const { return 100 * horizon_radius().value_or(0.0); }
    // sqrt(-g_tt) where observers at rest split g into parts; 1 where it is not split (rotating holes).
    virtual double rest_lapse(double r) const = 0;
    // Of a metric whose rays stay in a plane; elsewhere null.
    virtual const OrbitMetric* orbits() const { return nullptr; }

    // The rays of scene.camera. spacetime: of this metric. This and task.bodies outlive them. Errors: no such observer.
    virtual Result<std::unique_ptr<RayFamily>> rays(const Scene& scene, const Spacetime& spacetime,
                                                    const RayTask& task) const = 0;
    // One ray; query.n is a unit vector. g is that of a camera at rest in query.frame. This and task.bodies outlive it.
    // Errors: query outside the metric's domain, a form or frame that does not exist there.
    virtual Result<RayPtr> ray(const RayQuery& query, const RayTask& task) const = 0;
    // The stretches of a ray that stays in no plane, traced anew; energy: at infinity, of unit frequency in the camera, > 0.
    virtual void stretches(const RayQuery&, double, const StretchWatch&) const {}
};

inline double parameter_of(const SpacetimeSpec& spec, const std::string& name, double fallback) {
    const auto found = spec.parameters.find(name);
    return found == spec.parameters.end() ? fallback : found->second;
}

// Errors: a metric the reference does not know.
Result<std::unique_ptr<Metric>> make_metric(const SpacetimeSpec& spec);
std::unique_ptr<Metric> make_kerr_metric(const SpacetimeSpec& spec);         // without spin, Schwarzschild's orbits
std::unique_ptr<Metric> make_kerr_newman_metric(const SpacetimeSpec& spec);  // ... Reissner and Nordstrom's

// Of a query: the squares of the equations of motion stay within a double.
inline constexpr double kLargestRadius = 1e60;

}  // namespace nullscope::reference
