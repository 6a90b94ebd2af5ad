#include "scene/warp_binary.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace nullscope {
namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at, bool little) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + (little ? 3 - i : i)]);
    return value;
}
double float_at(std::string_view bytes, std::size_t at, bool little) {
    return std::bit_cast<float>(number_at(bytes, at, little));
}

Error cut_off() { return bad_input("the mesh is cut off"); }

// "SGC", version, kind, eleven floats of the projector's view, columns and rows; of each node x y z u v w.
Result<WarpNodes> sgc_nodes(std::string_view bytes, const WarpScreen& screen) {
    constexpr std::size_t kHead = 8 + 44 + 8, kNode = 24;
    if (bytes.size() < kHead) return cut_off();
    const int version = static_cast<unsigned char>(bytes[3]);
    if (version != 1 && version != '1') return bad_input(fmt::format("SGC of version {}", version), "version 1");
    if (number_at(bytes, 4, true) != 0) return bad_input("SGC of a cube", "a planar one");
    const std::size_t columns = number_at(bytes, kHead - 8, true), rows = number_at(bytes, kHead - 4, true);
    if (columns < 2 || rows < 2 || columns > kMostWarpSide || rows > kMostWarpSide || columns * rows > kMostWarpNodes)
        return bad_input(fmt::format("{} x {} nodes", columns, rows),
                         fmt::format("2 to {} along a side, at most {}", kMostWarpSide, kMostWarpNodes));
    if ((bytes.size() - kHead) / kNode < columns * rows) return cut_off();
    WarpNodes mesh{{}, static_cast<int>(columns), static_cast<int>(rows), false, true};
    mesh.nodes.reserve(columns * rows);
    for (std::size_t i = 0; i < columns * rows; ++i) {
        const auto value = [&](std::size_t k) { return float_at(bytes, kHead + kNode * i + 4 * k, true); };
        for (const std::size_t k : {0, 1, 3, 4})
            if (!(std::fabs(value(k)) <= kMostWarpPlace))
                return bad_input(fmt::format("{} of node {} is out of range", value(k), i + 1),
                                 fmt::format("[-{0}, {0}]", kMostWarpPlace));
        mesh.nodes.push_back({(2 * value(0) - 1) * screen.aspect(), 1 - 2 * value(1), value(3), value(4), 1.0});
    }
    return mesh;
}

struct Pfm {
    std::string_view pixels;
    int width = 0, height = 0;
    bool little = false;
    double at(int x, int row, int channel) const {
        return float_at(
            pixels,
            4 * (3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) +
                 static_cast<std::size_t>(channel)),
            little);
    }
    bool there(int x, int row, bool absolute) const {
        const double a = at(x, row, 0), b = at(x, row, 1);
        return std::fabs(a) <= kMostWarpPlace && std::fabs(b) <= kMostWarpPlace && !(absolute && (a < 0.0 || b < 0.0));
    }
};

Result<Pfm> open_pfm(std::string_view bytes) {
    Pfm pfm;
    std::size_t end = 0;
    for (int lines = 0; lines < 3; ++lines) {
        end = bytes.substr(0, 200).find('\n', end);
        if (end++ == std::string_view::npos) return cut_off();
    }
    const std::string head(bytes.substr(0, end));
    char kind = 0;
    double scale = 0.0;
    if (std::sscanf(head.c_str(), "P%c %9d %9d %lf", &kind, &pfm.width, &pfm.height, &scale) != 4 || scale == 0.0)
        return bad_input("the head of the PFM is damaged", "PF, width, height, a number that is not 0");
    if (kind != 'F') return bad_input("a grey PFM", "PF, of three channels");
    constexpr int kMostPfmSide = 1 << 15;
    if (pfm.width < 2 || pfm.height < 2 || pfm.width > kMostPfmSide || pfm.height > kMostPfmSide)
        return bad_input(fmt::format("{} x {} pixels", pfm.width, pfm.height), fmt::format("2 to {}", kMostPfmSide));
    pfm.pixels = bytes.substr(end), pfm.little = scale < 0.0;
    const std::size_t count = static_cast<std::size_t>(pfm.width) * static_cast<std::size_t>(pfm.height);
    if (pfm.pixels.size() / 12 < count) return cut_off();
    return pfm;
}

// By how much a channel grows from one end of its rows (or columns) to the other, on average of those that have both ends.
double growth(const Pfm& pfm, int channel, bool down) {
    double sum = 0.0;
    int count = 0;
    const int along = down ? pfm.height : pfm.width, lines = down ? pfm.width : pfm.height;
    for (int line = 0; line < lines; ++line) {
        const auto there = [&](int i) { return pfm.there(down ? line : i, down ? i : line, false); };
        int first = 0, last = along - 1;
        while (first < last && !there(first)) ++first;
        while (last > first && !there(last)) --last;
        if (last == first) continue;
        const double from = down ? pfm.at(line, first, channel) : pfm.at(first, line, channel),
                     to = down ? pfm.at(line, last, channel) : pfm.at(last, line, channel);
        sum += (to - from) * (along - 1) / (last - first), ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

// Places of the nodes along a side: every step-th, and the last.
std::vector<int> every(int count, int step) {
    std::vector<int> places;
    for (int i = 0; i < count - 1; i += step) places.push_back(i);
    places.push_back(count - 1);
    return places;
}

// Values belong to middles of pixels: nodes at the rim go out to the picture's edge, along the line to the node within.
void reach_edge(WarpNodes& mesh, const std::vector<int>& columns, const std::vector<int>& rows) {
    const auto move = [&](std::size_t rim, std::size_t within, double share) {
        WarpNode &a = mesh.nodes[rim], &b = mesh.nodes[within];
        if (a.light < 0.0 || b.light < 0.0) return;
        a.x += share * (a.x - b.x), a.y += share * (a.y - b.y), a.u += share * (a.u - b.u), a.v += share * (a.v - b.v);
    };
    const std::size_t w = columns.size(), h = rows.size();
    const auto share = [](const std::vector<int>& at, std::size_t i, std::size_t k) {
        return 0.5 / std::abs(at[k] - at[i]);
    };
    for (std::size_t row = 0; row < h; ++row) {
        move(row * w, row * w + 1, share(columns, 0, 1));
        move(row * w + w - 1, row * w + w - 2, share(columns, w - 1, w - 2));
    }
    for (std::size_t column = 0; column < w; ++column) {
        move(column, w + column, share(rows, 0, 1));
        move((h - 1) * w + column, (h - 2) * w + column, share(rows, h - 1, h - 2));
    }
}

Result<WarpNodes> pfm_nodes(std::string_view bytes, const WarpScreen& screen) {
    TRY(pfm, open_pfm(bytes));
    constexpr double kAbsolute = 0.5;
    const bool absolute = std::fabs(growth(*pfm, 0, false)) > kAbsolute;
    const bool upper_first = !absolute || growth(*pfm, 1, true) < 0.0;
    int step = 1;
    const auto size = [&](int s) {
        return static_cast<long long>(every(pfm->width, s).size()) * std::ssize(every(pfm->height, s));
    };
    while (size(step) > kMostWarpNodes || std::max(pfm->width, pfm->height) / step >= kMostWarpSide) ++step;
    const std::vector<int> columns = every(pfm->width, step), rows = every(pfm->height, step);
    WarpNodes mesh{{}, static_cast<int>(columns.size()), static_cast<int>(rows.size()), false, true};
    mesh.nodes.reserve(columns.size() * rows.size());
    for (const int row : rows)
        for (const int column : columns) {
            const bool there = pfm->there(column, row, absolute);
            const double a = there ? pfm->at(column, row, 0) : 0.0, b = there ? pfm->at(column, row, 1) : 0.0;
            const double rim = absolute ? 0.5 : 0.0;  // values of pixels' middles, or of an even grid
            const double s = (column + rim) / (pfm->width - 1 + 2 * rim), t = (row + rim) / (pfm->height - 1 + 2 * rim),
                         up = upper_first ? 1 - t : t;
            WarpNode node{s, up, a, b, there ? 1.0 : -1.0};
            if (!absolute) node = {s + a, up + b, s, up, node.light};
            mesh.nodes.push_back({(2 * node.x - 1) * screen.aspect(), 2 * node.y - 1, node.u, node.v, node.light});
        }
    if (absolute) reach_edge(mesh, columns, rows);
    return mesh;
}

}  // namespace

bool is_warp_binary(std::string_view bytes) {
    return bytes.starts_with("SGC") || bytes.starts_with("PF\n") || bytes.starts_with("PF ") ||
           bytes.starts_with("PF\r") || bytes.starts_with("Pf");
}

Result<WarpNodes> read_warp_binary(std::string_view bytes, const WarpScreen& screen) {
    return bytes.starts_with("SGC") ? sgc_nodes(bytes, screen) : pfm_nodes(bytes, screen);
}

}  // namespace nullscope
