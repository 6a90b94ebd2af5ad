#include "cli/line_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "cli/line_source.h"
#include "fit/sigma_words.h"
#include "telescope/csv_table.h"

namespace nullscope::cli {
namespace {

constexpr int kLevel = 1;            // of LineCells: half of it changes no bin by more than a hundredth of the largest
constexpr double kSameWidth = 1e-6;  // of a bin
constexpr double kLargestShift = 1e3, kLargestShare = 1e30;

struct LineTable {
    LineBins bins;
    fit::Observed observed;
};

std::vector<TableColumn> line_columns() {
    std::vector<TableColumn> columns = {
        {"g_from", 0, kLargestShift}, {"g_to", 0, kLargestShift}, {"photons", -kLargestShare, kLargestShare}};
    columns.push_back({"noise", 1e-30, kLargestShare, false});
    for (const std::string_view name : {"g", "energy_kev", "energy", "stokes_q", "stokes_u", "fraction", "angle_deg"})
        columns.push_back({name, 0, 0, false});
    return columns;
}

// The bins that g_from and g_to say.
Result<LineBins> bins_in(const CsvTable& table) {
    std::vector<double> from, to;
    for (const TableLine& line : table.lines()) {
        TRY(low, table.number(line, "g_from"));
        TRY(high, table.number(line, "g_to"));
        from.push_back(*low), to.push_back(*high);
        const double width = to.front() - from.front();
        const double expected = from.front() + width * static_cast<double>(from.size() - 1);
        if (!(width > 0) || std::fabs(*low - expected) > kSameWidth * expected ||
            std::fabs(*high - *low - width) > kSameWidth * expected)
            return table.fault(line.number, "g_from", "not the bin behind the one before, as wide as that",
                               "bins of one width, ascending, none left out");
    }
    return LineBins{static_cast<int>(from.size()), from.front(), to.back()};
}

Result<LineTable> read_line(const std::string& file, const std::string& sigma) {
    TRY(text, read_text(file, kLargestTable));
    TRY(table, CsvTable::read(*text, file, line_columns(), fit::kMostData));
    TRY(bins, bins_in(*table));
    LineTable line{*bins, {}};
    if (table->has("noise") != sigma.empty())
        return table->fault(1, "noise", table->has("noise") ? "this column and --sigma" : "this column is missing",
                            "the column, or --sigma NUMBER or NUMBER% of the largest share");
    double largest = 0;
    for (const TableLine& row : table->lines()) {
        TRY(photons, table->number(row, "photons"));
        line.observed.value.push_back(*photons), largest = std::max(largest, *photons);
        if (!sigma.empty()) continue;
        TRY(noise, table->number(row, "noise"));
        line.observed.sigma.push_back(*noise);
    }
    if (!sigma.empty()) {
        TRY(same, fit::shared_sigma(sigma, largest));
        line.observed.sigma.assign(line.observed.value.size(), *same);
    }
    line.observed.what = fmt::format("{} bins of {}", line.observed.value.size(),
                                     without_controls(std::filesystem::path(file).filename().string()));
    return line;
}

class LineModel final : public fit::Model {
public:
    LineModel(const fit::SceneFamily& family, LineBins bins) : family_(family), bins_(bins) {}
    Result<fit::Prediction> predict(const std::vector<double>& values) override {
        TRY(scene, family_.at(values));
        SpectrumOptions options;
        options.scene = "of the fit";
        TRY(source, line_source(options, std::move(*scene)));
        TRY(light, DistantLight::make(source->spacetime, source->inclination));
        DiscLine line = disc_line(*source, options);
        line.polarisation = nullptr;
        const LineProfile profile = line_profile(*light, line, bins_, LineCells(kLevel));
        fit::Prediction prediction;
        for (std::size_t bin = 0; bin < profile.photons.size(); ++bin) prediction.push_back(profile.share(bin));
        return prediction;
    }

private:
    fit::SceneFamily family_;
    LineBins bins_;
};

}  // namespace

bool is_line_table(const std::string& file) {
    const auto text = read_text(file, kLargestTable);
    if (!text) return false;
    CsvLines lines(*text);
    if (!lines.next()) return false;
    const auto header = csv_fields(lines.line);
    return header && std::ranges::find(*header, "g_from") != header->end();
}

Result<fit::Subject> line_subject(const fit::SceneFamily& family, const std::string& file, const std::string& sigma) {
    TRY(line, read_line(file, sigma));
    return fit::Subject{std::move(line->observed), std::make_unique<LineModel>(family, line->bins)};
}

}  // namespace nullscope::cli
