// Linear polarisation of a thermal disc's light as the camera sees it, by axes that are carried along the ray (carried_axes.h).
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "reference/carried_axes.h"
#include "reference/disc_light.h"
#include "reference/metric.h"

namespace nullscope::reference {

struct Polarised {
    double r;         // of the crossing, r_s
    double angle;     // of the electric vector from the picture's right towards up, rad, modulo pi
    double fraction;  // polarised, [0, 1]
};

class DiscPolarisation {
public:
    // Errors: a scene without a disc that is polarised, a metric or camera that the reference does not take, light without lensing.
    static Result<DiscPolarisation> make(const Scene& scene);
    // direction: where the photon comes from, along the camera's right, up and backward, unit. crossing: 1 for the first of the equatorial plane,
    // whatever the disc's radii. Nothing: there is none. Some milliseconds.
    enum class Flow { kDisc, kCircle };  // kCircle: as hot spots move, on circles within the last stable one too
    std::optional<Polarised> at(Vec3 direction, int crossing, Flow flow = Flow::kDisc) const;
    std::optional<Polarised> at(double x, double y,
                                int crossing) const;  // of a pixel position: column, row from the top

    const CarryingMetric& carrying() const { return *carrying_; }
    const Tetrad& tetrad() const { return tetrad_; }

private:
    DiscPolarisation() = default;
    CameraSpec camera_;
    PolarisationSpec spec_;
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const Metric> metric_;
    std::shared_ptr<const CarryingMetric> carrying_;
    std::shared_ptr<const DiscLight> light_;
    Tetrad tetrad_{};
};

}  // namespace nullscope::reference
