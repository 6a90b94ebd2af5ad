// Where a ray meets the solid bodies of a scene, in double: by its own means, on the reference's orbits.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "base/image.h"
#include "base/result.h"
#include "reference/light_time.h"
#include "reference/orbit.h"
#include "reference/ray_plane.h"
#include "scene/scene.h"

namespace nullscope::reference {

struct BodyHit {
    double along;  // swept angle; about a spinning hole the affine parameter (kerr_ray.h)
    Vec3 place;    // r_s, world axes
    Object object;
    double cosine;              // between the ray and the surface's normal, in flat coordinates
    Vec3 middle{0, 0, 0};       // of the body, when the light left
    double late = kNotANumber;  // about a spinning hole: the camera's clock less t there
};

struct BodyPart {
    Object object;
    double thinnest;                            // its smallest extent: no stride may be longer than a part of it
    double reach;                               // radius about the centre that holds it
    std::function<double(Vec3, double)> value;  // of the place and of t
    bool far = false;                           // of a wormhole: at l < 0
    bool moves = false;
    std::function<Vec3(double)> middle{};
    bool clear = false;                                    // value is at most how far the body is, in r_s and r_s/c
    double cosine(Vec3 place, Vec3 back, double t) const;  // BodyHit's, of a ray that comes from `back`, of any length
};

// The bodies as functions of place, below 0 inside: what a ray enters first.
class Bodies {
public:
    // matter: outlives this.
    Bodies(const Scene& scene, const OrbitMetric& matter);
    bool empty() const { return parts_.empty(); }
    bool move() const { return moves_; }
    double time() const { return time_; }
    const std::vector<BodyPart>& parts() const { return parts_; }
    // A few hundred positions along the orbit: some 50 microseconds; where light takes time (clock) and something moves, some milliseconds.
    // by_length: the orbit gives l, and camera_r is one (wormholes).
    std::optional<BodyHit> first_hit(const Orbit& orbit, const RayPlane& plane, double camera_r, LightClock* clock,
                                     bool by_length = false) const;

private:
    using Part = BodyPart;
    std::optional<double> first_angle(const Orbit& orbit, const RayPlane& plane, double camera_r, const Part& part,
                                      LightClock* clock) const;
    std::optional<double> first_angle_by_length(const Orbit& orbit, const RayPlane& plane, double camera_l,
                                                const Part& part) const;
    double time_at(double angle, const Part& part, LightClock* clock) const;
    double time_ = 0;
    bool moves_ = false;
    std::vector<Part> parts_;
};

// Error: a ball on a way that is not followed about a spinning hole.
Status check_bodies(const Scene& scene, const OrbitMetric& matter);

// Linear light of a body's texture at a place. image: of texture kind image.
Vec3 body_light(const Scene& scene, const BodyHit& hit, const Image<float>* image);

// The same of what is no body, and the look's brightness is not in it. u, v: texture coordinates; at: the place, turned: with the
// texture; size: the length that grains are counted over.
Vec3 look_light(const BodyLook& look, double u, double v, Vec3 at, Vec3 turned, double size);
// Of a painted disc at (x, y), without brightness; of a painted sky in a direction.
Vec3 disc_coat(const DiscSpec& disc, double x, double y);
Vec3 sky_coat(const SkySpec& sky, Vec3 direction);

}  // namespace nullscope::reference
