#include "observer/turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nullscope {

Mat3 axes_of(Quaternion q) {
    return {{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)},
            {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)},
            {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}};
}

// The products of q's largest component, which is a half or more, with all of them (Shepperd 1978).
Quaternion turn_of(const Mat3& m) {
    const std::array<std::array<double, 4>, 4> products = {
        {{1 + m.a.x + m.b.y + m.c.z, m.b.z - m.c.y, m.c.x - m.a.z, m.a.y - m.b.x},
         {m.b.z - m.c.y, 1 + m.a.x - m.b.y - m.c.z, m.a.y + m.b.x, m.c.x + m.a.z},
         {m.c.x - m.a.z, m.a.y + m.b.x, 1 - m.a.x + m.b.y - m.c.z, m.b.z + m.c.y},
         {m.a.y - m.b.x, m.c.x + m.a.z, m.b.z + m.c.y, 1 - m.a.x - m.b.y + m.c.z}}};
    std::size_t largest = 0;
    for (std::size_t i = 1; i < 4; ++i)
        if (products[i][i] > products[largest][largest]) largest = i;
    const auto& [w, x, y, z] = products[largest];
    const double scale = 1 / std::hypot(std::hypot(w, x), std::hypot(y, z));
    return {scale * w, scale * x, scale * y, scale * z};
}

Mat3 axes_between(const Mat3& from, const Mat3& to, double t) {
    const auto [w, x, y, z] = turn_of(transposed(from) * to);
    const double across = length(Vec3{x, y, z}), half = std::atan2(across, std::fabs(w));
    if (across == 0) return from;
    const double share = std::copysign(std::sin(t * half) / across, w);
    return from * axes_of({std::cos(t * half), share * x, share * y, share * z});
}

}  // namespace nullscope
