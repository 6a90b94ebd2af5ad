#include "render/star_grid.h"

#include <numeric>

namespace nullscope {
namespace {

constexpr std::size_t kBrightest = 64;  // stars of the first level; each further one has as many as all before it
constexpr double kStarsPerCell = 2.0;   // of a level's grid

}  // namespace

StarGrid::StarGrid(const std::vector<PointStar>& stars, bool bolometric)
    : glow_(bolometric), lights_(star_lights(stars, bolometric)) {
    std::vector<double> power;
    for (std::size_t i = 0; i < stars.size(); ++i)
        power.push_back(std::log2(stars[i].flux) + glow_.part(lights_[i].temperature));
    std::vector<int> order(stars.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return power[static_cast<std::size_t>(a)] > power[static_cast<std::size_t>(b)];
    });
    for (std::size_t from = 0, count = kBrightest; from < order.size(); from += count, count = from) {
        const int* begin = order.data() + from;
        levels_.push_back(level_of(stars, begin, begin + std::min(count, order.size() - from)));
        levels_.back().brightest = power[static_cast<std::size_t>(*begin)];
    }
    double coldest = INFINITY;
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
        for (const Star& star : level->stars) coldest = std::min(coldest, light(star.number).temperature);
        level->coldest = coldest;
    }
}

StarGrid::Level StarGrid::level_of(const std::vector<PointStar>& stars, const int* begin, const int* end) const {
    Level level;
    level.rows =
        std::clamp(static_cast<int>(std::sqrt(static_cast<double>(end - begin) / (2 * kStarsPerCell))), 1, 1024);
    level.columns = 2 * level.rows;
    const auto cell_of = [&](Vec3 v) {
        const int column = std::clamp(static_cast<int>((std::atan2(v.y, v.x) / (2 * M_PI) + 0.5) * level.columns), 0,
                                      level.columns - 1);
        return level.cell(level.row_of(v.z), column);
    };
    level.first.assign(static_cast<std::size_t>(level.rows * level.columns) + 1, 0);
    for (const int* i = begin; i != end; ++i) ++level.first[cell_of(stars[static_cast<std::size_t>(*i)].direction) + 1];
    std::partial_sum(level.first.begin(), level.first.end(), level.first.begin());
    level.stars.resize(static_cast<std::size_t>(end - begin));
    std::vector<int> next = level.first;
    for (const int* i = begin; i != end; ++i) {
        const Vec3 place = stars[static_cast<std::size_t>(*i)].direction;
        level.stars[static_cast<std::size_t>(next[cell_of(place)]++)] = {place, *i};
    }
    return level;
}

}  // namespace nullscope
