// The sixth-order method RKN6(4)6FM for y'' = f(y) (Dormand, El-Mikkawy, Prince 1987).
#pragma once
#include <array>

namespace nullscope {

// The place after a step is that of its last stage: only the slope has weights of its own.
struct Nystrom {
    static constexpr int kStages = 6;
    static constexpr std::array<double, 6> c{0, 1. / 10, 3. / 10, 7. / 10, 17. / 25, 1};
    static constexpr double a[6][5] = {{},
                                       {1. / 200},
                                       {-1. / 2200, 1. / 22},
                                       {637. / 6600, -7. / 110, 7. / 33},
                                       {225437. / 1968750, -30073. / 281250, 65569. / 281250, -9367. / 984375},
                                       {151. / 2142, 5. / 116, 385. / 1368, 55. / 168, -6250. / 28101}};
    static constexpr std::array<double, 6> b_slope{151. / 2142, 25. / 522,        275. / 684,
                                                   275. / 252,  -78125. / 112404, 1. / 12};
};

// x'' = f(x) along with its derivative by a parameter, and how both bend. State: of x, x', dx/dp, dx'/dp, in this order.
template <class State>
struct BentState {
    State state;
    std::array<double, 2> bend;  // force there: {f, df/dp}
};

// One step. force(x, dx/dp): {f, df/dp}; five of them, for the last stage is at the step's end.
template <class State, class Force>
BentState<State> nystrom_step(const BentState<State>& from, double h, const Force& force) {
    const auto& [x0, slope, vary0, vary_slope] = from.state;
    std::array<double, Nystrom::kStages> f{}, g{};
    f[0] = from.bend[0], g[0] = from.bend[1];
    double x = x0, vary = vary0;
    double next_slope = slope + h * Nystrom::b_slope[0] * f[0],
           next_vary_slope = vary_slope + h * Nystrom::b_slope[0] * g[0];
    for (int i = 1; i < Nystrom::kStages; ++i) {
        x = x0 + Nystrom::c[i] * h * slope, vary = vary0 + Nystrom::c[i] * h * vary_slope;
        for (int j = 0; j < i; ++j) {
            x += h * h * Nystrom::a[i][j] * f[j];
            vary += h * h * Nystrom::a[i][j] * g[j];
        }
        const std::array<double, 2> at = force(x, vary);
        f[i] = at[0], g[i] = at[1];
        next_slope += h * Nystrom::b_slope[i] * f[i];
        next_vary_slope += h * Nystrom::b_slope[i] * g[i];
    }
    return {{x, next_slope, vary, next_vary_slope}, {f.back(), g.back()}};
}

// The part s of a step of length h: quintics with place, slope and bend of both ends. Error: h^6 x^(6)/46080, of the slope h^5 x^(6)/7000.
template <class State>
State nystrom_between(const BentState<State>& from, const BentState<State>& to, double h, double s) {
    const auto quintic = [&](double x0, double v0, double f0, double x1, double v1, double f1) {
        const double c1 = h * v0, c2 = 0.5 * h * h * f0;
        const double d = x1 - x0 - c1 - c2, dv = h * v1 - c1 - 2 * c2, df = h * h * f1 - 2 * c2;
        const double c3 = 10 * d - 4 * dv + 0.5 * df, c4 = -15 * d + 7 * dv - df, c5 = 6 * d - 3 * dv + 0.5 * df;
        return std::array{x0 + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5)))),
                          (c1 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h};
    };
    const auto& [x0, slope0, vary0, vary_slope0] = from.state;
    const auto& [x1, slope1, vary1, vary_slope1] = to.state;
    const auto x = quintic(x0, slope0, from.bend[0], x1, slope1, to.bend[0]);
    const auto vary = quintic(vary0, vary_slope0, from.bend[1], vary1, vary_slope1, to.bend[1]);
    return {x[0], x[1], vary[0], vary[1]};
}

}  // namespace nullscope
