#include "table/disc_rate.h"

#include <cmath>

#include "spacetime/circular_orbit.h"
#include "table/chebyshev.h"

namespace nullscope {

DiscRate disc_rate(const Spacetime& spacetime, double inner, double outer) {
    const double middle = 0.5 * (std::log(inner) + std::log(outer)), half = 0.5 * std::log(outer / inner);
    return {middle, 1.0 / half, powers_through_chebyshev<12>([&](double x) {
                return circular_rate_scaled(spacetime, std::exp(middle + half * x));
            })};
}

double DiscRate::operator()(double r) const {
    const double x = (std::log(r) - middle) * per_half;
    double sum = 0.0;
    for (auto term = terms.rbegin(); term != terms.rend(); ++term) sum = sum * x + *term;
    return sum;
}

}  // namespace nullscope
