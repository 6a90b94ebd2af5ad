#include "telescope/stations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "telescope/csv_table.h"

namespace nullscope {
namespace {

constexpr double kMostPlace_m = 6.39e6, kLeastPlace_m = 6.35e6;  // from Earth's centre: a coast at a pole, a peak
constexpr std::string_view kPlaceColumns[] = {"x_m", "y_m", "z_m"};
constexpr std::string_view kOrbitColumns[] = {"radius_km", "inclination_deg", "node_deg", "phase_deg"};

std::vector<TableColumn> station_columns() {
    std::vector<TableColumn> columns = {{"station", 0, 0}, {"sefd_jy", 1e-3, 1e9}};
    for (const std::string_view name : kPlaceColumns) columns.push_back({name, -kMostPlace_m, kMostPlace_m, false});
    columns.push_back({"radius_km", 6478, 1e6, false});  // 100 km up and more
    columns.push_back({"inclination_deg", 0, 180, false});
    columns.push_back({"node_deg", -360, 360, false});
    columns.push_back({"phase_deg", -360, 360, false});
    return columns;
}

bool is_station_name(std::string_view name) {
    constexpr std::size_t kLongest = 16;
    return !name.empty() && name.size() <= kLongest && std::ranges::all_of(name, [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '+' ||
               c == '-';
    });
}

// Which of the two groups of columns a line fills: all of one and none of the other.
Result<bool> is_in_orbit(const CsvTable& table, const TableLine& line) {
    const auto is_given = [&](std::string_view column) { return table.given(line, column); };
    const auto places = std::ranges::count_if(kPlaceColumns, is_given),
               orbits = std::ranges::count_if(kOrbitColumns, is_given);
    constexpr std::string_view kAllowed =
        "all of x_m, y_m, z_m, or all of radius_km, inclination_deg, node_deg, phase_deg";
    if (places > 0 && orbits > 0) return table.fault(line.number, "x_m", "a place on Earth and an orbit", kAllowed);
    if (places != std::ssize(kPlaceColumns) && orbits != std::ssize(kOrbitColumns)) {
        const bool of_orbit = orbits > 0;
        const std::string_view missing = of_orbit ? *std::ranges::find_if_not(kOrbitColumns, is_given)
                                                  : *std::ranges::find_if_not(kPlaceColumns, is_given);
        return table.fault(line.number, missing, "this is missing", kAllowed);
    }
    return orbits > 0;
}

Result<StationOrbit> orbit_of(const CsvTable& table, const TableLine& line) {
    std::array<double, 4> of{};
    for (std::size_t i = 0; i < of.size(); ++i) {
        TRY(value, table.number(line, kOrbitColumns[i]));
        of[i] = *value;
    }
    constexpr double kDegree = M_PI / 180;
    return StationOrbit{1e3 * of[0], kDegree * of[1], kDegree * of[2], kDegree * of[3]};
}

Result<std::array<double, 3>> place_of(const CsvTable& table, const TableLine& line) {
    std::array<double, 3> place{};
    for (std::size_t i = 0; i < place.size(); ++i) {
        TRY(value, table.number(line, kPlaceColumns[i]));
        place[i] = *value;
    }
    const double far = std::hypot(place[0], place[1], place[2]);
    if (!(far >= kLeastPlace_m && far <= kMostPlace_m))
        return table.fault(line.number, "x_m", fmt::format("{:g} m from Earth's centre", far),
                           fmt::format("[{:g}, {:g}]", kLeastPlace_m, kMostPlace_m));
    return place;
}

}  // namespace

Result<std::vector<Station>> read_stations(std::string_view text, const std::string& file) {
    TRY(table, CsvTable::read(text, file, station_columns(), kMostStations));
    std::vector<Station> stations;
    for (const TableLine& line : table->lines()) {
        Station station;
        station.name = table->text(line, "station");
        if (!is_station_name(station.name))
            return table->fault(line.number, "station", fmt::format("{} is no name", in_quotes(station.name)),
                                "1 to 16 letters, digits, _, + or -");
        if (std::ranges::find(stations, station.name, &Station::name) != stations.end())
            return table->fault(line.number, "station", fmt::format("{} is there twice", station.name), "once");
        TRY(sefd, table->number(line, "sefd_jy"));
        station.sefd_jy = *sefd;
        TRY(in_orbit, is_in_orbit(*table, line));
        if (*in_orbit) {
            TRY(orbit, orbit_of(*table, line));
            station.orbit = *orbit;
        } else {
            TRY(place, place_of(*table, line));
            station.place = *place;
        }
        stations.push_back(std::move(station));
    }
    if (stations.size() < 2)
        return table->fault(table->lines().back().number, "station", "one station has no baseline", "two or more");
    return stations;
}

}  // namespace nullscope
