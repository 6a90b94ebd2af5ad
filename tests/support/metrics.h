// Metrics by their kind.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "spacetime/axial_metric.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope::test {

// nullptr: of the other kind.
inline std::shared_ptr<const SphericalMetric> spherical(const std::shared_ptr<const Spacetime>& spacetime) {
    return {spacetime, spacetime->spherical()};
}
inline std::shared_ptr<const AxialMetric> axial(const std::shared_ptr<const Spacetime>& spacetime) {
    return {spacetime, spacetime->axial()};
}
inline std::shared_ptr<const SphericalMetric> spherical(const std::string& metric,
                                                        const std::map<std::string, double>& parameters = {}) {
    return spherical(*make_spacetime(metric, parameters));
}
inline std::shared_ptr<const AxialMetric> kerr(double spin) { return axial(*make_spacetime("kerr", {{"spin", spin}})); }

}  // namespace nullscope::test
