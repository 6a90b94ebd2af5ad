#include "image/colour_space.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kSamePrimaries = 0.002;  // x and y are written with three or four digits

// Of unit luminance.
Vec3 xyz_of(Chromaticity c) { return {c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y}; }

double volume(const Mat3& m) { return dot(m.a, cross(m.b, m.c)); }

Mat3 inverse(const Mat3& m) {
    const double v = volume(m);
    return transposed({cross(m.b, m.c) / v, cross(m.c, m.a) / v, cross(m.a, m.b) / v});
}

// R = G = B = 1 is white.
Mat3 xyz_from_rgb(const Primaries& p) {
    const Mat3 unit{xyz_of(p.red), xyz_of(p.green), xyz_of(p.blue)};
    const Vec3 share = inverse(unit) * xyz_of(p.white);
    return {share.x * unit.a, share.y * unit.b, share.z * unit.c};
}

// Lam (1985): white of `from` becomes white of `to`.
Mat3 bradford(Chromaticity from, Chromaticity to) {
    const Mat3 cones{{0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296}};
    const Vec3 f = cones * xyz_of(from), t = cones * xyz_of(to);
    return inverse(cones) * Mat3{{t.x / f.x, 0, 0}, {0, t.y / f.y, 0}, {0, 0, t.z / f.z}} * cones;
}

double distance(Chromaticity a, Chromaticity b) { return std::max(std::fabs(a.x - b.x), std::fabs(a.y - b.y)); }

}  // namespace

Mat3 light_matrix(const Primaries& from, const Primaries& to) {
    return inverse(xyz_from_rgb(to)) * bradford(from.white, to.white) * xyz_from_rgb(from);
}

std::optional<Mat3> rec709_from(const Primaries& p) {
    for (const Chromaticity c : {p.red, p.green, p.blue, p.white})
        if (!(std::fabs(c.x) < 10.0) || !(std::fabs(c.y) < 10.0) || std::fabs(c.y) < 1e-6) return std::nullopt;
    if (std::fabs(volume({xyz_of(p.red), xyz_of(p.green), xyz_of(p.blue)})) < 1e-9) return std::nullopt;
    const double apart = std::max({distance(p.red, kRec709Primaries.red), distance(p.green, kRec709Primaries.green),
                                   distance(p.blue, kRec709Primaries.blue), distance(p.white, kRec709Primaries.white)});
    if (apart < kSamePrimaries) return std::nullopt;
    return light_matrix(p, kRec709Primaries);
}

}  // namespace nullscope
