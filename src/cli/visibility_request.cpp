#include "cli/visibility_request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/text.h"
#include "telescope/baseline_list.h"
#include "telescope/csv_table.h"

namespace nullscope::cli {
namespace {

constexpr double kOneDegreeOfSky = M_PI / 180, kMostHours = 1e5;

struct NumberRange {
    double least, most;
};

// The numbers of an option that has several. what: "ANGLE MAX".
template <std::size_t n>
Result<std::array<double, n>> numbers_of(const char* option, const char* what, const std::vector<std::string>& words,
                                         const std::array<NumberRange, n>& ranges) {
    std::array<double, n> numbers{};
    for (std::size_t i = 0; i < n; ++i) {
        const auto number = i < words.size() ? parse_number(words[i]) : std::nullopt;
        if (!number || !(*number >= ranges[i].least && *number <= ranges[i].most))
            return bad_input(fmt::format("{} {}: not {}", option, fmt::join(words, " "), what),
                             fmt::format("number {} in [{:g}, {:g}]", i + 1, ranges[i].least, ranges[i].most));
        numbers[i] = *number;
    }
    return numbers;
}

Result<VisibilityRows> rows_of_list(const VisibilityOptions& options, const LightSource& light) {
    TRY(text, read_text(options.baselines, kLargestTable));
    TRY(list, read_baselines(*text, options.baselines, light.frequency_GHz));
    VisibilityRows rows;
    rows.baselines = std::move(list->baselines);
    rows.time_h = std::move(list->time_h), rows.frequency_ghz = std::move(list->frequency_ghz);
    return rows;
}

// From 0 to the longest in equal steps, along a position angle, from north through east.
Result<VisibilityRows> rows_on_line(const VisibilityOptions& options) {
    constexpr double kLongest_glambda = 1e6;
    TRY(line, numbers_of<2>("--radial", "ANGLE MAX, degrees and Gλ", options.radial,
                            {{{-360, 360}, {1e-6, kLongest_glambda}}}));
    const auto [angle, longest] = *line;
    VisibilityRows rows;
    rows.is_line = true;
    for (int i = 0; i < options.points; ++i) {
        const double length = 1e9 * longest * i / (options.points - 1);
        rows.baselines.push_back(
            {length * std::sin(kOneDegreeOfSky * angle), length * std::cos(kOneDegreeOfSky * angle)});
    }
    return rows;
}

std::filesystem::path array_file(const std::string& name) {
    const bool is_name = name.find_first_of("./\\") == std::string::npos;
    const auto shipped = assets_directory() / "telescopes" / (name + ".csv");
    return is_name && std::filesystem::exists(shipped) ? shipped : std::filesystem::path(name);
}

std::string shipped_arrays() {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(assets_directory() / "telescopes", ignored))
        if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return fmt::format("{}, or a file with the columns of docs/telescope.md", fmt::join(names, ", "));
}

Result<std::vector<Station>> stations_of(const std::string& name) {
    const std::filesystem::path file = array_file(name);
    if (!std::filesystem::exists(file))
        return bad_input(fmt::format("--array {}: there is no such array", name), shipped_arrays());
    TRY(text, read_text(file, kLargestTable));
    return read_stations(*text, file.string());
}

// Both ends included, where the last step ends there.
Result<std::vector<double>> hours_of(const VisibilityOptions& options) {
    std::array<double, 3> asked = {0, 24, 1.0 / 6};
    if (!options.hours.empty()) {
        TRY(given, numbers_of<3>("--hours", "FROM TO STEP, hours", options.hours,
                                 {{{-kMostHours, kMostHours}, {-kMostHours, kMostHours}, {1e-4, kMostHours}}}));
        asked = *given;
    }
    const auto [from, to, step] = asked;
    constexpr double kMostScans = 1e6, kRounding = 1e-9;
    if (!(to >= from)) return bad_input(fmt::format("--hours: {} is before {}", to, from));
    const double steps = std::floor((to - from) / step + kRounding);
    if (!(steps < kMostScans)) return bad_input("--hours: too many scans", fmt::format("{:g}", kMostScans));
    std::vector<double> hours;
    for (int i = 0; i <= static_cast<int>(steps); ++i) hours.push_back(from + i * step);
    return hours;
}

Result<SkyPlace> source_of(const VisibilityOptions& options, const LightSource& light) {
    if (!options.source.empty()) {
        TRY(given, numbers_of<2>("--source", "RA DEC, hours and degrees", options.source, {{{0, 24}, {-90, 90}}}));
        return SkyPlace{15 * (*given)[0], (*given)[1]};
    }
    if (light.place) return *light.place;
    return bad_input("--array: the object's place in the sky is not known", "with --source RA DEC, hours and degrees");
}

Result<VisibilityRows> rows_of_array(const VisibilityOptions& options, const LightSource& light) {
    TRY(stations, stations_of(options.array));
    TRY(source, source_of(options, light));
    TRY(hours, hours_of(options));
    TRY(frequency, frequency_of(options, light));
    const ObservationPlan plan{kOneDegreeOfSky * source->right_ascension_deg,
                               kOneDegreeOfSky * source->declination_deg,
                               1e9 * *frequency,
                               std::move(*hours),
                               options.mjd,
                               kOneDegreeOfSky * options.elevation_deg};
    TRY(seen, observe(*stations, plan));
    if (seen->baselines.empty())
        return bad_input("--array: no two stations see the source at one time",
                         "other --hours, a lower --elevation, another --source");
    constexpr double kMostQuadrangles = 5e6;
    double quadrangles = 0;
    for (const Scan& scan : seen->scans) {
        const auto n = static_cast<double>(scan.up.size());
        quadrangles += n * (n - 1) * (n - 2) * (n - 3) / 24;
    }
    if (quadrangles > kMostQuadrangles)
        return bad_input(fmt::format("--array: {:.3g} quadrangles of stations", quadrangles),
                         fmt::format("{:g}: fewer stations or scans", kMostQuadrangles));
    VisibilityRows rows;
    rows.baselines = seen->baselines;
    for (const Scan& scan : seen->scans)
        rows.time_h.insert(rows.time_h.end(), scan.up.size() * (scan.up.size() - 1) / 2, scan.hour);
    if (options.noise)
        for (const StationPair& pair : seen->pairs)
            rows.noise.push_back(thermal_noise((*stations)[pair.first], (*stations)[pair.second],
                                               1e9 * options.bandwidth_GHz, options.integration_s));
    rows.stations = std::move(*stations), rows.seen = std::move(*seen);
    return rows;
}

}  // namespace

Result<double> frequency_of(const VisibilityOptions& options, const LightSource& light) {
    constexpr double kUsual_GHz = 230, kSame = 1e-6;
    if (light.frequency_GHz && options.frequency_GHz &&
        !(std::fabs(*options.frequency_GHz / *light.frequency_GHz - 1) <= kSame))
        return bad_input(fmt::format("--frequency {}: the light is of another", *options.frequency_GHz),
                         fmt::format("{}, or without this option", *light.frequency_GHz));
    return light.frequency_GHz.value_or(options.frequency_GHz.value_or(kUsual_GHz));
}

Result<VisibilityRows> requested_rows(const VisibilityOptions& options, const LightSource& light) {
    const int ways = int{!options.baselines.empty()} + int{!options.radial.empty()} + int{!options.array.empty()};
    if (ways != 1)
        return bad_input(ways == 0 ? "no baselines were asked for" : "several kinds of baselines were asked for",
                         "one of --baselines FILE, --radial ANGLE MAX, --array NAME");
    if (!options.baselines.empty()) return rows_of_list(options, light);
    return options.array.empty() ? rows_on_line(options) : rows_of_array(options, light);
}

}  // namespace nullscope::cli
