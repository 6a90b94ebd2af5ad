// Zeros that were rounded.
#pragma once
#include <cmath>

namespace nullscope {

// 0 for what rounding left of a 0: a sum of terms of size `scale` that cancel. The sines of two machines differ there in all of their digits.
inline double without_rounding(double sum, double scale) {
    constexpr double kRounding = 1e-15;  // some roundings of a double
    return std::fabs(sum) > kRounding * scale ? sum : 0.0;
}

}  // namespace nullscope
