// Grids of matter made of functions, as files (scene/medium_grid.h).
#pragma once
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

namespace nullscope::test {

using GridNode = std::array<double, 8>;  // density, temperature, field, velocity

struct GridForm {
    const char* coordinates = "kerr-schild";
    double spin = 0;
    double nearest = 1.1, farthest = 10;
    int rings = 5;
    double north = 0.05, south = M_PI - 0.05;
    int polar = 4;
    double first = 0;
    int around = 3;
    std::string head() const {
        return fmt::format("nullscope-medium 1\ncoordinates {}\nspin {}\nr {} {} {}\ntheta {} {} {}\nphi {} {}\ndata\n",
                           coordinates, spin, nearest, farthest, rings, north, south, polar, first, around);
    }
};

// node(r, theta, phi)
inline std::string grid_bytes(const GridForm& form, const std::function<GridNode(double, double, double)>& node) {
    std::string bytes = form.head();
    for (int i = 0; i < form.rings; ++i)
        for (int j = 0; j < form.polar; ++j)
            for (int k = 0; k < form.around; ++k)
                for (const double number :
                     node(form.nearest * std::pow(form.farthest / form.nearest, i / (form.rings - 1.0)),
                          form.north + (form.south - form.north) * j / (form.polar - 1.0),
                          form.first + 2 * M_PI * k / form.around)) {
                    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(number));
                    for (int byte = 0; byte < 4; ++byte) bytes.push_back(static_cast<char>(bits >> (8 * byte) & 0xff));
                }
    return bytes;
}

}  // namespace nullscope::test
