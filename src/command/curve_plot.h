// A diagram of one curve over a grid, as SVG.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "command/svg.h"

namespace nullscope::cli {

inline constexpr double kCurveWidth = 760, kCurveHeight = 340;  // px
enum class CurveInk { kLine, kDots };

// points: two or more, by ascending x; the vertical axis includes 0. title: as it stands in a scene file, no markup. What lies in a document of this size.
inline std::string curve_drawing(const std::string& title, const std::string& x_words,
                                 const std::vector<std::array<double, 2>>& points, CurveInk ink = CurveInk::kLine) {
    constexpr double kWidth = kCurveWidth, kHeight = kCurveHeight, kLeft = 84, kBottom = 52, kTop = 40, kRight = 20;
    const std::string plain = in_xml(title);
    const auto by_value = [](const auto& a, const auto& b) { return a[1] < b[1]; };
    const auto [least, most] = std::ranges::minmax_element(points, by_value);
    const double low = std::min((*least)[1], 0.0), high = (*most)[1] > low ? (*most)[1] : low + 1;
    const double first = points.front()[0], last = points.back()[0], span = last > first ? last - first : 1;
    const auto x_of = [&](double x) { return kLeft + (x - first) / span * (kWidth - kLeft - kRight); };
    const auto y_of = [&](double y) {
        return kHeight - kBottom - (y - low) / (high - low) * (kHeight - kBottom - kTop);
    };
    // Of times that begin late: as many digits as tell them apart.
    const double most_x = std::max({std::fabs(first), std::fabs(first + span), span});
    const int digits = 4 + std::max(static_cast<int>(std::floor(std::log10(most_x / span))), 0);
    std::string svg = svg_text(kLeft, 24, plain, 15);
    for (int i = 0; i <= 4; ++i) {
        const double x = first + i * span / 4, y = low + i * (high - low) / 4;
        svg += svg_line(x_of(x), y_of(low), x_of(x), y_of(high));
        svg += svg_text(x_of(x), kHeight - kBottom + 20, fmt::format("{:.{}g}", x, digits), 13, "middle");
        svg += svg_line(kLeft, y_of(y), kWidth - kRight, y_of(y));
        svg += svg_text(kLeft - 8, y_of(y) + 4, fmt::format("{:.3g}", y), 13, "end");
    }
    std::vector<std::array<double, 2>> places;
    places.reserve(points.size());
    for (const auto& [x, y] : points) places.push_back({x_of(x), y_of(y)});
    constexpr const char* kInk = "#c2410c";
    if (ink == CurveInk::kLine) svg += svg_curve("polyline", places, 1.8, kInk);
    for (std::size_t i = 0; ink == CurveInk::kDots && i < places.size(); ++i)
        svg += svg_dot(places[i][0], places[i][1], 1.5, kInk);
    svg += svg_text(0.5 * (kLeft + kWidth - kRight), kHeight - 10, x_words, 13, "middle");
    return svg;
}

inline std::string curve_plot(const std::string& title, const std::string& x_words,
                              const std::vector<std::array<double, 2>>& points, CurveInk ink = CurveInk::kLine) {
    return svg_document(kCurveWidth, kCurveHeight, std::string(kSvgWhite) + curve_drawing(title, x_words, points, ink));
}

}  // namespace nullscope::cli
