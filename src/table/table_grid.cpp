#include "table/table_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace nullscope {

TableGrid build_table_grid(const DeflectionTable& table, int size, bool with_slopes) {
    const int side = size + 1;
    TableGrid grid{side, 2 * side, with_slopes ? 4 : 1, {}};
    grid.values.resize(static_cast<std::size_t>(grid.width) * grid.height * grid.channels);
    const double h = 1e-4;  // of central differences
    tbb::parallel_for(0, grid.height, [&](int line) {
        const bool turning = line < side;
        const auto at = [&](double x, double y) {
            return turning ? table.turning_remainder(x, y) : table.through_remainder(x, y);
        };
        const double y = static_cast<double>(line % side) / size;
        const double y0 = std::max(y - h, 0.0), y1 = std::min(y + h, 1.0);
        float* out = grid.values.data() + static_cast<std::size_t>(line) * side * grid.channels;
        for (int i = 0; i < side; ++i, out += grid.channels) {
            const double x = static_cast<double>(i) / size;
            out[0] = static_cast<float>(at(x, y));
            if (!with_slopes) continue;
            const double x0 = std::max(x - h, 0.0), x1 = std::min(x + h, 1.0);
            out[1] = static_cast<float>((at(x1, y) - at(x0, y)) / ((x1 - x0) * size));
            out[2] = static_cast<float>((at(x, y1) - at(x, y0)) / ((y1 - y0) * size));
            out[3] = static_cast<float>((at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0)) /
                                        ((x1 - x0) * (y1 - y0) * size * size));
        }
    });
    return grid;
}

}  // namespace nullscope
