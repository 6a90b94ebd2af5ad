// The deflection table as the GPU gets it for method kTable: two branches of (size + 1)^2 nodes, turning above through.
#pragma once
#include <vector>

#include "table/deflection_table.h"

namespace nullscope {

struct TableGrid {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
};

// channels 1: R; with_slopes: 4, (R, dR/dx, dR/dy, d2R/dxdy) per cell. Parallel; 0.1 to 0.9 microseconds a node.
TableGrid build_table_grid(const DeflectionTable& table, int size, bool with_slopes);

}  // namespace nullscope
