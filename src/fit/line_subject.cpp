#include "fit/line_subject.h"

#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "command/line_source.h"
#include "telescope/csv_table.h"

namespace nullscope::fit {
namespace {

constexpr int kLevel = 1;            // of LineCells: half of it changes no bin by more than a hundredth of the largest
constexpr double kSameWidth = 1e-6;  // of a bin
constexpr double kLargestShift = 1e3, kLargestShare = 1e30;

struct LineTable {
    LineBins bins;
    Observed observed;
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

Result<LineTable> read_line(const TableSource& source) {
    TRY(table, CsvTable::read(source.text, source.name, line_columns(), kMostData));
    TRY(bins, bins_in(*table));
    LineTable line{*bins, {}};
    for (const TableLine& row : table->lines()) {
        TRY(photons, table->number(row, "photons"));
        line.observed.value.push_back(*photons);
    }
    TRY(with_sigma, set_table_sigma(*table, "noise", source, "share", 1, line.observed));
    line.observed.what = table_words(counted(std::ssize(line.observed.value), "bin"), source);
    return line;
}

class LineModel final : public Model {
public:
    LineModel(const SceneFamily& family, LineBins bins) : family_(family), bins_(bins) {}
    Result<Prediction> predict(const std::vector<double>& values) override {
        TRY(scene, family_.at(values));
        cli::LineOptions options;
        options.scene = "of the fit";
        TRY(source, cli::line_source(options, std::move(*scene)));
        TRY(light, DistantLight::make(source->spacetime, source->inclination));
        DiscLine line = cli::disc_line(*source, options);
        line.polarisation = nullptr;
        const LineProfile profile = line_profile(*light, line, bins_, LineCells(kLevel));
        Prediction prediction;
        for (std::size_t bin = 0; bin < profile.photons.size(); ++bin) prediction.push_back(profile.share(bin));
        return prediction;
    }

private:
    SceneFamily family_;
    LineBins bins_;
};

}  // namespace

Result<Subject> line_subject(const SceneFamily& family, const TableSource& source) {
    TRY(line, read_line(source));
    return Subject{std::move(line->observed), std::make_unique<LineModel>(family, line->bins)};
}

}  // namespace nullscope::fit
