// A light ray of whatever metric, traced backward in time from where it is seen: what ray data and shading ask of it.
// And the rays of a camera, which makes one of a photon.
//
// `along` is the ray's own parameter: it grows away from the camera and orders what a ray meets. Of a ray in a plane
// (plane_ray.h) it is the swept angle, rad; of one that is integrated (kerr_ray.h) an angle over its momentum.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "observer/pose.h"
#include "reference/ray_stretch.h"
#include "reference/seen_light.h"
#include "scene/disc_plane.h"
#include "scene/ray.h"

namespace nullscope {
class DiscShape;
}

namespace nullscope::reference {

class Bodies;
class Medium;
class PlaneRay;
class PlaneRays;

// A place where a ray meets a disc's plane.
struct PlaneCrossing {
    double along, r, phi;  // r_s, rad; phi with its windings
    // Of the photon, over its energy: the radial part of its momentum, measured by a ZAMO,
    // times the lapse; > 0: it really moves outward. Without rotation a cosine. Outside the horizon.
    double climb;
    double delay = 0;    // how long ago, by the camera's clock, the light left, r_s/c; 0 where nobody asks (RayTask)
    double l = 0;        // the photon's angular momentum about the plane's axis over its energy, r_s
    double bearing = 0;  // azimuth in the plane, from its x towards its y; of the equatorial one phi
    double cosine = 0;   // of theta, of a plane that leans about a rotating hole
    double across = 0;   // and the part of its momentum along that plane's unit normal
};

// Where a ray enters a solid body.
struct BodyHit {
    double along;
    Vec3 place;                  // r_s, world axes
    int number;                  // in ray data
    std::size_t body;            // of Scene::bodies
    Vec3 normal;                 // of the surface there, unit, in flat coordinates
    double cosine;               // between the ray and the surface's normal, in flat coordinates
    Vec3 middle{0, 0, 0};        // of the body, when the light left
    double delay = kNotANumber;  // of a ray that is integrated: how long ago, by the camera's clock, the light left
    Vec3 toward{0, 0, 0};        // where the light goes from there, in flat coordinates; of any length
    bool moves = false;          // the body does
    bool carries = false;        // all of it as its middle does
    Vec3 velocity{0, 0, 0};      // body_shift.h
    double turn = 0;             // of the body about the polar axis, when the light left, rad
};

// A part of a ray in matter (medium.h).
struct MediumNode {
    double along;    // in its middle
    double r;        // Boyer and Lindquist's, r_s
    Vec3 direction;  // of its angles: unit, world axes
    double delay;    // how long ago, by the camera's clock, the light left; where the medium moves
    double way;      // how much of the affine parameter of a photon of unit frequency in the camera, r_s
    double r_slope = 0, theta_slope = 0;           // by that parameter, away from the camera; of matter by place
    double cosine() const { return direction.z; }  // of the polar angle
    double sine() const { return std::sqrt(direction.x * direction.x + direction.y * direction.y); }
};

// What rays may be asked, said before they are traced: one that is integrated is looked along meanwhile.
struct RayTask {
    const Bodies* bodies = nullptr;  // that end rays; outlives them
    bool delays_bodies = false;      // those that move are seen where they were when the light left
    bool delays_disc = false;        // crossings have their `delay`
    int crossings = 0;               // of `plane`, most of one ray
    const Medium* medium = nullptr;  // that lights and dims rays; outlives them
    bool many = false;               // there are so many rays that a grid of them pays (light_times.h)
    DiscPlane plane{};
    const DiscShape* shape =
        nullptr;  // of a disc that is warped or has gaps, whose crossings are meant then; outlives them
    bool leans() const { return plane.normal != Vec3{0, 0, 1}; }  // from the equator
};

class TracedRay {
public:
    TracedRay(const Shift& split, double g_seen, double momentum) : shift(split), g(g_seen), l_z(momentum) {}
    virtual ~TracedRay() = default;
    const Shift shift;  // camera frequency over frequency at infinity
    const double
        g;  // the same, as far as the switches of the scene's light let it; not positive: no frequency at infinity
    const double l_z;  // the photon's angular momentum about the polar axis over its energy, r_s

    // As if there were no bodies: kEscaped, kOtherSide, kCaptured, kHit (a star) or kNoSky.
    virtual Fate fate() const = 0;
    virtual double end() const = 0;                // along, where it ends; NaN: no such place, or not known
    virtual Vec3 end_direction() const = 0;        // of the sky, or of the place on what it ends on: unit, world axes
    virtual double end_azimuth() const = 0;        // its azimuth, windings kept
    virtual double swept(double along) const = 0;  // rad, windings kept; NaN where the ray is in no plane
    virtual double delay() const = 0;              // T = v_cam - v_inf, r_s/c; escaped rays. May take some microseconds
    // Of the task's plane after the camera, before the end, in order: those with inner <= r <= outer, at most
    // `most`, and not more than the task said. With `delay` a millisecond each where rays are closed forms.
    virtual std::vector<PlaneCrossing> crossings(int most, double inner = -std::numeric_limits<double>::infinity(),
                                                 double outer = std::numeric_limits<double>::infinity()) const = 0;
    // The first of the task's bodies that it enters. Closed forms: 50 microseconds; moving ones with delay, milliseconds.
    virtual std::optional<BodyHit> first_hit() const = 0;
    // How long ago, by the camera's clock, light left a crossing or first_hit(), r_s/c; NaN in wormholes.
    virtual double delay(double along) const = 0;
    virtual std::vector<MediumNode> medium_nodes() const { return {}; }  // of the task's medium, in order
    virtual const PlaneRay* in_plane() const { return nullptr; }         // the ray, if it stays in a plane
};
using RayPtr = std::unique_ptr<const TracedRay>;

// Rows: a camera's e_0, right, up, backward. In long double because ahead of a camera with gamma = 700 e_0 - n^i e_i
// leaves 1/gamma^2 of its terms.
using Tetrad = std::array<std::array<long double, 4>, 4>;
inline Tetrad long_tetrad(const TetradPair& pair) {
    Tetrad tetrad;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t mu = 0; mu < 4; ++mu)
            tetrad[i][mu] = static_cast<long double>(pair.high[i][mu]) + pair.low[i][mu];
    return tetrad;
}

// The rays of one camera. The metric that made it outlives it, and it outlives its rays.
class RayFamily {
public:
    explicit RayFamily(const Tetrad& tetrad) : tetrad_(tetrad) {}
    virtual ~RayFamily() = default;
    // direction: where the photon comes from, along the camera's right, up and backward; of any length.
    RayPtr ray(Vec3 direction) const { return trace(photon(direction)); }
    // The same of many, in their order: together where the metric has a faster way for that.
    std::vector<RayPtr> rays(const std::vector<Vec3>& directions) const {
        std::vector<Photon> photons;
        photons.reserve(directions.size());
        for (const Vec3& direction : directions) photons.push_back(photon(direction));
        return trace_all(photons);
    }
    // The stretches of a ray that stays in no plane, traced anew; energy: as Metric::stretches.
    void stretches(Vec3 direction, double energy, const StretchWatch& watch) const {
        stretch_along(photon(direction), energy, watch);
    }
    virtual const PlaneRays* in_plane() const { return nullptr; }  // the family, if its rays stay in planes

protected:
    using Photon = std::array<long double, 4>;  // its momentum p = e_0 - n^i e_i, of unit frequency in the camera
    const Tetrad& tetrad() const { return tetrad_; }

    Photon photon(Vec3 direction) const {
        const long double norm = std::sqrt(static_cast<long double>(direction.x) * direction.x +
                                           static_cast<long double>(direction.y) * direction.y +
                                           static_cast<long double>(direction.z) * direction.z);
        const std::array<long double, 3> n{direction.x / norm, direction.y / norm, direction.z / norm};
        Photon p = tetrad_[0];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t mu = 0; mu < 4; ++mu) p[mu] -= n[i] * tetrad_[i + 1][mu];
        return p;
    }

private:
    virtual RayPtr trace(const Photon& p) const = 0;
    virtual void stretch_along(const Photon&, double, const StretchWatch&) const {}
    virtual std::vector<RayPtr> trace_all(const std::vector<Photon>& photons) const {
        std::vector<RayPtr> rays;
        rays.reserve(photons.size());
        for (const Photon& p : photons) rays.push_back(trace(p));
        return rays;
    }
    Tetrad tetrad_;
};

}  // namespace nullscope::reference
