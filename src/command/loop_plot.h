// A diagram of Q and U along time, with equal axes, as SVG.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "command/svg.h"

namespace nullscope::cli {

inline constexpr double kLoopWidth = 360, kLoopHeight = 340;  // px

// 1, 2 or 5 times a power of ten, some five of which make this length.
inline double loop_step(double length) {
    const double rough = length / 5.0, power = std::pow(10.0, std::floor(std::log10(rough)));
    return rough <= power         ? power
           : rough <= 2.0 * power ? 2.0 * power
           : rough <= 5.0 * power ? 5.0 * power
                                  : 10.0 * power;
}

// shape: Q and U of the mean of I, in order of time; present: one of them, which is marked. What lies within kLoopWidth and kLoopHeight; points along the way are
// at eighths of the time, the larger the later.
inline std::string loop_plot(const std::vector<std::array<double, 2>>& shape, std::size_t present) {
    constexpr double kSide = 250, kLeft = 70, kTop = 40;
    double q_low = 0.0, q_high = 0.0, u_low = 0.0, u_high = 0.0;  // the origin is shown
    for (const auto& [q, u] : shape) {
        q_low = std::min(q_low, q), q_high = std::max(q_high, q);
        u_low = std::min(u_low, u), u_high = std::max(u_high, u);
    }
    const double wide = std::max({q_high - q_low, u_high - u_low, 1e-6}), half = 0.54 * wide;
    const double q0 = 0.5 * (q_low + q_high), u0 = 0.5 * (u_low + u_high), scale = 0.5 * kSide / half;
    const auto x_of = [&](double q) { return kLeft + 0.5 * kSide + scale * (q - q0); };
    const auto y_of = [&](double u) { return kTop + 0.5 * kSide - scale * (u - u0); };
    const auto dot = [&](const std::array<double, 2>& at, double radius, const char* more) {
        return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.1f}\" {}/>\n", x_of(at[0]), y_of(at[1]), radius,
                           more);
    };
    std::string svg = svg_text(kLeft, 24, "Q and U, % of the mean I", 15);
    const double step = loop_step(2.0 * half);
    const auto words = [&](double i) { return fmt::format("{:.4g}", 100.0 * i * step + 0.0); };
    for (double i = std::ceil((q0 - half) / step); i * step <= q0 + half; i += 1.0) {
        svg += svg_line(x_of(i * step), kTop, x_of(i * step), kTop + kSide,
                        i == 0.0 ? "stroke=\"#a1a1aa\"" : "stroke=\"#e4e4e7\"");
        svg += svg_text(x_of(i * step), kTop + kSide + 18, words(i), 13, "middle");
    }
    for (double i = std::ceil((u0 - half) / step); i * step <= u0 + half; i += 1.0) {
        svg += svg_line(kLeft, y_of(i * step), kLeft + kSide, y_of(i * step),
                        i == 0.0 ? "stroke=\"#a1a1aa\"" : "stroke=\"#e4e4e7\"");
        svg += svg_text(kLeft - 8, y_of(i * step) + 4, words(i), 13, "end");
    }
    std::vector<std::array<double, 2>> places;
    places.reserve(shape.size());
    for (const auto& [q, u] : shape) places.push_back({x_of(q), y_of(u)});
    svg += svg_curve("polyline", places, 1.8, "#1d4ed8");
    constexpr std::size_t kParts = 8;
    for (std::size_t i = 1; i < kParts; ++i)
        svg += dot(shape[i * (shape.size() - 1) / kParts], 1.2 + 0.35 * static_cast<double>(i), "fill=\"#1d4ed8\"");
    svg += dot(shape[present], 5.5, "fill=\"#c2410c\" stroke=\"#ffffff\" stroke-width=\"1.5\"");
    svg += svg_text(kLeft + 0.5 * kSide, kTop + kSide + 38, "Q, along the picture's width", 13, "middle");
    svg += svg_text(kLeft - 46, kTop + 14, "U", 13);
    return svg;
}

}  // namespace nullscope::cli
