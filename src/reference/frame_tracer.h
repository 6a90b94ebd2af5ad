// The rays of a scene's camera: from a pixel position to a traced ray and what it meets, for ray data and rendering.
//
// The direction is carried through the camera's tetrad as a photon momentum, p = e_0 - n^i e_i for the photon that
// arrives from n with unit frequency (traced_ray.h). On purpose not the product form of observer/pose.h.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "base/result.h"
#include "reference/bodies.h"
#include "reference/matter_stokes.h"
#include "reference/medium.h"
#include "reference/metric.h"
#include "reference/plane_ray.h"
#include "reference/traced_ray.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::reference {

// A place where a ray meets the disc, along the axes of its plane: x = r cos(bearing), y = r sin(bearing), in r_s. The rest: PlaneCrossing.
struct DiscHit {
    double along, x, y, climb, delay, l, cosine, across;
};

// How many rays are asked for at once: enough for the lanes of any machine, and few enough to be kept.
inline constexpr int kRaysTogether = 64;

class FrameTracer {
public:
    // Errors: unknown metric, no such observer at the camera, a camera or disc out of range, a zoom deeper than directions in double
    // resolve.
    static Result<FrameTracer> make(const Scene& scene);
    // Pixel position: column, row from the top, centres at +0.5. In a plane about a microsecond, else 30 and its
    // looks at bodies. The tracer outlives it.
    RayPtr ray(double x, double y) const;
    // Of a ray that stays in no plane, of this energy at infinity for a photon of unit frequency in the camera; in a plane none.
    void stretches(double x, double y, double energy, const StretchWatch& watch) const;
    // The same of many positions, in their order: those that are integrated several at a time.
    std::vector<RayPtr> rays(const std::vector<std::array<double, 2>>& positions) const;
    // The same for as many of the camera's rays as there are stars.
    RayPtr ray_of_many(double x, double y) const;
    // Where the ray meets the disc, in its order; empty if the scene has none. At most max_hits.
    std::vector<DiscHit> disc_hits(const TracedRay& ray, int max_hits) const;
    // The delay may cost several times the rest.
    RayPixel pixel(double x, double y, bool with_delay = true) const;
    // Of any number of positions, kRaysTogether at a time.
    std::vector<RayPixel> pixels(const std::vector<std::array<double, 2>>& positions, bool with_delay = true) const;
    const Medium* medium() const { return medium_.get(); }  // null where there is none, or its light is polarised
    // Of polarised matter along a pixel's ray, without the medium's colour. Nothing: there is none. Some 10 ms.
    std::optional<RayStokes> stokes(double x, double y) const;
    const Metric& matter() const { return *matter_; }  // of what rays meet: they run straight without lensing
    const PlaneRays* plane_rays() const { return rays_->in_plane(); }  // null where rays stay in no plane

private:
    FrameTracer() = default;
    std::vector<Vec3> directions(const std::vector<std::array<double, 2>>& positions) const;
    RayPixel pixel_of(const TracedRay& traced, bool with_delay) const;
    CameraSpec camera_;
    std::optional<DiscSpec> disc_;
    DiscPlane plane_;                         // of the disc
    std::shared_ptr<const DiscShape> shape_;  // of one that is warped or has gaps
    std::shared_ptr<const Metric> matter_;
    std::shared_ptr<const Bodies> bodies_;
    std::shared_ptr<const Medium> medium_;
    std::shared_ptr<const MatterStokes> stokes_;
    CameraAxes axes_{};
    std::shared_ptr<const RayFamily> many_rays_, rays_,
        bare_rays_;  // the latter ask nothing of matter along them, of which ray data has nothing
};

}  // namespace nullscope::reference
