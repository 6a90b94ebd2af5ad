// Quadrature over one panel.
#pragma once
#include <array>
#include <cstddef>

namespace nullscope {

// 12-point Gauss-Legendre rule on [-1, 1] (positive half; Abramowitz and Stegun, table 25.4).
inline constexpr std::array<double, 6> kGaussNode = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                                                     0.7699026741943047, 0.9041172563704749, 0.9815606342467193};
inline constexpr std::array<double, 6> kGaussWeight = {0.2491470458134028, 0.2334925365383548, 0.2031674267230659,
                                                       0.1600783285433462, 0.1069393259953184, 0.0471753363865118};

// 6-point rule, for cells half as wide.
inline constexpr std::array<double, 3> kShortNode = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
inline constexpr std::array<double, 3> kShortWeight = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};

// 8 and 10 points.
inline constexpr std::array<double, 4> kEightNode = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                     0.9602898564975363};
inline constexpr std::array<double, 4> kEightWeight = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                       0.1012285362903763};
inline constexpr std::array<double, 5> kTenNode = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                                                   0.8650633666889845, 0.9739065285171717};
inline constexpr std::array<double, 5> kTenWeight = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                                                     0.1494513491505806, 0.0666713443086881};

template <std::size_t n, class F>
double gauss_rule(const std::array<double, n>& node, const std::array<double, n>& weight, double low, double high,
                  F&& f) {
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += weight[i] * (f(middle - half * node[i]) + f(middle + half * node[i]));
    return half * sum;
}

template <class F>
double gauss(double low, double high, F&& f) {
    return gauss_rule(kGaussNode, kGaussWeight, low, high, f);
}

}  // namespace nullscope
