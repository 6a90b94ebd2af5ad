#include "fit/curve_subject.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "base/csv.h"
#include "base/text.h"
#include "command/curve_light.h"
#include "fit/painted_model.h"
#include "plan/moving.h"
#include "scene/known_object.h"
#include "scene/medium_bands.h"

namespace nullscope::fit {
namespace {

constexpr double kLatest = 1e9, kLatest_s = 1e15, kLargestFlux = 1e30;
constexpr int kSearchSamples = 2;         // rays along each side of a pixel
constexpr std::size_t kSearchTimes = 32;  // at most: of the search
constexpr std::string_view kBand = "jansky_";

struct CurveData {
    std::vector<double> times;
    bool in_seconds = false;
    std::vector<std::string> columns;  // of each line: "flux", "jansky", "jansky_86GHz"
    Observed observed;                 // line by line
    CurveData every(std::size_t step) const;
};

// Every step-th line.
CurveData CurveData::every(std::size_t step) const {
    CurveData part{{}, in_seconds, columns, {}};
    for (std::size_t line = 0; line < times.size(); line += step) {
        part.times.push_back(times[line]);
        for (std::size_t i = line * columns.size(); i < (line + 1) * columns.size(); ++i)
            part.observed.value.push_back(observed.value[i]), part.observed.sigma.push_back(observed.sigma[i]);
    }
    return part;
}

// Those of `nullscope lightcurve`; fluxes at several frequencies have columns of their own, whose names live in `bands`.
std::vector<TableColumn> curve_columns(const TableSource& source, std::deque<std::string>& bands) {
    std::vector<TableColumn> columns = {{"time", -kLatest, kLatest, false}, {"time_s", -kLatest_s, kLatest_s, false}};
    for (const std::string_view name : {"flux", "jansky"})
        columns.push_back({name, -kLargestFlux, kLargestFlux, false});
    columns.push_back({"noise", 1e-30, kLargestFlux, false});
    for (const std::string_view name : {"red", "green", "blue", "stokes_q", "stokes_u"})
        columns.push_back({name, 0, 0, false});
    CsvLines lines(source.text);
    const auto header = lines.next() ? csv_fields(lines.line) : std::nullopt;
    for (const std::string& name : header.value_or(std::vector<std::string>()))
        if (name.starts_with(kBand)) columns.push_back({bands.emplace_back(name), -kLargestFlux, kLargestFlux, false});
    return columns;
}

// The columns that are fitted: those in Jy that the scene has too, else luminance times solid angle.
Result<std::vector<std::string>> fitted_columns(const CsvTable& table, const TableSource& source, const Scene& scene) {
    std::vector<std::string> columns;
    for (const cli::FluxColumn& column : cli::flux_columns(scene))
        if (table.has(column.name)) columns.push_back(column.name);
    if (!columns.empty()) return columns;
    if (table.has("flux")) return std::vector<std::string>{"flux"};
    if (!table.has("jansky"))
        return table.fault(1, "header", "no flux that the scene has", "flux, jansky, or jansky_86GHz and so on");
    if (!source.free_flux)
        return table.fault(1, "jansky", "the scene's light is not in Jy", "--nuisance flux, or a column flux");
    return std::vector<std::string>{"jansky"};
}

Result<CurveData> read_curve(const TableSource& source, const Scene& scene) {
    std::deque<std::string> bands;
    TRY(table, CsvTable::read(source.text, source.name, curve_columns(source, bands), kMostData));
    CurveData data;
    data.in_seconds = table->has("time_s");
    if (data.in_seconds && table->has("time")) return table->fault(1, "time_s", "this column and time", "one of them");
    if (data.in_seconds && !scene.object.mass())
        return table->fault(1, "time_s", "the scene's object has no mass",
                            "[object] mass_suns or name, or time in r_s/c");
    TRY(columns, fitted_columns(*table, source, scene));
    data.columns = std::move(*columns);
    for (const TableLine& line : table->lines()) {
        TRY(time, table->number(line, data.in_seconds ? "time_s" : "time"));
        data.times.push_back(*time);
        for (const std::string& column : data.columns) {
            TRY(value, table->number(line, column));
            data.observed.value.push_back(*value);
        }
    }
    TRY(with_sigma, set_table_sigma(*table, "noise", source, "flux", data.columns.size(), data.observed));
    data.observed.what = table_words(counted(std::ssize(data.times), "time"), source);
    return data;
}

class CurveModel final : public PaintedModel {
public:
    CurveModel(std::shared_ptr<ScenePainter> painter, CurveData data, PaintedSize size)
        : PaintedModel(std::move(painter), size), data_(std::move(data)) {}
    Result<Prediction> predict(const std::vector<double>& values) override {
        Prediction prediction;
        double unit = 1;  // of time, r_s/c
        double from = 0;
        if (data_.in_seconds) {
            TRY(scene, scene_at(values));
            unit = kLight_m_s / schwarzschild_radius_m(scene->object.mass().value_or(1)), from = scene->time;
        }
        for (const double time : data_.times) {
            TRY(painted, paint(values, from + unit * time));
            if (Status added = add(*painted, prediction); !added) return added.error();
        }
        return prediction;
    }

private:
    // What the picture has of the fitted columns.
    Status add(const ScenePainter::Painted& painted, Prediction& prediction) const {
        const CameraSpec& camera = painted.scene.camera;
        const cli::PicturePixels whole{0, 0, camera.width, camera.height};
        const std::vector<cli::FluxColumn> units = cli::flux_columns(painted.scene);
        if (units.empty()) {
            prediction.push_back(cli::light_in(painted.captured.linear, camera, whole)[0]);
            return Done{};
        }
        const std::vector<double> fluxes = cli::fluxes_in(painted.captured, units, whole);
        for (const std::string& column : data_.columns) {
            const auto unit = std::ranges::find(units, column, &cli::FluxColumn::name);
            if (column != "flux" && unit == units.end()) return failed("no flux at the frequency of " + column);
            prediction.push_back(column == "flux" ? cli::light_in(painted.captured.linear, camera, whole)[0]
                                                  : fluxes[static_cast<std::size_t>(unit - units.begin())]);
        }
        return Done{};
    }
    CurveData data_;
};

}  // namespace

Result<Subject> curve_subject(const std::shared_ptr<ScenePainter>& painter, const TableSource& source,
                              std::optional<int> samples) {
    TRY(scene, painter->family().somewhere());
    if (!changes_with_time(*scene))
        return bad_input("nothing in the scene changes with time", "a scene of which `nullscope lightcurve` draws one");
    TRY(data, read_curve(source, *scene));
    Subject subject{data->observed, nullptr};
    PaintedSize size{scene->camera.width, scene->camera.height, kSearchSamples, has_bands(*scene)};
    if (!samples) {
        const CurveData few = data->every((data->times.size() + kSearchTimes - 1) / kSearchTimes);
        subject.coarse_data = few.observed;
        subject.coarse_model = std::make_unique<CurveModel>(painter, few, size);
    }
    size.samples = samples.value_or(kFirstSamples);
    make_finer(subject, samples, std::make_unique<CurveModel>(painter, std::move(*data), size));
    return subject;
}

}  // namespace nullscope::fit
