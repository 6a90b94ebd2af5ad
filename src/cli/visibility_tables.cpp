#include "cli/visibility_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "command/curve_plot.h"

namespace nullscope::cli {
namespace {

constexpr double kDegrees = 180 / M_PI;

std::vector<std::complex<double>> intensities(const VisibilityRows& rows) {
    std::vector<std::complex<double>> found;
    found.reserve(rows.found.size());
    for (const Visibility& visibility : rows.found) found.push_back(visibility[0]);
    return found;
}

}  // namespace

std::string visibility_csv(const VisibilityRows& rows) {
    const char* unit = rows.in_jansky ? "_jy" : "";
    std::string text;
    if (!rows.time_h.empty()) text += "time_h,";
    if (!rows.frequency_ghz.empty()) text += "frequency_ghz,";
    if (rows.of_array()) text += "station_1,station_2,";
    text += fmt::format("u,v,amplitude{0},phase_deg,real{0},imaginary{0}", unit);
    if (!rows.noise.empty()) text += fmt::format(",noise{}", unit);
    if (rows.polarised)
        for (const char* plane : {"q", "u", "v"})
            text += fmt::format(",stokes_{0}_real{1},stokes_{0}_imaginary{1}", plane, unit);
    text += '\n';
    for (std::size_t i = 0; i < rows.baselines.size(); ++i) {
        if (!rows.time_h.empty()) text += fmt::format("{},", rows.time_h[i]);
        if (!rows.frequency_ghz.empty()) text += fmt::format("{},", rows.frequency_ghz[i]);
        if (rows.of_array())
            text += fmt::format("{},{},", rows.stations[rows.seen.pairs[i].first].name,
                                rows.stations[rows.seen.pairs[i].second].name);
        const auto [u, v] = rows.baselines[i];
        const std::complex<double> light = rows.found[i][0];
        text += fmt::format("{:.12g},{:.12g},{:.10g},{:.10g},{:.10g},{:.10g}", u, v, std::abs(light),
                            kDegrees * std::arg(light), light.real(), light.imag());
        if (!rows.noise.empty()) text += fmt::format(",{:.6g}", rows.noise[i]);
        for (std::size_t plane = 1; rows.polarised && plane < 4; ++plane)
            text += fmt::format(",{:.10g},{:.10g}", rows.found[i][plane].real(), rows.found[i][plane].imag());
        text += '\n';
    }
    return text;
}

std::string visibility_columns(const VisibilityRows& rows) {
    std::string words =
        "visibilities V = sum of I e^(2 pi i (u l + v m)), l to the east, m to the north, from the picture's middle. "
        "u, "
        "v: wavelengths, of station_1 less station_2; amplitude, phase_deg, real, imaginary: of V of I";
    words += rows.in_jansky ? ", Jy" : ", which is 1 at the baseline 0";
    if (!rows.time_h.empty()) words += "; time_h: hours";
    if (!rows.noise.empty()) words += "; noise: standard deviation of the real and of the imaginary part";
    if (rows.polarised) words += "; stokes_q, stokes_u, stokes_v: angles from north through east";
    return words;
}

std::string closure_phase_csv(const VisibilityRows& rows) {
    std::string text = "time_h,station_1,station_2,station_3,phase_deg\n";
    for (const ClosurePhase& closed : closure_phases(rows.seen, intensities(rows))) {
        text += fmt::format("{}", closed.hour);
        for (const std::size_t station : closed.stations) text += ',' + rows.stations[station].name;
        text += fmt::format(",{:.10g}\n", kDegrees * closed.phase);
    }
    return text;
}

std::string closure_amplitude_csv(const VisibilityRows& rows) {
    std::string text = "time_h,station_1,station_2,station_3,station_4,log_12_34_over_13_24,log_12_34_over_14_23\n";
    for (const ClosureAmplitude& closed : closure_amplitudes(rows.seen, intensities(rows))) {
        text += fmt::format("{}", closed.hour);
        for (const std::size_t station : closed.stations) text += ',' + rows.stations[station].name;
        text += fmt::format(",{:.10g},{:.10g}\n", closed.log[0], closed.log[1]);
    }
    return text;
}

std::string visibility_svg(const std::string& title, const VisibilityRows& rows) {
    constexpr std::size_t kMostDots = 20000;  // of more, evenly chosen ones
    const std::size_t step = rows.is_line ? 1 : rows.baselines.size() / kMostDots + 1;
    std::vector<std::array<double, 2>> points;
    if (!rows.is_line) points.push_back({0, rows.whole});
    for (std::size_t i = 0; i < rows.baselines.size(); i += step)
        points.push_back({1e-9 * std::hypot(rows.baselines[i].u, rows.baselines[i].v), std::abs(rows.found[i][0])});
    std::ranges::sort(points);
    const std::string words = fmt::format("{}: |V|{}", title, rows.in_jansky ? ", Jy" : "");
    return curve_plot(words, "baseline, Gλ", points, rows.is_line ? CurveInk::kLine : CurveInk::kDots);
}

}  // namespace nullscope::cli
