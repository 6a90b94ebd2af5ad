// Stars by brightness and by where they are on the sky: who may be seen in a part of it.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec.h"
#include "render/star_glow.h"
#include "sky/point_stars.h"

namespace nullscope {

class StarGrid {
public:
    StarGrid(const std::vector<PointStar>& stars, bool bolometric);

    struct Star {
        Vec3 place;
        int number;  // in the list
    };
    // Stars of like brightness, by cell of a grid of equal steps of z and of the azimuth.
    struct Level {
        double brightest = 0.0;  // log2 of flux in the brightest primary
        double coldest = 0.0;    // log2 of K, of this and of all fainter levels
        int rows = 1, columns = 1;
        std::vector<Star> stars;
        std::vector<int> first;  // of each cell, and the end
        int row_of(double z) const { return std::clamp(static_cast<int>(0.5 * (z + 1) * rows), 0, rows - 1); }
        std::size_t cell(int row, int column) const { return static_cast<std::size_t>(row) * columns + column; }
    };
    const std::vector<Level>& levels() const { return levels_; }  // brightest first
    const StarLight& light(int star) const { return lights_[static_cast<std::size_t>(star)]; }
    const StarGlow& glow() const { return glow_; }

    // visit(star) for all within `radius` rad of a direction, and some more.
    template <class Visit>
    static void visit_near(const Level& level, Vec3 middle, double radius, const Visit& visit) {
        const double theta = std::atan2(std::hypot(middle.x, middle.y), middle.z);
        const double high = std::cos(std::max(theta - radius, 0.0)), low = std::cos(std::min(theta + radius, M_PI));
        const double reach = radius < M_PI / 2 ? std::sin(radius) : 1.0, flat = std::sin(theta),
                     turn = reach < flat ? std::asin(reach / flat) : M_PI;
        const double at = (std::atan2(middle.y, middle.x) / (2 * M_PI) + 0.5) * level.columns,
                     wide = turn / (2 * M_PI) * level.columns;
        const int left = static_cast<int>(std::floor(at - wide)),
                  right = std::min(static_cast<int>(std::floor(at + wide)), left + level.columns - 1);
        for (int row = level.row_of(low); row <= level.row_of(high); ++row)
            for (int column = left; column <= right; ++column) {
                const std::size_t cell = level.cell(row, (column + level.columns) % level.columns);
                for (int i = level.first[cell]; i < level.first[cell + 1]; ++i)
                    visit(level.stars[static_cast<std::size_t>(i)]);
            }
    }

private:
    Level level_of(const std::vector<PointStar>& stars, const int* begin, const int* end) const;
    StarGlow glow_;
    std::vector<StarLight> lights_;
    std::vector<Level> levels_;
};

}  // namespace nullscope
