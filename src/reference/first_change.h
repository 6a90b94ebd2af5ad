// The first swept angle at which a function of it falls to 0.
#pragma once
#include <boost/math/tools/minima.hpp>
#include <optional>

#include "reference/root.h"

namespace nullscope::reference {

inline constexpr int kCloserSamples = 64;  // between the looks that found a body

// value > 0 at `outside`, <= 0 at `inside`. A ray that clips an edge and comes back changes sign three times between two looks: closer
// looks find the first; a change of sign is narrowed down by TOMS 748, a dip between three looks by Brent's minimisation.
template <class Value>
double first_change(const Value& value, double outside, double inside) {
    const auto solved = [&](double from, double to) { return root_of(value, from, to, 50); };
    double a = outside, b = outside, b_value = value(outside), a_value = b_value;
    for (int i = 1; i <= kCloserSamples; ++i) {
        const double c = i == kCloserSamples ? inside : outside + (inside - outside) * i / kCloserSamples,
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

struct Look {
    double along, value;
};
// Where a ray enters between three looks in growing order: `here` is the last but one.
template <class Value>
std::optional<double> entry_between(const Value& value, Look before, Look here, Look there) {
    if (!(here.value > 0)) return std::nullopt;
    if (there.value <= 0) return first_change(value, before.value > 0 ? before.along : here.along, there.along);
    if (!(here.value < before.value && here.value <= there.value)) return std::nullopt;
    const auto [along, dip] = boost::math::tools::brent_find_minima(value, before.along, there.along, 40);
    if (dip <= 0) return first_change(value, before.along, along);
    return std::nullopt;
}

}  // namespace nullscope::reference
