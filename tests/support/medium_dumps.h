// Dumps of a hot spot that moves, at some nodes, as files; and what is between two of them (scene/medium_dumps.h).
#pragma once
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/atomic_file.h"
#include "scene/scene.h"
#include "support/medium_files.h"

namespace nullscope::test {

inline constexpr int kSpotDumps = 12, kFirstSpotDump = 3;
inline constexpr double kSpotCadence = 2.5, kSpotStart = 10;

inline GridForm spot_form() {
    GridForm form;
    form.rings = 14, form.polar = 9, form.around = 16, form.nearest = 1.1, form.farthest = 8.5;
    return form;
}

// Of a dump, from 0 on: the spot is a fourteenth of a turn ahead of the one before.
inline GridNode spot_node(int dump, double r, double theta, double phi) {
    const double angle = 0.45 * dump, x = r * std::sin(theta) * std::cos(phi), y = r * std::sin(theta) * std::sin(phi),
                 z = r * std::cos(theta), dx = x - 4 * std::cos(angle), dy = y - 4 * std::sin(angle);
    return {std::exp(-0.4 * (dx * dx + dy * dy + z * z)),
            6000 + 200 * dump + 500 * z / r,
            1.0 + dump,
            2 * std::cos(phi),
            0.3 * dump,
            -0.1 * std::cos(angle),
            0.05 * std::sin(angle),
            0.4};
}

// Geometric means of density and temperature; of the rest arithmetic ones. part: the weight of the second.
inline GridNode mean_node(const GridNode& a, const GridNode& b, double part) {
    GridNode mean{};
    for (std::size_t n = 0; n < mean.size(); ++n)
        mean[n] = n < 2 ? std::pow(a[n], 1 - part) * std::pow(b[n], part) : (1 - part) * a[n] + part * b[n];
    return mean;
}

inline std::filesystem::path spot_file(const std::filesystem::path& folder, int dump) {
    return folder / fmt::format("flow-{:05d}.grid", kFirstSpotDump + dump);
}

inline void write_spot_dumps(const std::filesystem::path& folder) {
    for (int dump = 0; dump < kSpotDumps; ++dump)
        REQUIRE(write_text_atomically(spot_file(folder, dump),
                                      grid_bytes(spot_form(), [dump](double r, double theta, double phi) {
                                          return spot_node(dump, r, theta, phi);
                                      })));
}

inline GridMatter spot_dumps(const std::filesystem::path& folder) {
    return {folder / "flow-%05d.grid", kFirstSpotDump, kFirstSpotDump + kSpotDumps - 1, kSpotCadence, kSpotStart};
}

}  // namespace nullscope::test
