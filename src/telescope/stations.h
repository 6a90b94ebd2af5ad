// The stations of an array: what a table of them (CSV) says.
//
// Columns: station (a name), sefd_jy, and x_m, y_m, z_m of a telescope on Earth (geocentric, fixed to Earth: x to the meridian of Greenwich, z
// to the north pole), or radius_km, inclination_deg, node_deg, phase_deg of one on a circular orbit about Earth's centre: the angle between the
// orbit's axis and the north pole, the right ascension at which it goes north, and where it is from there at hour 0 of the scans.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

struct StationOrbit {
    double radius_m, inclination, node, phase;  // rad
};
struct Station {
    std::string name;               // letters, digits, _ + -; 1 to 16 of them
    double sefd_jy = 0;             // system equivalent flux density, in one polarisation
    std::array<double, 3> place{};  // m, where there is no orbit
    std::optional<StationOrbit> orbit{};
};

inline constexpr std::size_t kMostStations = 64;

// Two stations or more. Errors (bad input): file, line and column of the first fault.
Result<std::vector<Station>> read_stations(std::string_view text, const std::string& file);

}  // namespace nullscope
