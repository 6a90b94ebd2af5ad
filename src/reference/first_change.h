// The first swept angle at which a function of it falls to 0.
#pragma once
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace nullscope::reference {

inline constexpr int kCloserLooks = 64;  // between the looks that found a body

// value > 0 at `outside`, <= 0 at `inside`. A ray that clips an edge and comes back changes sign three times between two looks: closer
// looks find the first; a change of sign is narrowed down by TOMS 748, a dip between three looks by Brent's minimisation.
template <class Value>
double first_change(const Value& value, double outside, double inside) {
    const auto solved = [&](double from, double to) {
        std::uintmax_t steps = 200;
        const auto root =
            boost::math::tools::toms748_solve(value, from, to, boost::math::tools::eps_tolerance<double>(50), steps);
        return 0.5 * (root.first + root.second);
    };
    double a = outside, b = outside, b_value = value(outside), a_value = b_value;
    for (int i = 1; i <= kCloserLooks; ++i) {
        const double c = i == kCloserLooks ? inside : outside + (inside - outside) * i / kCloserLooks,
                     c_value = value(c);
        if (b_value > 0 && c_value > 0 && b_value < a_value && b_value <= c_value) {
            const auto [dip_angle, dip] = boost::math::tools::brent_find_minima(value, a, c, 40);
            if (dip <= 0) return solved(a, dip_angle);
        }
        if (c_value <= 0) return solved(b, c);
        a = b, a_value = b_value, b = c, b_value = c_value;
    }
    return inside;
}

}  // namespace nullscope::reference
