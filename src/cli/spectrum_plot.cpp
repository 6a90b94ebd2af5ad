#include "cli/spectrum_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "command/svg.h"

namespace nullscope::cli {
namespace {

constexpr double kWidth = 760, kHeight = 420, kLeft = 84, kBottom = 56, kTop = 72, kRight = 24;

// 1, 2 or 5 times a power of ten: some six steps in this length.
double step_of(double length) {
    const double rough = length / 6.0, power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= rough) return digit * power;
    return 10.0 * power;
}

}  // namespace

std::string spectrum_plot(const std::string& title, const std::string& words, const LineProfile& profile,
                          std::optional<double> line_kev) {
    const double unit = line_kev.value_or(1.0), first = profile.from * unit, last = profile.to * unit;
    const std::size_t count = profile.photons.size();
    const double bin = (last - first) / static_cast<double>(count);
    double high = 0.0;
    for (std::size_t i = 0; i < count; ++i) high = std::max(high, profile.share(i) / bin);
    if (!(high > 0.0)) high = 1.0;
    high *= 1.05;
    const auto x_of = [&](double x) { return kLeft + (x - first) / (last - first) * (kWidth - kLeft - kRight); };
    const auto y_of = [&](double y) { return kHeight - kBottom - y / high * (kHeight - kBottom - kTop); };
    std::string svg(kSvgWhite);
    svg += svg_text(kLeft, 24, in_xml(title), 15);
    svg += svg_text(kLeft, 46, in_xml(words), 12);
    svg += svg_text(kLeft, 64, line_kev ? "photons per keV, of all" : "photons per unit of g, of all", 12);
    const double step_x = step_of(last - first), step_y = step_of(high);
    for (double i = std::ceil(first / step_x - 1e-9); i * step_x <= last + 1e-9 * step_x; i += 1.0) {
        svg += svg_line(x_of(i * step_x), y_of(0.0), x_of(i * step_x), y_of(high));
        svg +=
            svg_text(x_of(i * step_x), kHeight - kBottom + 20, fmt::format("{:.6g}", i * step_x + 0.0), 13, "middle");
    }
    for (double i = 0.0; i * step_y <= high; i += 1.0) {
        svg += svg_line(kLeft, y_of(i * step_y), kWidth - kRight, y_of(i * step_y));
        svg += svg_text(kLeft - 8, y_of(i * step_y) + 4, fmt::format("{:.6g}", i * step_y), 13, "end");
    }
    if (first < unit && unit < last)  // where the line is emitted
        svg += svg_line(x_of(unit), y_of(0.0), x_of(unit), y_of(high), "stroke=\"#a1a1aa\" stroke-dasharray=\"4 3\"");
    std::vector<std::array<double, 2>> points{{x_of(first), y_of(0.0)}};
    for (std::size_t i = 0; i < count; ++i) {
        const double height = y_of(profile.share(i) / bin), left = first + static_cast<double>(i) * bin;
        points.push_back({x_of(left), height}), points.push_back({x_of(left + bin), height});
    }
    points.push_back({x_of(last), y_of(0.0)});
    svg += svg_curve("polyline", points, 1.4, "#c2410c");
    svg += svg_text(0.5 * (kLeft + kWidth - kRight), kHeight - 12,
                    line_kev ? "energy, keV" : "g, observed over emitted frequency", 13, "middle");
    return svg_document(kWidth, kHeight, svg);
}

}  // namespace nullscope::cli
