#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/bench.h"
#include "command/svg.h"

namespace nullscope::cli {
namespace {

constexpr double kWidth = 860, kHeight = 560, kLeft = 80, kRight = 190, kTop = 60, kBottom = 60;

struct Axis {
    double low, high, from, to;  // decades, pixels
    double at(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

const char* colour_of(const Method& method) {
    switch (method.kind) {
        case MethodKind::kStrip: return "#c2410c";
        case MethodKind::kTable: return "#1d4ed8";
        case MethodKind::kClosedForm: return "#7e22ce";
        case MethodKind::kIntegrate: return method.order == 1 ? "#52525b" : "#15803d";
        case MethodKind::kMino: return method.order == 4 ? "#15803d" : "#c2410c";
        default: return "#52525b";
    }
}

std::string grid(const Axis& x, const Axis& y) {
    std::string out;
    for (int d = static_cast<int>(std::ceil(x.low)); d <= x.high; ++d) {
        const double at = x.at(std::pow(10.0, d));
        out += svg_line(at, y.from, at, y.to);
        out += svg_text(at, y.from + 20, fmt::format("{:g}", std::pow(10.0, d)), 12, "middle");
    }
    for (int d = static_cast<int>(std::ceil(y.low)); d <= y.high; ++d) {
        const double at = y.at(std::pow(10.0, d));
        out += svg_line(x.from, at, x.to, at);
        out += svg_text(x.from - 8, at + 4, fmt::format("{:g}", std::pow(10.0, d)), 12, "end");
    }
    return out;
}

}  // namespace

std::string accuracy_svg(const std::vector<PlotPoint>& points, double floor_cost, const std::string& subtitle) {
    double c0 = floor_cost, c1 = floor_cost, e0 = 1e30, e1 = 0;
    for (const PlotPoint& p : points) {
        c0 = std::min(c0, p.cost), c1 = std::max(c1, p.cost);
        e0 = std::min(e0, p.error), e1 = std::max(e1, p.error);
    }
    const Axis x{std::floor(std::log10(c0) * 2) / 2, std::ceil(std::log10(c1) * 2) / 2, kLeft, kWidth - kRight};
    const Axis y{std::floor(std::log10(e0)), std::ceil(std::log10(e1)), kHeight - kBottom, kTop};
    const double floor_x = x.at(floor_cost);
    std::string out(kSvgWhite);
    out += svg_text(kLeft, 26, "What accuracy costs in time", 18, "start", "font-weight=\"bold\"");
    out += svg_text(kLeft, 44, subtitle, 10);
    out += grid(x, y);
    out += svg_line(floor_x, y.from, floor_x, y.to, "stroke=\"#18181b\" stroke-dasharray=\"4 3\"");
    out += svg_text(floor_x + 4, y.to + 12, "flat space", 11);
    out += svg_text(0.5 * (x.from + x.to), kHeight - 14, "core-seconds a frame of 1280x720", 13, "middle");
    out += svg_text(0, 0, "largest screen error, px of a 4K frame", 13, "middle",
                    fmt::format("transform=\"translate(22 {:.0f}) rotate(-90)\"", 0.5 * (y.from + y.to)));
    std::vector<std::pair<double, double>> labels;  // a dominated point's label is left out where another is already
    for (const bool important : {true, false}) {
        for (const PlotPoint& p : points) {
            if ((p.on_frontier || p.is_default) != important) continue;
            const double px = x.at(p.cost), py = y.at(p.error);
            const char* colour = important ? colour_of(p.method) : "#a1a1aa";
            out += fmt::format(
                "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"><title>{}: {:.4f} core-s, {:.2g} "
                "px</title></circle>\n",
                px, py, p.is_default ? 8 : 4.5, colour, p.label, p.cost, p.error);
            const bool crowded = std::ranges::any_of(labels, [&](const auto& at) {
                return std::fabs(at.second - py) < 11 && std::fabs(at.first - px) < 110;
            });
            if (crowded) continue;
            labels.emplace_back(px, py);
            out += svg_text(px + 11, py + 4, p.label + (p.is_default ? " (default)" : ""), p.is_default ? 12 : 10,
                            "start", p.is_default ? "font-weight=\"bold\"" : "fill=\"#71717a\"");
        }
    }
    return svg_document(kWidth, kHeight, out);
}

}  // namespace nullscope::cli
