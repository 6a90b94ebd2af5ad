#include "table/surface_clearance.h"

#include <algorithm>
#include <cmath>

#include "expr/interval.h"

namespace nullscope {
namespace {

using expr::Interval;

constexpr int kSide = kClearanceCells, kCells = kSide * kSide * kSide;
static_assert(kCells % kClearanceWidth == 0);
constexpr double kMostOperations = 8e6;  // on intervals, of one solid: some 0.1 s
constexpr double kEver = 1e30;           // r_s/c: the time of a solid that moves

int cell_at(int x, int y, int z) { return (z * kSide + y) * kSide + x; }

// Of the cube of `size` cells a side from there on.
struct Cube {
    int x, y, z;
};

bool is_empty(const expr::Formula& formula, double bound, const Cube& cube, int size) {
    const auto along = [&](int from) {
        const double cell = 2 * bound / kSide, low = -bound + from * cell;
        return Interval{low, low + size * cell};
    };
    const Interval box[] = {along(cube.x), along(cube.y), along(cube.z), {-kEver, kEver}};
    double nearest2 = 0;  // to the centre
    for (int axis = 0; axis < 3; ++axis) {
        const double off = std::max({box[axis].low, -box[axis].high, 0.0});
        nearest2 += off * off;
    }
    return nearest2 > bound * bound || range(formula, box).low > 0;
}

// Sets the cells to 0 that the solid may be in: cubes of cells are halved until they are empty or single, or it takes too long.
void fill(const expr::Formula& formula, double bound, float* cells) {
    auto left = static_cast<std::size_t>(kMostOperations) / formula.nodes().size();
    std::vector<Cube> level = {{0, 0, 0}};
    int size = kSide;
    for (;; size /= 2) {
        std::erase_if(level, [&](const Cube& cube) { return is_empty(formula, bound, cube, size); });
        left -= std::min(left, level.size());
        if (size == 1 || 8 * level.size() > left) break;
        std::vector<Cube> parts;
        for (const Cube& cube : level)
            for (int part = 0; part < 8; ++part)
                parts.push_back({cube.x + (part & 1) * size / 2, cube.y + (part >> 1 & 1) * size / 2,
                                 cube.z + (part >> 2) * size / 2});
        level.swap(parts);
    }
    for (const Cube& cube : level)
        for (int z = cube.z; z < cube.z + size; ++z)
            for (int y = cube.y; y < cube.y + size; ++y) std::fill_n(cells + cell_at(cube.x, y, z), size, 0.0f);
}

// Distances from the cells that are 0, by the largest along an axis: forward and backward over all neighbours.
void spread(float* cells) {
    const auto pass = [&](int way) {
        for (int i = 0; i < kCells; ++i) {
            const int at = way > 0 ? i : kCells - 1 - i, x = at % kSide, y = at / kSide % kSide,
                      z = at / (kSide * kSide);
            float& here = cells[at];
            for (int n = 0; n < 13 && here > 0; ++n) {  // the 13 of 26 neighbours that come before it
                const int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dz = n / 9 - 1;
                const int nx = x + way * dx, ny = y + way * dy, nz = z + way * dz;
                if (std::min({nx, ny, nz}) < 0 || std::max({nx, ny, nz}) >= kSide) continue;
                here = std::min(here, cells[cell_at(nx, ny, nz)] + 1);
            }
        }
    };
    pass(1);
    pass(-1);
}

}  // namespace

bool SurfaceClearances::update(const std::set<SolidFormula>& solids) {
    std::map<SolidFormula, int> wanted;
    for (const SolidFormula& solid : solids)
        if (wanted.size() < kMostClearances) wanted.emplace(solid, static_cast<int>(wanted.size()) * kCells);
    if (wanted == first_) return false;
    std::vector<float> cells(wanted.size() * kCells, static_cast<float>(kSide));
    for (const auto& [solid, first] : wanted) {
        float* to = cells.data() + first;
        if (const auto known = first_.find(solid); known != first_.end()) {
            std::copy_n(cells_.data() + known->second, kCells, to);
            continue;
        }
        const auto formula = expr::Formula::parse(solid.formula, {"x", "y", "z", "t"});
        if (!formula) {  // no scene has one: nothing is passed over
            std::fill_n(to, kCells, 0.0f);
            continue;
        }
        fill(*formula, solid.bound, to);
        spread(to);
    }
    first_ = std::move(wanted), cells_ = std::move(cells);
    return true;
}

int SurfaceClearances::first_cell(const SolidFormula& solid) const {
    const auto found = first_.find(solid);
    return found != first_.end() ? found->second : -1;
}

}  // namespace nullscope
