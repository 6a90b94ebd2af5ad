// A step of a differential equation by extrapolation (W. B. Gragg, SIAM J. Numer. Anal. 2, 384 (1965); R. Bulirsch and J. Stoer, Numer. Math.
// 8, 1 (1966)): midpoint rules with 2, 4, ..., 14 parts of the step, whose errors are even powers of a part, give one of order 14. Of any
// numbers that can be added and scaled, such as Dual: then it solves the variational equations too.
#pragma once
#include <array>
#include <cstddef>

namespace nullscope {

inline constexpr std::size_t kExtrapolations = 7;  // order 2 kExtrapolations, 50 slopes a step, at most
inline constexpr double kEasyStep =
    1e-9;  // counts as the error of a step that takes fewer: the next is four times as long

template <class State>
struct ExtrapolatedStep {
    State end, less_exact;  // the second is of two orders less: their difference is the error of that
    bool enough = false;    // and before all extrapolations were made
};

template <class Number, std::size_t N, class Slope>
std::array<Number, N> midpoints(const std::array<Number, N>& from, const std::array<Number, N>& first, double length,
                                std::size_t parts, const Slope& slope) {
    const double part = length / static_cast<double>(parts);
    std::array<Number, N> before = from, here = from;
    for (std::size_t n = 0; n < N; ++n) here[n] = from[n] + part * first[n];
    for (std::size_t i = 1; i < parts; ++i) {
        const std::array<Number, N> rate = slope(here);
        for (std::size_t n = 0; n < N; ++n) {
            const Number next = before[n] + (2 * part) * rate[n];
            before[n] = here[n], here[n] = next;
        }
    }
    return here;
}

// first: slope(from). enough(end, less_exact): whether these will do, so that nothing more exact is wanted.
template <class Number, std::size_t N, class Slope, class Enough>
ExtrapolatedStep<std::array<Number, N>> extrapolated_step(const std::array<Number, N>& from,
                                                          const std::array<Number, N>& first, double length,
                                                          const Slope& slope, const Enough& enough) {
    constexpr std::size_t kFewest = 3;
    std::array<std::array<Number, N>, kExtrapolations> row;  // Aitken and Neville's, of the last number of parts
    for (std::size_t k = 0;; ++k) {
        std::array<Number, N> better = midpoints(from, first, length, 2 * (k + 1), slope);
        for (std::size_t j = 0; j < k; ++j) {
            const double ratio = static_cast<double>(k + 1) / static_cast<double>(k - j),
                         weight = 1 / (ratio * ratio - 1);
            const std::array<Number, N> known = better;
            for (std::size_t n = 0; n < N; ++n) better[n] = known[n] + weight * (known[n] - row[j][n]);
            row[j] = known;
        }
        if (k + 1 == kExtrapolations) return {better, row[k - 1]};
        if (k + 1 >= kFewest && enough(better, row[k - 1])) return {better, row[k - 1], true};
        row[k] = better;
    }
}

}  // namespace nullscope
