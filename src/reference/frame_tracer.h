// The rays of a camera: from a pixel position to an orbit, a plane and a frequency ratio, for ray data and rendering.
//
// The direction is carried through the tetrad as a photon momentum, p = e_0 - n^i e_i for the photon that arrives from
// n with unit frequency; its components along the local frame follow from the metric: the static frame of a static camera, the rain
// frame of any other. On purpose not the product form of camera/pose.h.
#pragma once
#include <array>
#include <memory>
#include <optional>

#include "base/result.h"
#include "reference/bodies.h"
#include "reference/kerr_ray.h"
#include "reference/orbit.h"
#include "reference/ray_plane.h"
#include "reference/seen_light.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::reference {

struct CameraRay {
    std::unique_ptr<Orbit> orbit;
    RayPlane plane;
    Shift shift;     // camera frequency over frequency at infinity
    double g;        // the same, as far as the switches of the scene's light let it
    double l_z, l2;  // the photon's angular momentum about the polar axis over its energy, r_s; and all of it, squared
    std::optional<KerrRay>
        spun;  // about a spinning hole: instead of orbit, plane and l2; as if there were no bodies ...
    std::optional<BodyHit> met{};  // ... of which it meets this one first
    Fate fate() const { return spun ? spun->fate : orbit->fate(); }
    Vec3 end() const {
        return spun ? spun->sky : plane.direction(orbit->angle());
    }  // where on the sky, or on what it ends on
};

// A place where a ray meets the equatorial plane, in world axes: x = r cos(phi), y = r sin(phi), lengths in r_s.
struct DiscHit {
    double along;  // swept angle; about a spinning hole the affine parameter (kerr_ray.h)
    double x, y;
    bool outward;   // whether the photon really moves outward there
    double radial;  // p_r of the photon over its energy; of a spinning hole only
    double late =
        0;  // how long ago, by the camera's clock, the light left; 0 where nothing moves or light takes no time
};

class FrameTracer {
public:
    // Errors: unknown metric, no such observer at the camera, a camera or disc out of range.
    static Result<FrameTracer> make(const Scene& scene);
    // Pixel position: column, row from the top, centres at +0.5. About a microsecond.
    CameraRay ray(double x, double y) const;
    // The orbit of a unit look direction (r, theta, phi) of the local frame.
    std::unique_ptr<Orbit> orbit_of(Vec3 look) const;
    // Its pixel position; nothing for one behind the camera.
    std::optional<std::array<double, 2>> position(Vec3 look) const;
    // Where the ray meets the disc, in its order; empty if the scene has none. At most max_hits.
    std::vector<DiscHit> disc_hits(const CameraRay& ray, int max_hits) const;
    // What tells how late light is along it. The ray outlives it.
    LightClock clock(const CameraRay& ray) const;
    // The first solid body that the ray meets.
    std::optional<BodyHit> body_hit(const CameraRay& ray) const;
    RayPixel pixel(double x, double y) const;
    RayPixel pixel_without_delay(double x, double y) const;  // the delay may cost several times the rest
    const OrbitMetric& metric() const { return *metric_; }   // of the rays
    const OrbitMetric& matter() const { return *matter_; }   // of what they meet: another where light goes straight

private:
    RayPixel pixel_of(const CameraRay& traced, bool with_delay) const;
    FrameTracer() = default;
    CameraSpec camera_;
    LightSpec light_;
    std::optional<DiscSpec> disc_;
    std::shared_ptr<const Bodies> bodies_;
    std::shared_ptr<const OrbitMetric> metric_, matter_;
    double lapse_ = 1;
    bool late_ = false, disc_moves_ = false;  // light takes time, and shows it; in the disc
    bool from_rain_ = false;                  // the local frame is the rain frame
    // Rows: e_0, right, up, backward; components along the local tetrad (t, r, theta, phi). In long double because
    // ahead of a camera with gamma = 700 the sum e_0 - n^i e_i leaves 1/gamma^2 of its terms.
    // Without aberration that of a camera at rest. About a spinning hole along d_v, d_r, d_theta, d_phi/sin(theta) of ingoing coordinates.
    std::array<std::array<long double, 4>, 4> tetrad_{};
    std::array<long double, 4> velocity_{};  // the camera's e_0, moving
};

}  // namespace nullscope::reference
