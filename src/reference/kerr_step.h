// A step of Fehlberg's formula of order 8, with its error (NASA TR R-287, 1968, table X).
//
// That error, h 41/840 (k_0 + k_10 - k_11 - k_12), is of slopes at the two ends. Where the slope is a function of the
// independent variable alone it is 0 at any length, and light far from the hole nearly is on a straight line: there the
// step has a bound of its own, straight_step().
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace nullscope::reference {

template <std::size_t N>
struct FehlbergStep {
    using State = std::array<double, N>;
    State end;
    double error = 0;  // the worst component's, over 1 + |state| + h |slope|

    // system(state, slope, at): the slope at a state and at a part `at` of [0, h] of the independent variable.
    template <class System>
    FehlbergStep(const System& system, const State& start, double h) {
        std::array<State, 13> k;
        const auto stage = [&](std::size_t i, double at, const auto&... terms) {
            for (std::size_t n = 0; n < N; ++n)
                end[n] = start[n] + h * ((terms.first * k[terms.second][n]) + ... + 0.0);
            system(end, k[i], at * h);
        };
        using T = Term;
        stage(0, 0);
        stage(1, 2. / 27, T{2. / 27, 0});
        stage(2, 1. / 9, T{1. / 36, 0}, T{1. / 12, 1});
        stage(3, 1. / 6, T{1. / 24, 0}, T{1. / 8, 2});
        stage(4, 5. / 12, T{5. / 12, 0}, T{-25. / 16, 2}, T{25. / 16, 3});
        stage(5, 1. / 2, T{1. / 20, 0}, T{1. / 4, 3}, T{1. / 5, 4});
        stage(6, 5. / 6, T{-25. / 108, 0}, T{125. / 108, 3}, T{-65. / 27, 4}, T{125. / 54, 5});
        stage(7, 1. / 6, T{31. / 300, 0}, T{61. / 225, 4}, T{-2. / 9, 5}, T{13. / 900, 6});
        stage(8, 2. / 3, T{2., 0}, T{-53. / 6, 3}, T{704. / 45, 4}, T{-107. / 9, 5}, T{67. / 90, 6}, T{3., 7});
        stage(9, 1. / 3, T{-91. / 108, 0}, T{23. / 108, 3}, T{-976. / 135, 4}, T{311. / 54, 5}, T{-19. / 60, 6},
              T{17. / 6, 7}, T{-1. / 12, 8});
        stage(10, 1, T{2383. / 4100, 0}, T{-341. / 164, 3}, T{4496. / 1025, 4}, T{-301. / 82, 5}, T{2133. / 4100, 6},
              T{45. / 82, 7}, T{45. / 164, 8}, T{18. / 41, 9});
        stage(11, 0, T{3. / 205, 0}, T{-6. / 41, 5}, T{-3. / 205, 6}, T{-3. / 41, 7}, T{3. / 41, 8}, T{6. / 41, 9});
        stage(12, 1, T{-1777. / 4100, 0}, T{-341. / 164, 3}, T{4496. / 1025, 4}, T{-289. / 82, 5}, T{2193. / 4100, 6},
              T{51. / 82, 7}, T{33. / 164, 8}, T{12. / 41, 9}, T{1., 11});
        for (std::size_t n = 0; n < N; ++n) {
            const double ends = k[11][n] + k[12][n];
            end[n] =
                start[n] + h / 840 * (272 * k[5][n] + 27 * (k[8][n] + k[9][n]) + 216 * (k[6][n] + k[7][n]) + 41 * ends);
            const double allowed = 1 + std::abs(start[n]) + std::abs(h * k[0][n]);
            error = std::fmax(error, 41. / 840 * std::abs(h * (k[0][n] + k[10][n] - ends)) / allowed);
            if (!std::isfinite(end[n])) error = INFINITY;
        }
    }

private:
    struct Term {
        double first;
        std::size_t second;
    };
};

// The longest step at a distance r from the hole along a straight line. There the formula is the sum of Newton and
// Cotes over seven places, which is off by 9/1400 (h/6)^9 times the eighth derivative of the slope: of light's momentum
// that is 2/r^2 at most, of its delay 2/r, with derivatives 2 9!/r^10 and 2 8!/r^9. `bent`, rad, and `delay`, r_s/c:
// what these may come to.
inline double straight_step(double r, double bent, double delay) {
    return 6 * r * std::pow(std::fmin(bent * r / 4666, delay / 518), 1. / 9);
}

// How much longer the next step is than one whose error was `error` times what is allowed.
inline double next_fehlberg(double error) { return std::fmin(std::fmax(0.9 * std::pow(error, -0.125), 0.2), 5.0); }

}  // namespace nullscope::reference
