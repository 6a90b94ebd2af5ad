// Lorentz matrices on (t, x, y, z), signature (-,+,+,+): boosts, and what a sequence of them amounts to.
#pragma once
#include <array>
#include <cmath>

#include "base/vec.h"

namespace nullscope {

using Lorentz = std::array<std::array<double, 4>, 4>;  // rows

// The pure boost that takes (1, 0) to gamma (1, v). |v| < 1. Entries to rounding of themselves.
inline Lorentz boost(Vec3 v) {
    const double speed = length(v), gamma = 1.0 / std::sqrt((1.0 - speed) * (1.0 + speed));
    const double w[3] = {gamma * v.x, gamma * v.y, gamma * v.z};
    Lorentz m{};
    m[0][0] = gamma;
    for (int i = 0; i < 3; ++i) {
        m[0][i + 1] = m[i + 1][0] = w[i];
        for (int j = 0; j < 3; ++j) m[i + 1][j + 1] = (i == j ? 1.0 : 0.0) + w[i] * w[j] / (1.0 + gamma);
    }
    return m;
}

inline Lorentz operator*(const Lorentz& a, const Lorentz& b) {
    Lorentz m{};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
    return m;
}

// m = boost(velocity) rotation. Errors grow as gamma^2.
struct BoostAndTurn {
    Vec3 velocity;
    Mat3 turn;
};
inline BoostAndTurn split(const Lorentz& m) {
    const Vec3 v{m[1][0] / m[0][0], m[2][0] / m[0][0], m[3][0] / m[0][0]};
    const Lorentz r = boost(-v) * m;
    return {v, {{r[1][1], r[2][1], r[3][1]}, {r[1][2], r[2][2], r[3][2]}, {r[1][3], r[2][3], r[3][3]}}};
}

}  // namespace nullscope
