// Major axis and (s_c, t_c) of every face.
#include "sky/cube.h"

#include <algorithm>
#include <cmath>

#include "sky/sky.h"

namespace nullscope {

Vec3 cube_direction(int face, double u, double v) {
    const double s = 2.0 * u - 1.0;
    const double t = 2.0 * v - 1.0;
    switch (face) {
        case 0: return {1, -t, -s};
        case 1: return {-1, -t, s};
        case 2: return {s, 1, t};
        case 3: return {s, -1, -t};
        case 4: return {s, -t, 1};
        default: return {-s, -t, -1};
    }
}

CubePosition cube_position(Vec3 d) {
    const double ax = std::fabs(d.x), ay = std::fabs(d.y), az = std::fabs(d.z);
    const auto position = [](int face, double s, double t, double major) {
        return CubePosition{face, 0.5 * (s / major + 1.0), 0.5 * (t / major + 1.0)};
    };
    if (ax >= ay && ax >= az) return d.x > 0 ? position(0, -d.z, -d.y, ax) : position(1, d.z, -d.y, ax);
    if (ay >= az) return d.y > 0 ? position(2, d.x, d.z, ay) : position(3, d.x, -d.z, ay);
    return d.z > 0 ? position(4, d.x, -d.y, az) : position(5, -d.x, -d.y, az);
}

Vec3 sample_sky(const SkyCube& sky, Vec3 direction) {
    const CubePosition p = cube_position(direction);
    const double last = sky.size - 1;
    const double x = std::clamp(p.u * sky.size - 0.5, 0.0, last);
    const double y = std::clamp(p.v * sky.size - 0.5, 0.0, last);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, sky.size - 1), y1 = std::min(y0 + 1, sky.size - 1);
    const Image<float>& face = sky.faces[static_cast<std::size_t>(p.face)];
    const auto texel = [&](int i, int j) {
        const float* c = face.at(i, j);
        return Vec3{c[0], c[1], c[2]};
    };
    const double fx = x - x0, fy = y - y0;
    const Vec3 upper = (1.0 - fx) * texel(x0, y0) + fx * texel(x1, y0);
    const Vec3 lower = (1.0 - fx) * texel(x0, y1) + fx * texel(x1, y1);
    return (1.0 - fy) * upper + fy * lower;
}

}  // namespace nullscope
