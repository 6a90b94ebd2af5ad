#include "table/distant_polarisation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shadercore/polarised_light.h"
#include "spacetime/axial_metric.h"

namespace nullscope {

DistantPolarisation::DistantPolarisation(std::shared_ptr<const Spacetime> spacetime, double inclination, Vec3 field,
                                         std::optional<double> fraction, Sense sense)
    : spacetime_(std::move(spacetime)),
      flow_(*spacetime_, sense),
      field_{field.x, -field.z, field.y},
      fraction_(fraction) {
    if (const AxialMetric* axial = spacetime_->axial()) a_ = axial->a();
    shift_ = a_ * std::sin(inclination);
}

std::function<std::complex<double>(const DistantPhoton&)> DistantPolarisation::ring(double r) const {
    const PolarisedPlace place{r, a_, disc_lapses(*spacetime_, r, {})[0], disc_velocity(*spacetime_, flow_, r, {}),
                               field_};
    return [place, shift = shift_, fraction = fraction_](const DistantPhoton& photon) {
        const double p_theta = -std::sqrt(std::max(photon.eta, 0.0));  // to the north
        return polarised_light({1.0, photon.lambda, photon.slope, p_theta}, place, fraction,
                               {photon.alpha + shift, photon.beta});
    };
}

}  // namespace nullscope
