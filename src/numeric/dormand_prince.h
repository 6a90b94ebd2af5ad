// Dormand and Prince, J. Comp. Appl. Math. 6, 19 (1980): a step of order 5, with the error of an embedded order 4.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace nullscope {

// state after h; `wrong`: what the step may be off by, component by component. slope: State -> State.
template <std::size_t N, class Slope>
std::array<double, N> dormand_prince(const std::array<double, N>& state, double h, const Slope& slope,
                                     std::array<double, N>& wrong) {
    constexpr double kA[7][6] = {{},
                                 {1. / 5},
                                 {3. / 40, 9. / 40},
                                 {44. / 45, -56. / 15, 32. / 9},
                                 {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
                                 {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
                                 {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
    constexpr double kError[7] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
    std::array<std::array<double, N>, 7> k{};
    std::array<double, N> next = state;
    for (std::size_t i = 0; i < 7; ++i) {
        next = state;
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t n = 0; n < N; ++n) next[n] += h * kA[i][j] * k[j][n];
        k[i] = slope(next);
    }
    for (std::size_t n = 0; n < N; ++n) {
        wrong[n] = 0;
        for (std::size_t i = 0; i < 7; ++i) wrong[n] += h * kError[i] * k[i][n];
    }
    return next;
}

// How the step is changed after one whose error was `error` times what is allowed.
inline double next_step_factor(double error) {
    if (!std::isfinite(error)) return 0.2;
    return std::fmin(std::fmax(0.9 * std::pow(1.0 / std::fmax(error, 1e-17), 0.2), 0.2), 4.0);
}

}  // namespace nullscope
