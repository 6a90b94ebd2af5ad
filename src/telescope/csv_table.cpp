#include "telescope/csv_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/csv.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr std::string_view kUnclosed = "a quote is not closed, or something follows it";

std::string column_names(const std::vector<TableColumn>& columns) {
    std::string names;
    for (const TableColumn& column : columns)
        names +=
            (names.empty() ? "" : ", ") + (column.needed ? std::string(column.name) : fmt::format("[{}]", column.name));
    return names;
}

}  // namespace

Error CsvTable::fault(int line, std::string_view column, std::string_view what, std::string_view allowed) const {
    return {ErrorKind::kBadInput,
            without_controls(std::string(what)),
            std::string(allowed),
            without_controls(std::string(column)),
            file_,
            line};
}

bool CsvTable::has(std::string_view column) const { return std::ranges::find(header_, column) != header_.end(); }

const TableColumn& CsvTable::known(std::string_view column) const {
    return *std::ranges::find(columns_, column, &TableColumn::name);
}

const std::string& CsvTable::text(const TableLine& line, std::string_view column) const {
    return line.fields[static_cast<std::size_t>(std::ranges::find(header_, column) - header_.begin())];
}

bool CsvTable::given(const TableLine& line, std::string_view column) const {
    return has(column) && !text(line, column).empty();
}

Result<double> CsvTable::number(const TableLine& line, std::string_view column) const {
    const TableColumn& row = known(column);
    const std::string& field = text(line, column);
    const auto value = parse_number(field);
    const std::string allowed = fmt::format("[{}, {}]", row.least, row.most);
    if (!value) return fault(line.number, column, fmt::format("{} is no number", in_quotes(field)), allowed);
    if (!(*value >= row.least && *value <= row.most))
        return fault(line.number, column, fmt::format("{} is out of range", *value), allowed);
    return *value;
}

Status CsvTable::read_header(int line, std::string_view text) {
    const auto fields = csv_fields(text);
    if (!fields) return fault(line, "header", kUnclosed, column_names(columns_));
    header_ = *fields;
    for (const std::string& name : header_) {
        if (std::ranges::find(columns_, name, &TableColumn::name) == columns_.end())
            return fault(line, "header", fmt::format("unknown column {}", in_quotes(name)), column_names(columns_));
        if (std::ranges::count(header_, name) > 1) return fault(line, name, "this column is there twice", "once");
    }
    for (const TableColumn& column : columns_)
        if (column.needed && !has(column.name)) return fault(line, column.name, "this column is missing", "once");
    return Done{};
}

Result<CsvTable> CsvTable::read(std::string_view text, const std::string& file, std::vector<TableColumn> columns,
                                std::size_t most) {
    CsvTable table;
    table.file_ = file, table.columns_ = std::move(columns);
    for (CsvLines csv(text); csv.next();) {
        if (table.header_.empty()) {
            TRY(header, table.read_header(csv.number, csv.line));
            continue;
        }
        auto fields = csv_fields(csv.line);
        if (!fields) return table.fault(csv.number, "row", kUnclosed, "\"...\" around whole fields");
        if (fields->size() != table.header_.size())
            return table.fault(csv.number, "row", fmt::format("{} fields", fields->size()),
                               fmt::format("{}, as in the header", table.header_.size()));
        if (table.lines_.size() == most)
            return table.fault(csv.number, "row", "one too many", fmt::format("{} at most", most));
        table.lines_.push_back({csv.number, std::move(*fields)});
    }
    if (table.header_.empty()) return table.fault(1, "header", "there is none", column_names(table.columns_));
    if (table.lines_.empty()) return table.fault(1, "row", "there is none below the header", "one or more");
    return table;
}

}  // namespace nullscope
