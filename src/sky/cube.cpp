// Cube map geometry by the OpenGL 3.3 core specification, table 3.19: major axis and (s_c, t_c) of every face.
#include <tbb/parallel_for.h>

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

SkyCube with_borders(const SkyCube& sky) {
    const int border = sky.size / kBorderOf;
    SkyCube wide;
    wide.size = bordered_size(sky.size);
    wide.notes = sky.notes;
    tbb::parallel_for(std::size_t{0}, sky.faces.size(), [&](std::size_t face) {
        Image<float>& image = wide.faces[face] = Image<float>(wide.size, wide.size, 3);
        const auto fill = [&](int y, int first, int last) {
            for (int x = first; x < last; ++x) {
                const Vec3 light = sample_sky(sky, cube_direction(static_cast<int>(face), (x - border + 0.5) / sky.size, (y - border + 0.5) / sky.size));
                float* out = image.at(x, y);
                out[0] = static_cast<float>(light.x), out[1] = static_cast<float>(light.y), out[2] = static_cast<float>(light.z);
            }
        };
        for (int y = 0; y < wide.size; ++y) {
            if (y < border || y >= wide.size - border) {
                fill(y, 0, wide.size);
                continue;
            }
            fill(y, 0, border);
            std::copy_n(sky.faces[face].at(0, y - border), 3 * sky.size, image.at(border, y));
            fill(y, wide.size - border, wide.size);
        }
    });
    return wide;
}

}  // namespace nullscope
