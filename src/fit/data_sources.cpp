#include "fit/data_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "fit/curve_subject.h"
#include "fit/line_subject.h"
#include "fit/sigma_words.h"
#include "fit/visibility_subject.h"

namespace nullscope::fit {
namespace {

Result<TableSource> read_table(const DataSources& sources) {
    if (!sources.mask.empty()) return bad_input("--mask: a table has no pixels", "with a picture");
    TableSource table{sources.data, sources.table.value_or(""), sources.sigma, sources.free_flux};
    if (sources.table) return table;
    TRY(text, read_text(sources.data, kLargestTable));
    table.text = std::move(*text);
    return table;
}

Result<Subject> table_subject(const SceneFamily& family, const SessionSource& sessions, const DataSources& sources) {
    TRY(table, read_table(sources));
    if (table->has("g_from")) return line_subject(family, *table);
    TRY(painter, ScenePainter::open(family, sessions));
    if (table->has("time") || table->has("time_s")) return curve_subject(*painter, *table, sources.samples);
    return visibility_subject(*painter, *table, sources.samples);
}

}  // namespace

bool TableSource::has(std::string_view column) const {
    CsvLines lines(text);
    if (!lines.next()) return false;
    const auto header = csv_fields(lines.line);
    return header && std::ranges::find(*header, column) != header->end();
}

Status set_table_sigma(const CsvTable& table, const std::string& column, const TableSource& source,
                       const std::string& of_what, std::size_t numbers_a_line, Observed& observed) {
    const bool has_noise = table.has(column);
    if (has_noise != source.sigma.empty())
        return table.fault(1, column, has_noise ? "this column and --sigma" : "this column is missing",
                           "the column, or --sigma NUMBER or NUMBER% of the largest " + of_what);
    if (!has_noise) {
        double largest = 0;
        for (const double value : observed.value) largest = std::max(largest, std::fabs(value));
        TRY(same, shared_sigma(source.sigma, largest));
        observed.sigma.assign(observed.value.size(), *same);
        return Done{};
    }
    for (const TableLine& line : table.lines()) {
        TRY(noise, table.number(line, column));
        observed.sigma.insert(observed.sigma.end(), numbers_a_line, *noise);
    }
    return Done{};
}

std::string table_words(const std::string& count, const TableSource& source) {
    return fmt::format("{} of {}", count, without_controls(std::filesystem::path(source.name).filename().string()));
}

Result<Subject> open_subject(const SceneFamily& family, const SessionSource& sessions, const DataSources& sources) {
    if (sources.table || lower_case(sources.data).ends_with(".csv")) return table_subject(family, sessions, sources);
    TRY(painter, ScenePainter::open(family, sessions));
    if (sources.picture) return picture_subject(*painter, *sources.picture, sources.data, sources.samples);
    return picture_subject(*painter, {sources.data, sources.sigma, sources.mask}, sources.samples);
}

}  // namespace nullscope::fit
