// 1 - x^2 - y^2 - z^2 to rounding of the result: the squares are exact sums of two doubles, and so are the differences
// (Knuth, The Art of Computer Programming 2, 4.2.2).
#pragma once
#include "base/exact_product.h"

namespace nullscope {

inline long double one_minus_square(double x, double y, double z) {
    double sum = 1.0, tail = 0.0;
    for (const double part : {x, y, z}) {
        const double square = part * part;
        const double next = sum - square;
        const double taken = sum - next;
        tail += (sum - (next + taken)) + (taken - square) - product_rest(part, part, square);
        sum = next;
    }
    return static_cast<long double>(sum) + tail;
}

}  // namespace nullscope
