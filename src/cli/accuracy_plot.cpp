#include "cli/accuracy_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nullscope::cli {
namespace {

constexpr double kWidth = 860, kHeight = 560, kLeft = 80, kRight = 190, kTop = 60, kBottom = 60;

struct Axis {
    double low, high, from, to;  // decades, pixels
    double at(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

const char* colour_of(const std::string& family) {
    static const std::map<std::string, const char*> colours = {
        {"strip", "#c2410c"}, {"table", "#1d4ed8"},  {"closed-form", "#7e22ce"}, {"integrate", "#15803d"},
        {"euler", "#52525b"}, {"mino:6", "#c2410c"}, {"mino:4", "#15803d"},      {"kerr-schild", "#52525b"}};
    const auto found = colours.find(family);
    return found == colours.end() ? "#000000" : found->second;
}

std::string text(double x, double y, const std::string& words, const char* anchor, int size, const char* extra = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" {}>{}</text>\n", x, y,
                       anchor, size, extra, words);
}

std::string grid(const Axis& x, const Axis& y) {
    std::string out;
    for (int d = static_cast<int>(std::ceil(x.low)); d <= x.high; ++d) {
        const double at = x.at(std::pow(10.0, d));
        out += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#e4e4e7\"/>\n", at,
                           y.from, y.to);
        out += text(at, y.from + 20, fmt::format("{:g}", std::pow(10.0, d)), "middle", 12);
    }
    for (int d = static_cast<int>(std::ceil(y.low)); d <= y.high; ++d) {
        const double at = y.at(std::pow(10.0, d));
        out += fmt::format("<line x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" stroke=\"#e4e4e7\"/>\n", at,
                           x.from, x.to);
        out += text(x.from - 8, at + 4, fmt::format("{:g}", std::pow(10.0, d)), "end", 12);
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
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" fill=\"#18181b\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        kWidth, kHeight);
    out += text(kLeft, 26, "What accuracy costs in time", "start", 18, "font-weight=\"bold\"") +
           text(kLeft, 44, subtitle, "start", 10);
    out += grid(x, y);
    const double floor_x = x.at(floor_cost);
    out += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#18181b\" stroke-dasharray=\"4 3\"/>\n",
        floor_x, y.from, y.to);
    out += text(floor_x + 4, y.to + 12, "flat space", "start", 11);
    out += text(0.5 * (x.from + x.to), kHeight - 14, "core-seconds a frame of 1280x720", "middle", 13);
    out += fmt::format(
        "<text transform=\"translate(22 {:.0f}) rotate(-90)\" text-anchor=\"middle\" font-size=\"13\">largest screen "
        "error, px of a 4K frame</text>\n",
        0.5 * (y.from + y.to));
    std::vector<std::pair<double, double>> labels;  // a dominated point's label is left out where another is already
    for (const bool important : {true, false}) {
        for (const PlotPoint& p : points) {
            if ((p.on_frontier || p.is_default) != important) continue;
            const double px = x.at(p.cost), py = y.at(p.error);
            const char* colour = important ? colour_of(p.family) : "#a1a1aa";
            out += fmt::format(
                "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"><title>{}: {:.4f} core-s, {:.2g} "
                "px</title></circle>\n",
                px, py, p.is_default ? 8 : 4.5, colour, p.label, p.cost, p.error);
            const bool crowded = std::any_of(labels.begin(), labels.end(), [&](const auto& at) {
                return std::fabs(at.second - py) < 11 && std::fabs(at.first - px) < 110;
            });
            if (crowded) continue;
            labels.emplace_back(px, py);
            out += text(px + 11, py + 4, p.label + (p.is_default ? " (default)" : ""), "start", p.is_default ? 12 : 10,
                        p.is_default ? "font-weight=\"bold\"" : "fill=\"#71717a\"");
        }
    }
    return out + "</svg>\n";
}

}  // namespace nullscope::cli
