#include "spacetime/spacetime.h"

#include <fmt/format.h>

#include <cmath>

namespace nullscope {

double Spacetime::root_v(double r) const { return std::sqrt(lapse_squared(r)) / areal_radius(r); }

Matrix4 Spacetime::metric(double r, double theta) const {
    const double across = areal_radius(r), sine = std::sin(theta);
    Matrix4 g{};
    g[0][0] = -lapse_squared(r);
    g[1][1] = radial_stretch2(r);
    g[2][2] = across * across;
    g[3][3] = across * across * sine * sine;
    return g;
}

Matrix4 Spacetime::inverse_metric(double r, double theta) const {
    Matrix4 g = metric(r, theta);
    for (std::size_t i = 0; i < g.size(); ++i) g[i][i] = 1.0 / g[i][i];
    return g;
}

namespace {
bool within(RadiusRange range, double r) { return r > range.low && r < range.high; }
std::string in_words(RadiusRange range) {
    return range.high < kAnyRadius ? fmt::format("{} < r < {}", range.low, range.high)
                                   : fmt::format("r > {}", range.low);
}
}  // namespace

bool camera_can_rest(const Spacetime& spacetime, double r) { return within(spacetime.camera_range(), r); }
bool camera_can_be(const Spacetime& spacetime, double r) { return within(spacetime.falling_range(), r); }
std::string allowed_radii(const Spacetime& spacetime) { return in_words(spacetime.camera_range()); }
std::string allowed_falling_radii(const Spacetime& spacetime) { return in_words(spacetime.falling_range()); }

}  // namespace nullscope
