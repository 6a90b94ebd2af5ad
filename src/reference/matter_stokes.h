// I, Q, U, V of the light of matter along a ray, for the reference: axes that are carried along the ray by integration (carried_axes.h), and of each
// piece of it, along which matter is taken as even, the exponential of its transfer matrix.
#pragma once
#include <array>
#include <memory>
#include <optional>

#include "base/result.h"
#include "reference/carried_axes.h"
#include "reference/disc_polarisation.h"
#include "reference/electron_light.h"
#include "reference/emission.h"
#include "reference/matter_model.h"

namespace nullscope::reference {

using Stokes = std::array<double, 4>;  // angles from the picture's right towards up; V > 0 turns likewise
using Mueller = std::array<std::array<double, 4>, 4>;

// What gets through matter that is even along a way, exp(-K), and of its own light (the mean of exp(-tK), t = 0 ... 1, times `emitted`). All of K times the
// way: optical depth; a of what is absorbed of Q, U, V; rho, rad.
struct EvenMatter {
    double depth;
    std::array<double, 3> absorbed, turned;
    Stokes emitted;
};
struct EvenLight {
    Mueller through;
    Stokes light;
};
EvenLight even_light(const EvenMatter& matter);  // by its series and squaring: to 1e-14

// Of a whole ray: matter's light, and what of light behind it gets through.
using RayStokes = EvenLight;

class MatterStokes {
public:
    // The scene's camera is not asked for. Errors: a scene without a medium whose light is polarised, one that changes with time, a metric that
    // the reference does not carry axes in, what the medium reads.
    static Result<MatterStokes> make(const Scene& scene);
    Result<CameraAxes> axes_of(const CameraSpec& camera) const;  // errors: no such observer there
    // In the units of linear light of colour 1. direction: where the photon comes from, along the camera's right, up and backward, unit. Some 10 ms.
    RayStokes at(const CameraAxes& from, Vec3 direction) const;

private:
    MatterStokes() = default;
    EvenMatter matter_at(const CarriedAxes& axes, double azimuth, double way) const;
    MediumSpec spec_;
    LightSpec light_;
    double unit_cgs_ = 1, length_cm_ = 1, nearest_ = 0;
    std::shared_ptr<const Spacetime> spacetime_;
    std::shared_ptr<const Metric> metric_;
    std::shared_ptr<const CarryingMetric> carrying_;
    std::shared_ptr<const MatterModel> model_;
    std::optional<SynchrotronElectrons> electrons_;  // that are not thermal
};

}  // namespace nullscope::reference
