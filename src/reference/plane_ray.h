// Traced rays that stay in a plane: an orbit in closed form, and the plane. `along` is the swept angle.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "reference/bodies.h"
#include "reference/light_time.h"
#include "reference/light_times.h"
#include "reference/orbit.h"
#include "reference/orbit_places.h"
#include "reference/ray_plane.h"
#include "reference/traced_ray.h"

namespace nullscope::reference {

// The photon where it is seen: at r, which in wormholes is l.
struct PlanePhoton {
    double r;
    double q;    // E r_s/L, infinite for a radial ray
    double l;    // all of its angular momentum over its energy, r_s: 1/q
    double l_z;  // the part about the polar axis
    Shift shift;
    double g;
    bool clock_falls;   // the camera's clock is v - r: light_time.h
    double inward = 0;  // angle of the view direction from inward
};

class PlaneRay final : public TracedRay {
public:
    // metric, task.bodies, times: outlive this. times: of such rays; or null.
    PlaneRay(const OrbitMetric& metric, std::unique_ptr<Orbit> orbit, const RayPlane& plane, const PlanePhoton& photon,
             const RayTask& task, const LightTimes* times = nullptr)
        : TracedRay(photon.shift, photon.g, photon.l_z),
          metric_(metric),
          orbit_(std::move(orbit)),
          plane_(plane),
          photon_(photon),
          task_(task),
          times_(times) {}
    const OrbitMetric& metric() const { return metric_; }
    const Orbit& orbit() const { return *orbit_; }
    const RayPlane& plane() const { return plane_; }
    const PlanePhoton& photon() const { return photon_; }
    // r, r_s; in wormholes l.
    double radius_at(double angle) const {
        const double place = orbit_->zeta_at(angle);
        return metric_.by_proper_length() ? place : 1 / place;
    }
    Vec3 place_at(double angle) const { return plane_.direction(angle) * std::abs(radius_at(angle)); }

    Fate fate() const override { return orbit_->fate(); }
    double end() const override { return orbit_->angle(); }
    Vec3 end_direction() const override { return plane_.direction(end()); }
    double end_azimuth() const override { return plane_.azimuth(end()); }
    double swept(double along) const override { return along; }
    double delay() const override { return orbit_->delay(); }
    std::vector<PlaneCrossing> crossings(int most, double inner, double outer) const override;
    std::optional<BodyHit> first_hit() const override;
    double delay(double along) const override;
    std::vector<MediumNode> medium_nodes() const override;
    const PlaneRay* in_plane() const override { return this; }

private:
    double crossing_delay(double angle, std::optional<LightClock>& clock) const;  // clock: made when it is needed
    LightClock clock() const { return {metric_, *orbit_, photon_.q, photon_.r, photon_.clock_falls}; }
    const OrbitMetric& metric_;
    std::unique_ptr<Orbit> orbit_;
    RayPlane plane_;
    PlanePhoton photon_;
    RayTask task_;
    const LightTimes* times_;
};

// The swept angle at which the ray enters a body. time_at: the body's time for what is seen after a swept angle; asked
// in nearly growing order. places: of its orbit. A few hundred positions along it, some 10 microseconds.
std::optional<double> entry(const PlaneRay& ray, const BodyPart& part, const std::function<double(double)>& time_at,
                            OrbitPlaces& places);
// In a wormhole, where orbits give l, of either sign, and a body stands on one side.
std::optional<double> entry_by_length(const PlaneRay& ray, const BodyPart& part, double time, OrbitPlaces& places);

class PlaneRays final : public RayFamily {
public:
    // metric: outlives this. tetrads: the one that directions are of, and the camera's own, which moves where that
    // rests without aberration; components along the static frame or, of cameras that fall, the rain frame. Without
    // lensing the rays are those of flat space.
    PlaneRays(const OrbitMetric& metric, const Scene& scene, const Spacetime& spacetime, const RayTask& task,
              const Tetrad& seen, const Tetrad& moving);
    // The orbit of a unit view direction (r, theta, phi) of the local frame.
    std::unique_ptr<Orbit> orbit_of(Vec3 view) const;
    // The unit view direction of a photon that comes from there, along the camera's right, up and backward; of any length.
    Vec3 view(Vec3 direction) const { return view_of(photon(direction)).direction; }
    // Its pixel position; nothing for one behind the camera.
    std::optional<std::array<double, 2>> position(Vec3 view) const;
    const PlaneRays* in_plane() const override { return this; }

private:
    struct View {
        LocalRay local;
        Vec3 direction;
        long double across, frequency;
    };
    View view_of(const Photon& p) const;
    RayPtr trace(const Photon& p) const override;
    RainOrbit start_of(const LocalRay& local) const;

    std::shared_ptr<const OrbitMetric> flat_;  // without lensing
    const OrbitMetric& metric_;                // of the rays
    CameraSpec camera_;
    LightSpec light_;
    RayTask task_;
    double lapse_;                             // of a camera at rest in this place
    bool from_rain_;                           // the local frame is the rain frame
    Photon velocity_;                          // the camera's e_0, moving: tetrad() is at rest without aberration
    std::unique_ptr<const LightTimes> times_;  // where they pay
};

}  // namespace nullscope::reference
