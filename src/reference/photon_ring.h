// Rays next to the critical ones of a scene's camera: in which direction, and at its source when and where, the light of the photon ring's
// subrings is. spacetime/photon_shell.h says what they do from one to the next.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "observer/critical_light.h"
#include "reference/bodies.h"
#include "reference/metric.h"
#include "scene/scene.h"

namespace nullscope::reference {

class PhotonRing {
public:
    // Without spin as who rests in the camera's place sees it, or falls there along the radius. Errors: no such observer, no photon sphere
    // that light can reach.
    static Result<PhotonRing> make(const Scene& scene);
    const CameraSpec& camera() const { return scene_.camera; }  // whose rays they are

    // A place on the ring: the critical direction at the angle psi of observer/critical_light.h, and the way across the ring, towards
    // rays to the sky. About a rotating hole the critical direction is the one between traced rays of both fates.
    struct Place {
        double psi;
        Vec3 critical, across;  // along the camera's right, up, backward
        double off;             // of the edge between fates from `critical`, rad
        double sphere;          // radius of the orbit of light that rays here wind about
        double radius;          // of the ring, rad: half of the angle to the other end of the critical curve
    };
    Place place(double psi) const;

    // The image of a circle of the equatorial plane: the ray whose crossing of it by number, from 1, is at this radius. Rays next to the
    // critical one come to circles outside of the orbit of light on their way to the sky, delta > 0, and to others in the shadow.
    struct Image {
        double delta;  // rad from the critical direction; negative in the shadow, down to its middle
        double swept;  // to there, rad; NaN about a rotating hole
        double delay;  // how long ago the light left, r_s/c, by the camera's clock; NaN where r is not the areal radius
        double azimuth;  // where, with its windings, rad
    };
    // The outermost with |delta| < below; of the few of low number that are on the other side of the critical direction, that. Nothing: no ray
    // has that crossing there. To a few roundings of the view direction, 1e-17 rad, and what the tracer is off by (kerr_ray.h): that over
    // delta, relative. Microseconds a ray in a plane, about a rotating hole some 30 ms.
    std::optional<Image> image(const Place& place, int crossing, double r, double below = 2.5) const;
    // Of the ray at delta; its crossing wherever that is.
    std::optional<Image> image_at(const Place& place, int crossing, double delta) const;

    // What every half orbit does in the end to images of this circle, in spacetime/photon_shell.h's terms: from four successive ones, the last
    // the first that is nearer to the critical direction than kEnd of the ring's radius. What is measured between two tends to it as
    // delta ln(delta), which limit_of takes off with the measured ratio. Nothing: too few images.
    struct HalfOrbit {
        double gamma, delay, azimuth;
    };
    static constexpr double kEnd = 1e-7;
    std::optional<HalfOrbit> half_orbit(const Place& place, double r) const;

private:
    PhotonRing() = default;
    RayPtr ray(const Place& place, double delta) const;
    std::optional<Image> image_on(double side, const Place& place, int crossing, double r, double below) const;
    Scene scene_;
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const Metric> metric_;
    std::shared_ptr<const Bodies> none_;
    std::shared_ptr<const RayFamily> rays_;
    std::optional<CriticalLight> critical_;
};

// The limit of a sequence L + (A + B n) ratio^n from three successive values, by Richardson's rule in two steps.
inline double limit_of(double first, double second, double third, double ratio) {
    const auto step = [&](double before, double after) { return (after - ratio * before) / (1.0 - ratio); };
    return step(step(first, second), step(second, third));
}

}  // namespace nullscope::reference
