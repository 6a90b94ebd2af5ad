// The sixth-order method RKN6(4)6FM for y'' = f(y) (Dormand, El-Mikkawy, Prince 1987).
#pragma once
#include <array>

namespace nullscope {

struct Nystrom {
    static constexpr int kStages = 6;
    static constexpr std::array<double, 6> c{0, 1. / 10, 3. / 10, 7. / 10, 17. / 25, 1};
    static constexpr double a[6][5] = {{},
                                       {1. / 200},
                                       {-1. / 2200, 1. / 22},
                                       {637. / 6600, -7. / 110, 7. / 33},
                                       {225437. / 1968750, -30073. / 281250, 65569. / 281250, -9367. / 984375},
                                       {151. / 2142, 5. / 116, 385. / 1368, 55. / 168, -6250. / 28101}};
    static constexpr std::array<double, 6> b{151. / 2142, 5. / 116, 385. / 1368, 55. / 168, -6250. / 28101, 0};
    static constexpr std::array<double, 6> b_slope{151. / 2142, 25. / 522,        275. / 684,
                                                   275. / 252,  -78125. / 112404, 1. / 12};
};

// A step of x'' = f(x) along with its derivative by a parameter. State: of x, x', dx/dp, dx'/dp, in this order. force(x, dx/dp): {f, df/dp}.
template <class State, class Force>
State nystrom_step(const State& s, double h, const Force& force) {
    const auto& [x0, slope, vary0, vary_slope] = s;
    std::array<double, Nystrom::kStages> f{}, g{};
    for (int i = 0; i < Nystrom::kStages; ++i) {
        double x = x0 + Nystrom::c[i] * h * slope, vary = vary0 + Nystrom::c[i] * h * vary_slope;
        for (int j = 0; j < i; ++j) {
            x += h * h * Nystrom::a[i][j] * f[j];
            vary += h * h * Nystrom::a[i][j] * g[j];
        }
        const std::array<double, 2> at = force(x, vary);
        f[i] = at[0], g[i] = at[1];
    }
    double x = x0 + h * slope, vary = vary0 + h * vary_slope, next_slope = slope, next_vary_slope = vary_slope;
    for (int i = 0; i < Nystrom::kStages; ++i) {
        x += h * h * Nystrom::b[i] * f[i];
        vary += h * h * Nystrom::b[i] * g[i];
        next_slope += h * Nystrom::b_slope[i] * f[i];
        next_vary_slope += h * Nystrom::b_slope[i] * g[i];
    }
    return {x, next_slope, vary, next_vary_slope};
}

}  // namespace nullscope
