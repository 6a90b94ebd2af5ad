#include "fit/visibility_subject.h"

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "base/text.h"
#include "command/sky_light.h"
#include "fit/painted_model.h"
#include "fit/visibility_slopes.h"
#include "telescope/csv_table.h"
#include "telescope/flux.h"
#include "telescope/visibility.h"

namespace nullscope::fit {
namespace {

constexpr double kFarthest = 1e15, kBrightest = 1e30;  // wavelengths; in the table's unit

struct VisibilityData {
    std::vector<Baseline> baselines;
    bool is_complex = true, in_jansky = false;
    Observed observed;  // of each baseline one number or two
};

// Those of `nullscope visibility`; in Jy the names end in _jy.
std::vector<TableColumn> visibility_table_columns() {
    std::vector<TableColumn> columns = {{"u", -kFarthest, kFarthest}, {"v", -kFarthest, kFarthest}};
    for (const std::string_view name : {"time_h", "frequency_ghz", "amplitude", "amplitude_jy", "phase_deg", "real",
                                        "real_jy", "imaginary", "imaginary_jy"})
        columns.push_back({name, -kBrightest, kBrightest, false});
    for (const std::string_view name : {"noise", "noise_jy"}) columns.push_back({name, 1e-30, kBrightest, false});
    for (const std::string_view name :
         {"station_1", "station_2", "stokes_q_real", "stokes_q_imaginary", "stokes_u_real", "stokes_u_imaginary",
          "stokes_v_real", "stokes_v_imaginary", "stokes_q_real_jy", "stokes_q_imaginary_jy", "stokes_u_real_jy",
          "stokes_u_imaginary_jy", "stokes_v_real_jy", "stokes_v_imaginary_jy"})
        columns.push_back({name, 0, 0, false});
    return columns;
}

Result<VisibilityData> read_visibilities(const TableSource& source) {
    TRY(table, CsvTable::read(source.text, source.name, visibility_table_columns(), kMostData));
    VisibilityData data;
    data.in_jansky = table->has("amplitude_jy") || table->has("real_jy");
    const std::string unit = data.in_jansky ? "_jy" : "";
    const std::vector<std::string> complex = {"real" + unit, "imaginary" + unit}, real = {"amplitude" + unit};
    data.is_complex = table->has(complex[0]) && table->has(complex[1]);
    if (!data.is_complex && !table->has(real[0]))
        return table->fault(1, "header", "no visibilities",
                            "real and imaginary, or amplitude; of each in Jy real_jy, ...");
    const std::vector<std::string>& columns = data.is_complex ? complex : real;
    for (const TableLine& line : table->lines()) {
        TRY(u, table->number(line, "u"));
        TRY(v, table->number(line, "v"));
        data.baselines.push_back({*u, *v});
        for (const std::string& column : columns) {
            TRY(value, table->number(line, column));
            data.observed.value.push_back(*value);
        }
    }
    TRY(with_sigma, set_table_sigma(*table, "noise" + unit, source, "amplitude", columns.size(), data.observed));
    data.observed.what = table_words(counted(std::ssize(data.baselines), "visibility", "visibilities"), source);
    return data;
}

// The picture's pixels are means of their light: squares.
class VisibilityModel final : public PaintedModel {
public:
    VisibilityModel(std::shared_ptr<ScenePainter> painter, const VisibilityData& data, PaintedSize size)
        : PaintedModel(std::move(painter), size), baselines_(data.baselines), is_complex_(data.is_complex) {}
    Result<Prediction> predict(const std::vector<double>& values) override {
        TRY(painted, paint(values));
        TRY(light, cli::sky_light(painted->scene, painted->captured));
        const PictureVisibility sky(light->picture, PixelShape::kSquare);
        Prediction prediction;
        for (const Visibility& visibility : sky.at(baselines_)) {
            if (is_complex_)
                prediction.push_back(visibility[0].real()), prediction.push_back(visibility[0].imag());
            else
                prediction.push_back(std::abs(visibility[0]));
        }
        return prediction;
    }

    Result<std::vector<Prediction>> derivatives(const std::vector<double>& values) override {
        return visibility_slopes(family(), values, baselines_, is_complex_);
    }

private:
    std::vector<Baseline> baselines_;
    bool is_complex_;
};

}  // namespace

Result<Subject> visibility_subject(const std::shared_ptr<ScenePainter>& painter, const TableSource& source,
                                   std::optional<int> samples) {
    TRY(data, read_visibilities(source));
    TRY(scene, painter->family().somewhere());
    TRY(scaled, cli::sky_scale(*scene));
    if (data->in_jansky != flux_unit(*scene, false).has_value() && !source.free_flux)
        return bad_input(data->in_jansky ? "the table is in Jy, the scene's light is not"
                                         : "the scene's light is in Jy, the table is not",
                         "--nuisance flux");
    Subject subject{data->observed, nullptr};
    make_finer(
        subject, samples,
        std::make_unique<VisibilityModel>(
            painter, *data, PaintedSize{scene->camera.width, scene->camera.height, samples.value_or(kFirstSamples)}));
    return subject;
}

}  // namespace nullscope::fit
