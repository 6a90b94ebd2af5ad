#include "cli/ray_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "command/ray_fields.h"
#include "scene/bodies.h"

namespace nullscope::cli {
namespace {

Error fault(const std::string& file, int line, std::string_view column, std::string_view what,
            std::string_view allowed) {
    return Error{ErrorKind::kBadInput, std::string(what), std::string(allowed), std::string(column), file, line};
}

Error in_file(Error error, const std::string& file, int line) {
    error.file = file, error.line = line;
    return error;
}

struct Header {
    int line = 0;
    std::size_t fields = 0;
    std::array<std::optional<std::size_t>, kRayColumns> at;  // field number of each known column
    RayForm form = RayForm::kGeneral;
};

Result<Header> read_header(const std::string& file, int line, std::string_view text, const Spacetime& spacetime) {
    const auto fields = csv_fields(text);
    if (!fields) return fault(file, line, "header", "a quote is not closed, or something follows it", kRayForms);
    Header header;
    header.line = line;
    header.fields = fields->size();
    std::array<bool, kRayColumns> there{};
    for (std::size_t i = 0; i < fields->size(); ++i) {
        const auto column = ray_column((*fields)[i], spacetime);
        if (!column) continue;
        if (there[*column]) return fault(file, line, kRayColumnNames[*column], "this column is there twice", "once");
        header.at[*column] = i;
        there[*column] = true;
    }
    const auto form = ray_form(there);
    if (!form) return in_file(form.error(), file, line);
    header.form = *form;
    return header;
}

// Of one row.
class CsvFields final : public RayFields {
public:
    CsvFields(const Header& header, const std::vector<std::string>& fields) : header_(header), fields_(fields) {}
    bool given(RayColumn column) const override { return header_.at[column] && !field(column).empty(); }
    std::optional<double> number(RayColumn column) const override { return parse_number(field(column)); }
    std::string text(RayColumn column) const override { return field(column); }

private:
    const std::string& field(RayColumn column) const { return fields_[*header_.at[column]]; }
    const Header& header_;
    const std::vector<std::string>& fields_;
};

Result<RayQuery> read_row(const std::string& file, int line, std::string_view text, const Header& header,
                          const Spacetime& spacetime) {
    const auto fields = csv_fields(text);
    if (!fields)
        return fault(file, line, "row", "a quote is not closed, or something follows it",
                     "\"...\" around whole fields");
    if (fields->size() != header.fields)
        return fault(file, line, "row", fmt::format("{} fields", fields->size()),
                     fmt::format("{}, as many as the header of line {} names", header.fields, header.line));
    auto query = ray_query(CsvFields(header, *fields), header.form, spacetime);
    if (!query) return in_file(query.error(), file, line);
    return query;
}

std::string fate_name(const RayRecord& record, const Scene& scene) {
    constexpr std::array<std::string_view, 4> kFates = {"escaped", "captured", "other_side", "no_sky"};
    if (record.fate != Fate::kHit) return std::string(kFates[static_cast<std::size_t>(record.fate)]);
    return record.hit == 0 ? "no_sky" : "hit:" + object_name(scene, record.hit);
}

void append(std::string& line, double value) {
    line += ',';
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(line), "{:.17g}", value);
}

}  // namespace

Error ray_error(const RayTable& table, std::size_t row, const Error& error) {
    return bad_input(fmt::format("{}:{}: {}", table.file, table.rows[row].line, error.message()));
}

Result<RayTable> parse_rays(std::string_view text, const std::string& file, const Spacetime& spacetime) {
    RayTable table{file, {}, {}, {}};
    std::optional<Header> header;
    for (CsvLines csv(text); csv.next();) {
        if (!header) {
            TRY(read, read_header(file, csv.number, csv.line, spacetime));
            header = *read;
            table.header = csv.line;
            continue;
        }
        TRY(query, read_row(file, csv.number, csv.line, *header, spacetime));
        table.rows.push_back({csv.number, std::string(csv.line)});
        table.queries.push_back(*query);
    }
    if (!header) return fault(file, 1, "header", "there is none", kRayForms);
    return table;
}

Result<RayTable> read_rays(const std::string& path, const Spacetime& spacetime) {
    TRY(text, read_text(path, kLargestRayFile));
    return parse_rays(*text, path, spacetime);
}

std::string rays_text(const RayTable& table, const Scene& scene, const RayRecords& records, int crossings,
                      std::span<const CrossingColumn> columns, double length_unit, const MoreColumns& more) {
    std::string text = table.header + ",fate,theta_inf,phi_inf,angle,delay,g,turn,at";
    for (int k = 1; k <= crossings; ++k)
        for (const CrossingColumn& column : columns) text += fmt::format(",{}_{}", column.name, k);
    text += more.header + '\n';
    const std::size_t fields = 8 + columns.size() * static_cast<std::size_t>(crossings);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        text += table.rows[i].text;
        if (!records[i]) {
            text += std::string(fields, ',') + '\n';
            continue;
        }
        const RayRecord& ray = *records[i];
        text += ',' + fate_name(ray, scene);
        for (const double value : {ray.theta_inf, ray.phi_inf, ray.angle, ray.delay / length_unit, ray.g,
                                   ray.turn / length_unit, ray.at / length_unit})
            append(text, value);
        for (std::size_t k = 0; k < static_cast<std::size_t>(crossings); ++k)
            for (const CrossingColumn& column : columns) {
                const double value = k < ray.crossings.size() ? ray.crossings[k].*column.value : kNotANumber;
                append(text, column.is_length ? value / length_unit : value);
            }
        if (!more.rows.empty()) text += more.rows[i];
        text += '\n';
    }
    return text;
}

}  // namespace nullscope::cli
