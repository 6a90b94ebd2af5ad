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

    // A place on the ring: the critical direction at the angle psi of observer/critical_light.h, and the way across the ring, towards
    // rays to the sky. About a rotating hole the critical direction is the one between traced rays of both fates.
    struct Place {
        double psi;
        Vec3 critical, across;  // along the camera's right, up, backward
        double off;             // of the edge between fates from `critical`, rad
        double sphere;          // radius of the orbit of light that rays here wind about
    };
    Place place(double psi) const;

    // The image of a circle of the equatorial plane: the ray whose crossing of it by number, from 1, is at this radius.
    struct Image {
        double
            delta;  // rad from the critical direction; negative on the side of the shadow, where the circle is within the orbit of light
        double swept;    // to there, rad; NaN about a rotating hole
        double delay;    // how long ago the light left, r_s/c, by the camera's clock; NaN in wormholes
        double azimuth;  // where, with its windings, rad
    };
    // below: of |delta|. Nothing: no ray has that crossing there. To a few roundings of the view direction, 1e-17 rad, and what the tracer is
    // off by (kerr_ray.h): that over delta, relative. Microseconds a ray in a plane, about a rotating hole some 30 ms.
    std::optional<Image> image(const Place& place, int crossing, double r, double below = 2.5) const;
    // Of the ray at delta; its crossing wherever that is.
    std::optional<Image> image_at(const Place& place, int crossing, double delta) const;

    // What every half orbit does in the end to images of this circle, in spacetime/photon_shell.h's terms: from four successive ones, the last
    // the first that is nearer to the critical direction than kEnd of the ring's radius. What is measured between two tends to it as
    // delta ln(delta), which Richardson's rule takes off in two steps, with the measured ratio. Nothing: too few images.
    struct HalfOrbit {
        double gamma, delay, azimuth;
    };
    static constexpr double kEnd = 1e-7;
    std::optional<HalfOrbit> half_orbit(const Place& place, double r) const;

private:
    PhotonRing() = default;
    RayPtr ray(const Place& place, double delta) const;
    Scene scene_;
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const Metric> metric_;
    std::shared_ptr<const Bodies> none_;
    std::shared_ptr<const RayFamily> rays_;
    std::optional<CriticalLight> critical_;
};

}  // namespace nullscope::reference
