// Grids of matter.
#include <cmath>

#include "fuzz.h"
#include "reference/medium_grid.h"
#include "scene/medium_grid.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto grid = MediumGrid::parse(fuzz::text_of(data, size), "flow.grid");
    if (!grid) {
        fuzz::must_be_a_good_error(grid.error());
        return 0;
    }
    for (double r = 0.9 * grid->horizon(); r < 2 * grid->farthest(); r *= 1.7)
        for (double theta = 0; theta < 3.2; theta += 0.7)
            for (double phi = -7; phi < 7; phi += 1.3) {
                const auto at = reference::grid_matter(*grid, 1, grid->horizon(), r, theta, phi);
                fuzz::must(std::isfinite(at.density) && at.density <= 1.001 * MediumGrid::kDensest,
                           "a density within its range");
                fuzz::must(std::abs(at.velocity.x) <= 1000 && std::abs(at.velocity.z) <= 1000,
                           "a velocity within its range");
                fuzz::must(std::isfinite(at.field_G) && std::isfinite(at.temperature_K), "finite numbers");
            }
    return 0;
}
