#include "scene/warp_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/csv.h"
#include "base/text.h"
#include "scene/warp_binary.h"

namespace nullscope {
namespace {

// Lines of a file: what is wrong with the one that was read last.
struct Lines {
    std::string_view name;
    CsvLines lines;
    Error wrong(std::string what, std::string allowed) const {
        Error error = bad_input(std::move(what), std::move(allowed));
        error.file = name, error.line = std::max(lines.number, 1);
        return error;
    }
    Result<std::vector<double>> some_numbers(const std::string& what) {
        if (!lines.next()) return wrong("the file ends here", what);
        constexpr std::size_t kLongestLine = 400;
        if (lines.line.size() > kLongestLine) return wrong(fmt::format("a line of {} bytes", lines.line.size()), what);
        std::string text(lines.line);
        std::ranges::replace(text, '\t', ' ');
        std::vector<double> values;
        for (const std::string& word : split(text, ' ')) {
            if (word.empty()) continue;
            const auto value = parse_number(word);
            if (!value)
                return wrong(fmt::format("\"{}\" is not a finite number", without_controls(word.substr(0, 40))), what);
            values.push_back(*value);
        }
        return values;
    }
    // The numbers of the next line, as many as there should be.
    Result<std::vector<double>> numbers(std::size_t count, const std::string& what) {
        TRY(values, some_numbers(what));
        if (values->size() != count) return wrong(fmt::format("{} numbers instead of {}", values->size(), count), what);
        return values;
    }
    // Numbers of nodes along the sides.
    std::optional<Error> sides_wrong(const std::vector<double>& sides) const {
        for (const double side : sides)
            if (side != std::floor(side) || side < 2 || side > kMostWarpSide)
                return wrong(fmt::format("{} nodes along a side", side), fmt::format("2 to {}", kMostWarpSide));
        if (sides[0] * sides[1] > kMostWarpNodes)
            return wrong(fmt::format("{} nodes", sides[0] * sides[1]), fmt::format("at most {}", kMostWarpNodes));
        return std::nullopt;
    }
};

// How far neighbours are apart on the screen, in all, if the nodes come in rows of so many.
double length_of(const WarpNodes& mesh, int columns, int rows, bool by_columns) {
    const auto at = [&](int column, int row) -> const WarpNode& {
        return mesh.nodes[static_cast<std::size_t>(by_columns ? column * rows + row : row * columns + column)];
    };
    const auto apart = [](const WarpNode& a, const WarpNode& b) { return std::fabs(a.x - b.x) + std::fabs(a.y - b.y); };
    double sum = 0.0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (column + 1 < columns || mesh.joined) sum += apart(at(column, row), at((column + 1) % columns, row));
            if (row + 1 < rows) sum += apart(at(column, row), at(column, row + 1));
        }
    return sum;
}

// Column by column is put row by row. Of an even mesh that is not joined both orders are the same cells.
void put_in_rows(WarpNodes& mesh) {
    constexpr double kClearly = 0.95;
    if (!(length_of(mesh, mesh.columns, mesh.rows, true) < kClearly * length_of(mesh, mesh.columns, mesh.rows, false)))
        return;
    std::vector<WarpNode> nodes;
    nodes.reserve(mesh.nodes.size());
    for (int row = 0; row < mesh.rows; ++row)
        for (int column = 0; column < mesh.columns; ++column)
            nodes.push_back(mesh.nodes[static_cast<std::size_t>(column) * static_cast<std::size_t>(mesh.rows) +
                                       static_cast<std::size_t>(row)]);
    mesh.nodes = std::move(nodes);
}

Result<WarpNodes> bourke_nodes(Lines& lines, double type, std::size_t bytes) {
    if (type != 1.0 && type != 2.0)
        return lines.wrong(fmt::format("{} is no kind of mesh", type), "1 (polar) or 2 (rectangular)");
    TRY(size, lines.numbers(2, "the numbers of nodes, nx ny"));
    if (auto wrong = lines.sides_wrong(*size)) return *wrong;
    WarpNodes mesh{{}, static_cast<int>(size->front()), static_cast<int>(size->back()), type == 1.0};
    const int count = mesh.columns * mesh.rows;
    mesh.nodes.reserve(std::min(static_cast<std::size_t>(count), bytes / 10 + 1));  // "0 0 0 0 0\n"
    for (int i = 0; i < count; ++i) {
        TRY(node, lines.numbers(5, fmt::format("x y u v i of node {} of {}", i + 1, count)));
        const std::vector<double>& value = *node;
        constexpr const char* kNames[] = {"x", "y", "u", "v", "i"};
        for (std::size_t k = 0; k < 5; ++k) {
            const double most = k == 4 ? kMostWarpLight : kMostWarpPlace;
            if (value[k] < -most || value[k] > most)
                return lines.wrong(fmt::format("{} = {} is out of range", kNames[k], value[k]),
                                   fmt::format("[{}, {}]", -most, most));
        }
        mesh.nodes.push_back({value[0], value[1], value[2], value[3], value[4]});
    }
    if (lines.lines.next()) return lines.wrong("a line after the last node", fmt::format("{} nodes", count));
    put_in_rows(mesh);
    return mesh;
}

Result<WarpNodes> stellarium_nodes(Lines& lines, std::vector<double> sides, const WarpScreen& screen) {
    for (double& side : sides) ++side;  // numbers of the last ones
    if (auto wrong = lines.sides_wrong(sides)) return *wrong;
    WarpNodes mesh{{}, static_cast<int>(sides[0]), static_cast<int>(sides[1]), false, true};
    const int last_x = mesh.columns - 1, last_y = mesh.rows - 1, count = mesh.columns * mesh.rows;
    const double circle = std::min(screen.width, screen.height);
    for (int i = 0; i < count; ++i) {
        TRY(node, lines.numbers(5, fmt::format("x y r g b of node {} of {}", i + 1, count)));
        const std::vector<double>& value = *node;
        for (const double place : {value[0], value[1]})
            if (!(std::fabs(place) <= 0.5 * kMostWarpPlace * circle))
                return lines.wrong(fmt::format("{} is out of range", place),
                                   fmt::format("px, up to {}", 0.5 * kMostWarpPlace * circle));
        for (const double light : {value[2], value[3], value[4]})
            if (light != value[2] || light < 0.0 || light > kMostWarpLight)
                return lines.wrong("a node with a colour", fmt::format("r = g = b, [0, {}]", kMostWarpLight));
        const int column = i % mesh.columns, row = i / mesh.columns;
        const double across = column == 0 ? 0.0 : column == last_x ? 1.0 : (column - 0.5 * (row % 2)) / (last_x - 0.5);
        mesh.nodes.push_back({(2 * across - 1) * screen.aspect(), 2.0 * row / last_y - 1,
                              0.5 + (value[0] - 0.5 * screen.width) / circle,
                              0.5 + (value[1] - 0.5 * screen.height) / circle, value[2]});
    }
    if (lines.lines.next()) return lines.wrong("a line after the last node", fmt::format("{} nodes", count));
    return mesh;
}

}  // namespace

Result<WarpNodes> read_warp_nodes(std::string_view text, const std::string& name, const WarpScreen& screen) {
    if (is_warp_binary(text)) {
        auto mesh = read_warp_binary(text, screen);
        if (mesh) {
            put_in_rows(*mesh);
            return mesh;
        }
        Error error = mesh.error();
        error.file = name;
        return error;
    }
    Lines lines{name, CsvLines(text)};
    constexpr const char* kFirst = "the mesh's kind: 1 (polar) or 2 (rectangular); or Stellarium's max_x max_y";
    TRY(first, lines.some_numbers(kFirst));
    if (first->size() == 2) return stellarium_nodes(lines, *first, screen);
    if (first->size() != 1) return lines.wrong(fmt::format("{} numbers instead of 1", first->size()), kFirst);
    return bourke_nodes(lines, first->front(), text.size());
}

}  // namespace nullscope
