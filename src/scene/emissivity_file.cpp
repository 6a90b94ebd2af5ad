// Tables of emissivities in files.
#include <fmt/format.h>

#include "base/csv.h"
#include "base/file_cache.h"
#include "base/text.h"
#include "scene/disc_emissivity.h"

namespace nullscope {
namespace {

constexpr std::size_t kMostTables = 16, kLargestTable = 16u << 20;
constexpr double kLeastRadius = 1e-6, kMostRadius = 1e6, kLeastValue = 1e-200, kMostValue = 1e200;

Error of_line(int line, std::string what, std::string allowed) {
    Error error = bad_input(std::move(what), std::move(allowed));
    error.line = line;
    return error;
}

Result<EmissivityRow> row_of(const std::vector<std::string>& fields, int line) {
    const auto r = parse_number(fields[0]), value = parse_number(fields[1]);
    if (!r || !(*r >= kLeastRadius && *r <= kMostRadius))
        return of_line(line, fmt::format("\"{}\" is no radius", without_controls(fields[0])),
                       fmt::format("r_s from {:g} to {:g}", kLeastRadius, kMostRadius));
    if (!value || !(*value >= kLeastValue && *value <= kMostValue))
        return of_line(line, fmt::format("\"{}\" is no emissivity", without_controls(fields[1])),
                       fmt::format("from {:g} to {:g}", kLeastValue, kMostValue));
    return EmissivityRow{*r, *value};
}

}  // namespace

Result<std::vector<EmissivityRow>> read_emissivity(std::string_view text) {
    std::vector<EmissivityRow> rows;
    bool first = true;
    for (CsvLines lines(text); lines.next();) {
        const auto fields = csv_fields(lines.line);
        if (!fields || fields->size() != 2)
            return of_line(lines.number, "is not a radius and an emissivity", "two numbers, separated by a comma");
        const bool header = first && !parse_number((*fields)[0]) && !parse_number((*fields)[1]);
        first = false;
        if (header) continue;
        TRY(row, row_of(*fields, lines.number));
        if (!rows.empty() && !(row->r > rows.back().r))
            return of_line(lines.number,
                           fmt::format("the radius {:g} is not above the one before, {:g}", row->r, rows.back().r),
                           "radii that grow");
        if (rows.size() == kMostEmissivityRows)
            return of_line(lines.number, "there are too many rows", fmt::format("at most {}", kMostEmissivityRows));
        rows.push_back(*row);
    }
    if (rows.size() < 2)
        return bad_input(fmt::format("{} of at least two rows", rows.size()), "lines \"r, emissivity\"");
    return rows;
}

Result<std::shared_ptr<const std::vector<EmissivityRow>>> load_emissivity(const std::filesystem::path& file) {
    static FileCache<std::vector<EmissivityRow>> tables(kMostTables, kLargestTable);
    return tables.get(file, [](std::string_view text, const std::string&) { return read_emissivity(text); });
}

}  // namespace nullscope
