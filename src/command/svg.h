// The parts that the program's diagrams are made of, as SVG. Lengths in px.
#pragma once
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace nullscope::cli {

inline constexpr std::string_view kSvgWhite = "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";

inline std::string svg_document(double width, double height, const std::string& inside) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" fill=\"#18181b\">\n{2}</svg>\n",
        width, height, inside);
}

// A text that has no markup, as one may stand between tags and in an attribute.
inline std::string in_xml(std::string_view text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

// anchor: start, middle or end of the words. more: other attributes.
inline std::string svg_text(double x, double y, std::string_view words, double size, std::string_view anchor = "start",
                            std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" {}>{}</text>\n", x, y,
                       anchor, size, more, words);
}

inline std::string svg_line(double x1, double y1, double x2, double y2, std::string_view more = "stroke=\"#e4e4e7\"") {
    return fmt::format("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, x2, y1, y2, more);
}

inline std::string svg_dot(double x, double y, double radius, std::string_view colour) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n", x, y, radius, colour);
}

// kind: polyline or polygon.
inline std::string svg_curve(std::string_view kind, const std::vector<std::array<double, 2>>& points, double width,
                             std::string_view colour) {
    std::string places;
    for (const auto& [x, y] : points) places += fmt::format("{:.2f},{:.2f} ", x, y);
    return fmt::format("<{} fill=\"none\" stroke-width=\"{}\" stroke=\"{}\" points=\"{}\"/>\n", kind, width, colour,
                       places);
}

}  // namespace nullscope::cli
