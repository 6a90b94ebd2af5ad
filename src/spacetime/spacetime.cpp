#include "spacetime/spacetime.h"

#include <cmath>

namespace nullscope {

Matrix4 Spacetime::metric(double r, double theta) const {
    const double a = lapse_squared(1.0 / r);
    const double sine = std::sin(theta);
    Matrix4 g{};
    g[0][0] = -a;
    g[1][1] = 1.0 / a;
    g[2][2] = r * r;
    g[3][3] = r * r * sine * sine;
    return g;
}

Matrix4 Spacetime::inverse_metric(double r, double theta) const {
    const double a = lapse_squared(1.0 / r);
    const double sine = std::sin(theta);
    Matrix4 g{};
    g[0][0] = -1.0 / a;
    g[1][1] = a;
    g[2][2] = 1.0 / (r * r);
    g[3][3] = 1.0 / (r * r * sine * sine);
    return g;
}

}  // namespace nullscope
