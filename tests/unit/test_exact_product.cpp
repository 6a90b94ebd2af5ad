// Products with their rounding errors, against arithmetic of 50 digits. std::fma must not be what they hang on: that of some C++ libraries
// is wrong (findings/mingw-fma.sh), and this test then fails with it: 422 of the products.
#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "base/exact_product.h"
#include "numeric/one_minus_square.h"

using namespace nullscope;

TEST_CASE("exact product: a product and its rest are all of it") {
    using Exact = boost::multiprecision::cpp_bin_float_50;
    std::mt19937_64 random(20261130);
    std::uniform_real_distribution<double> mantissa(-2, 2);
    std::uniform_int_distribution<int> exponent(-300, 300);
    int inexact = 0, wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const double a = std::ldexp(mantissa(random), exponent(random));
        const double b = std::ldexp(mantissa(random), exponent(random));
        const double product = a * b, rest = product_rest(a, b, product);
        inexact += rest != 0 ? 1 : 0;
        wrong += Exact(product) + Exact(rest) == Exact(a) * Exact(b) ? 0 : 1;
    }
    CHECK(wrong == 0);
    CHECK(inexact > 19000);  // else it would test nothing
}

TEST_CASE("exact product: 1 - v^2 keeps its digits next to the speed of light") {
    const double v = 1 - 0x1p-40;
    CHECK(one_minus_square(0, v, 0) == static_cast<long double>(0x1p-39) - 0x1p-80L);
}
