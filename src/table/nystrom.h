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
    static constexpr std::array<double, 6> b_slope{151. / 2142, 25. / 522, 275. / 684, 275. / 252, -78125. / 112404, 1. / 12};
};

}  // namespace nullscope
