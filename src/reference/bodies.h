// The solid bodies of a scene, as functions of place and time, and their light. Rays enter them in plane_ray.h and
// kerr_bodies.h.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "reference/metric.h"
#include "reference/traced_ray.h"
#include "scene/scene.h"

namespace nullscope::reference {

struct BodyPart {
    int number = 0;                             // in ray data
    std::size_t body = 0;                       // of Scene::bodies
    double thinnest = 0;                        // its smallest extent: no step may be longer than a part of it
    double reach = 0;                           // radius about the centre that holds it
    std::function<double(Vec3, double)> value;  // of the place and of t
    bool far = false;                           // of a wormhole: at l < 0
    bool moves = false;
    double turn_rate = 0;  // about the polar axis, rad per r_s/c: it looks different, but is where it was
    std::function<Vec3(double)> middle{};
    // Of which value is a distance: how fast that changes at most, r_s by r_s/c; else infinite.
    double speed = INFINITY;
    bool clear = false;                       // value is at most how far the body is, in r_s and r_s/c
    Vec3 normal(Vec3 place, double t) const;  // BodyHit's; 0 where there is none
    bool glows = false;                       // it has a temperature
    bool changes() const { return moves || turn_rate != 0; }
    void tell(BodyHit& hit, double t) const;  // of its turn; of its motion, where it glows
};

// BodyHit's, of a ray that comes from `back`, of any length.
inline double cosine_between(Vec3 normal, Vec3 back) {
    const double size = length(normal) * length(back);
    return size > 0 ? std::clamp(dot(normal, back) / size, 0.0, 1.0) : 1.0;
}

// The bodies as functions of place, below 0 inside: what a ray enters first.
class Bodies {
public:
    // matter: outlives this.
    Bodies(const Scene& scene, const Metric& matter);
    bool empty() const { return parts_.empty(); }
    bool move() const { return moves_; }
    double time() const { return time_; }
    const std::vector<BodyPart>& parts() const { return parts_; }

private:
    double time_ = 0;
    bool moves_ = false;
    std::vector<BodyPart> parts_;
};

// Where a ball is at a time t, found another way than observer/ball_motion.h.
// Free fall: 1e-10 of its radius a turn; about a rotating hole by kerr_fall.h. metric: outlives what is
// returned, which any number of threads may ask.
std::function<Vec3(double t)> ball_way(const Metric& metric, const BallSpec& ball);

// Error: a ball on a trajectory that is not followed about a rotating hole.
Status check_bodies(const Scene& scene, const Metric& matter);

struct Paint {
    Vec3 colour;
    double alpha;
};
// Of 3 or 4 channels, bilinear, clamped at the rim. x, y in [0, 1], y from the top.
Paint sample_image(const Image<float>& image, double x, double y);

// The cap on the sphere that is seen at a place, counted from the first and the last that covers it; nothing: none. turn: BodyHit's.
const CapSpec* cap_at(const Scene& scene, const BodyHit& hit);

// Linear light of a body's texture at a place. image: of texture kind image.
Vec3 body_light(const Scene& scene, const BodyHit& hit, const Image<float>* image);

// The same of what is no body, and its brightness is not in it. u, v: texture coordinates; at: the place,
// turned: with the texture; size: the length that grains are counted over.
Vec3 material_light(const Material& material, double u, double v, Vec3 at, Vec3 turned, double size);
// Of a painted disc at (x, y), without brightness; of a painted sky in a direction.
Vec3 disc_material(const DiscSpec& disc, double x, double y);
Vec3 sky_material_of(const SkySpec& sky, Vec3 direction);

}  // namespace nullscope::reference
