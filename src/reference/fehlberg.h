// Fehlberg, NASA TR R-287 (1968), table X: a step of order 8, with the error of an embedded order 7, of an equation without the time in it.
#pragma once
#include <array>
#include <cstddef>

namespace nullscope::reference {

// state after h; `wrong`: what the step may be off by, component by component. slope: State -> State. 13 slopes.
template <class Real, std::size_t N, class Slope>
std::array<Real, N> fehlberg(const std::array<Real, N>& state, Real h, const Slope& slope, std::array<Real, N>& wrong) {
    constexpr std::size_t kStages = 13;
    // Of each stage: a common denominator, and the numerators of the slopes before it; last the sum itself.
    static constexpr int kOver[kStages + 1] = {1, 27, 36, 24, 48, 20, 108, 900, 90, 540, 4100, 205, 4100, 840};
    static constexpr short kPart[kStages + 1][kStages] = {
        {},
        {2},
        {1, 3},
        {1, 0, 3},
        {20, 0, -75, 75},
        {1, 0, 0, 5, 4},
        {-25, 0, 0, 125, -260, 250},
        {93, 0, 0, 0, 244, -200, 13},
        {180, 0, 0, -795, 1408, -1070, 67, 270},
        {-455, 0, 0, 115, -3904, 3110, -171, 1530, -45},
        {2383, 0, 0, -8525, 17984, -15050, 2133, 2250, 1125, 1800},
        {3, 0, 0, 0, 0, -30, -3, -15, 15, 30},
        {-1777, 0, 0, -8525, 17984, -14450, 2193, 2550, 825, 1200, 0, 4100},
        {0, 0, 0, 0, 0, 272, 216, 216, 27, 27, 0, 41, 41}};
    std::array<std::array<Real, N>, kStages> k{};
    std::array<Real, N> next = state;
    for (std::size_t i = 0; i <= kStages; ++i) {
        for (std::size_t n = 0; n < N; ++n) {
            Real sum = 0;
            for (std::size_t j = 0; j < kStages && j < i; ++j) sum += kPart[i][j] * k[j][n];
            next[n] = state[n] + h * sum / kOver[i];
        }
        if (i < kStages) k[i] = slope(next);
    }
    for (std::size_t n = 0; n < N; ++n) wrong[n] = h * 41 / 840 * (k[0][n] + k[10][n] - k[11][n] - k[12][n]);
    return next;
}

}  // namespace nullscope::reference
