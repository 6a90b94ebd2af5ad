// Inside render/star_mesh.cpp only: a cell of the mesh, the sky that it covers, and the sky between its nodes.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"

namespace nullscope::mesh {

struct Node {
    Vec3 sky;
    double g = 0;
    bool there = false;
};

struct Cell {
    double x, y, size;            // px, lower left corner
    std::array<Node, 4> corners;  // (0, 0), (1, 0), (0, 1), (1, 1)
    int there() const {
        return static_cast<int>(std::count_if(corners.begin(), corners.end(), [](const Node& n) { return n.there; }));
    }
};

struct Cap {  // of the sky, about a cell's
    Vec3 middle;
    double radius;
};

// About a cell's sky, long as its longer diagonal; next to the shadow cells are slivers.
class Box {
public:
    explicit Box(const Cell& cell) {
        const auto& c = cell.corners;
        const Vec3 a = c[3].sky - c[0].sky, b = c[2].sky - c[1].sky, longer = dot(a, a) > dot(b, b) ? a : b;
        const double extent = length(longer);
        along_ = extent > 0 ? longer / extent : Vec3{1, 0, 0};
        across_ = cross(normalized(c[0].sky + c[1].sky + c[2].sky + c[3].sky), along_);
        for (const Node& n : c) {
            const double u = dot(n.sky, along_), v = dot(n.sky, across_);
            low_[0] = std::min(low_[0], u), high_[0] = std::max(high_[0], u), low_[1] = std::min(low_[1], v),
            high_[1] = std::max(high_[1], v);
        }
        for (std::size_t i = 0; i < 2; ++i) low_[i] -= kBow * extent, high_[i] += kBow * extent;
    }
    bool has(Vec3 star) const {
        const double u = dot(star, along_), v = dot(star, across_);
        return u >= low_[0] && u <= high_[0] && v >= low_[1] && v <= high_[1];
    }

private:
    static constexpr double kBow = 0.15;  // of the extent: how far its sky may reach beyond its corners'
    Vec3 along_, across_;
    std::array<double, 2> low_{INFINITY, INFINITY}, high_{-INFINITY, -INFINITY};
};

struct Local {
    Vec3 sky, by_x, by_y;
    double g = 0;
};

// Polynomials through values at equal steps, and their slopes: N = 4 at -1, 0, 1, 2; N = 3 at 0, 1/2, 1.
template <std::size_t N>
std::array<double, N> weights(double t) {
    if constexpr (N == 4)
        return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
                (t + 1) * t * (t - 1) / 6};
    else
        return {(2 * t - 1) * (t - 1), 4 * t * (1 - t), t * (2 * t - 1)};
}
template <std::size_t N>
std::array<double, N> slopes(double t) {
    if constexpr (N == 4)
        return {-(3 * t * t - 6 * t + 2) / 6, (3 * t * t - 4 * t - 1) / 2, -(3 * t * t - 2 * t - 2) / 2,
                (3 * t * t - 1) / 6};
    else
        return {4 * t - 3, 4 - 8 * t, 4 * t - 1};
}

// nodes: N rows of N.
template <std::size_t N>
Local interpolated(const std::array<std::array<Node, N>, N>& nodes, const Cell& cell, double x, double y) {
    const double s = (x - cell.x) / cell.size, t = (y - cell.y) / cell.size;
    const auto a = weights<N>(s), b = weights<N>(t), da = slopes<N>(s), db = slopes<N>(t);
    Local local;
    for (std::size_t j = 0; j < N; ++j)
        for (std::size_t i = 0; i < N; ++i) {
            const Node& node = nodes[j][i];
            local.sky = local.sky + a[i] * b[j] * node.sky;
            local.by_x = local.by_x + da[i] * b[j] / cell.size * node.sky;
            local.by_y = local.by_y + a[i] * db[j] / cell.size * node.sky;
            local.g += a[i] * b[j] * node.g;
        }
    return local;
}

inline double edge(Vec3 a, Vec3 b, Vec3 star) { return dot(cross(a - star, b - star), star); }

inline Cap cap_of(const Cell& cell) {
    Vec3 sum;
    for (const Node& n : cell.corners) sum = sum + n.sky;
    Cap cap{normalized(sum), 0};
    for (const Node& n : cell.corners) cap.radius = std::max(cap.radius, angle_between(cap.middle, n.sky));
    return cap;
}

inline double extent(const Cell& cell) {
    const auto& c = cell.corners;
    return std::max(length(c[3].sky - c[0].sky), length(c[2].sky - c[1].sky));
}

}  // namespace nullscope::mesh
