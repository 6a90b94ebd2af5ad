// Linear polarisation of a thermal disc's light as the camera sees it, by axes that are carried along the ray (carried_axes.h).
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "reference/carried_axes.h"
#include "reference/disc_light.h"
#include "reference/metric.h"
#include "scene/ray.h"

namespace nullscope::reference {

struct Polarised {
    double r;         // of the crossing, r_s
    double angle;     // of the electric vector from the picture's right towards up, rad, modulo pi
    double fraction;  // polarised, [0, 1]
};

// A camera and its e_0, right, up, backward in ingoing coordinates (v, r, theta, phi~/sin(theta)).
struct CameraAxes {
    CameraSpec camera;
    Tetrad tetrad;
};

// Errors: no such observer there.
Result<CameraAxes> camera_axes(const Spacetime& spacetime, const CameraSpec& camera);

class DiscPolarisation {
public:
    // The scene's camera is not asked for. Errors: a scene without a disc that is polarised, a metric that the reference does not take, light
    // without lensing.
    static Result<DiscPolarisation> make(const Scene& scene);
    // Errors: no such observer there.
    Result<CameraAxes> axes_of(const CameraSpec& camera) const;

    enum class Flow { kDisc, kCircle };  // kCircle: as hot spots move, on circles within the last stable one too
    // direction: where the photon comes from, along the camera's right, up and backward, unit. crossing: 1 for the first of the equatorial plane,
    // whatever the disc's radii. Nothing: there is none. Some milliseconds.
    std::optional<Polarised> at(const CameraAxes& from, Vec3 direction, int crossing, Flow flow = Flow::kDisc) const;
    // The same of a ray of the general form, whose camera looks at the centre.
    std::optional<Polarised> at(const RayQuery& query, int crossing) const;
    const CarryingMetric& carrying() const { return *carrying_; }

private:
    DiscPolarisation() = default;
    CameraAxes turned(CameraAxes axes) const;  // as the disc's own axes have it, where a metric is spherical
    PolarisationSpec spec_;
    DiscPlane plane_;
    LightSpec light_;
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const Metric> metric_;
    std::shared_ptr<const CarryingMetric> carrying_;
    std::shared_ptr<const DiscLight> matter_;
};

}  // namespace nullscope::reference
