#include "fit/goodness.h"

#include <boost/math/special_functions/gamma.hpp>

namespace nullscope::fit {

Goodness goodness_of(double chi2, std::size_t data, std::size_t parameters) {
    Goodness goodness{chi2, static_cast<long long>(data) - static_cast<long long>(parameters)};
    if (goodness.degrees > 0)
        goodness.probability = boost::math::gamma_q(0.5 * static_cast<double>(goodness.degrees), 0.5 * chi2);
    return goodness;
}

}  // namespace nullscope::fit
