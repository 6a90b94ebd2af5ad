#include "scene/warp_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "base/file_cache.h"
#include "scene/pixel_mesh.h"
#include "scene/projection.h"

namespace nullscope {
namespace {

constexpr std::size_t kLargestMeshFile = 128u << 20;
constexpr double kWidestShare = 1e3;                      // where no cell is drawn
constexpr double kWidestScreen = 16.0;                    // half heights: places beyond it have no bins of their own
constexpr int kMostCellsInBin = 4096, kMostEntries = 16;  // the second: of all bins, for each cell and bin

struct Point {
    double x, y;
};
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

WarpNode mean(const WarpNode& a, const WarpNode& b, const WarpNode& c, const WarpNode& d) {
    return {0.25 * (a.x + b.x + c.x + d.x), 0.25 * (a.y + b.y + c.y + d.y), 0.25 * (a.u + b.u + c.u + d.u),
            0.25 * (a.v + b.v + c.v + d.v), 0.25 * (a.light + b.light + c.light + d.light)};
}

Point screen(const WarpNode& node) { return {node.x, node.y}; }
Point picture(const WarpNode& node) { return {node.u, node.v}; }

// The triangles of a cell, its middle first, until f returns true.
template <class F>
bool any_triangle(const std::vector<WarpNode>& nodes, const std::array<int, 4>& cell, F f) {
    std::array<WarpNode, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = nodes[static_cast<std::size_t>(cell[k])];
    const WarpNode middle = mean(corners[0], corners[1], corners[2], corners[3]);
    for (std::size_t k = 0; k < 4; ++k)
        if (f(middle, corners[k], corners[(k + 1) % 4])) return true;
    return false;
}

// Weights of b and c where `at` is within the triangle, of which `of` says the places.
std::optional<Point> within(Point at, const WarpNode& a, const WarpNode& b, const WarpNode& c,
                            Point (*of)(const WarpNode&)) {
    constexpr double kRounding = 1e-9;
    const Point p = of(b) - of(a), q = of(c) - of(a), r = at - of(a);
    const double area = cross(p, q);
    if (area == 0.0) return std::nullopt;
    const Point weight{cross(r, q) / area, cross(p, r) / area};
    const bool inside = weight.x >= -kRounding && weight.y >= -kRounding && weight.x + weight.y <= 1.0 + kRounding;
    return inside ? std::optional(weight) : std::nullopt;
}

// Number of the bin along an axis, which may be none of them.
int bin_of(double at, double low, double high, int count) {
    return static_cast<int>(std::floor(std::clamp((at - low) / (high - low), -1.0, 2.0) * count));
}

Result<CellBins> bins_of(const std::vector<WarpNode>& nodes, const std::vector<std::array<int, 4>>& cells, int columns,
                         int rows, Point (*of)(const WarpNode&), Point most) {
    CellBins bins{1e30, 1e30, -1e30, -1e30, columns, rows, {}, {}};
    for (const auto& cell : cells)
        for (const int node : cell) {
            const Point at = of(nodes[static_cast<std::size_t>(node)]);
            bins.left = std::min(bins.left, std::clamp(at.x, -most.x, most.x));
            bins.right = std::max(bins.right, std::clamp(at.x, -most.x, most.x));
            bins.bottom = std::min(bins.bottom, std::clamp(at.y, -most.y, most.y));
            bins.top = std::max(bins.top, std::clamp(at.y, -most.y, most.y));
        }
    constexpr double kLeast = 1e-6;  // a rim, so that all that is inside is so by more than rounding
    bins.left -= kLeast, bins.bottom -= kLeast, bins.right += kLeast, bins.top += kLeast;
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                      most_entries = kMostEntries * (count + cells.size());
    // Twice over all cells: how many each bin has, and which.
    const auto each = [&](auto f) {
        for (std::size_t number = 0; number < cells.size(); ++number) {
            Point low{1e30, 1e30}, high{-1e30, -1e30};
            for (const int node : cells[number]) {
                const Point at = of(nodes[static_cast<std::size_t>(node)]);
                low = {std::min(low.x, at.x - kLeast), std::min(low.y, at.y - kLeast)};
                high = {std::max(high.x, at.x + kLeast), std::max(high.y, at.y + kLeast)};
            }
            const int from_x = std::max(bin_of(low.x, bins.left, bins.right, columns), 0),
                      to_x = std::min(bin_of(high.x, bins.left, bins.right, columns), columns - 1),
                      from_y = std::max(bin_of(low.y, bins.bottom, bins.top, rows), 0),
                      to_y = std::min(bin_of(high.y, bins.bottom, bins.top, rows), rows - 1);
            for (int y = from_y; y <= to_y; ++y)
                for (int x = from_x; x <= to_x; ++x)
                    if (!f(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                               static_cast<std::size_t>(x),
                           static_cast<int>(number)))
                        return false;
        }
        return true;
    };
    std::vector<int> counts(count);
    std::size_t entries = 0;
    if (!each([&](std::size_t bin, int) { return ++entries <= most_entries && ++counts[bin] <= kMostCellsInBin; }))
        return bad_input("too many mesh cells overlap at one point",
                         fmt::format("at most {} at one place", kMostCellsInBin));
    bins.first.assign(count + 1, 0);
    for (std::size_t bin = 0; bin < count; ++bin) bins.first[bin + 1] = bins.first[bin] + counts[bin];
    bins.cells.resize(entries);
    std::vector<int> next(bins.first.begin(), bins.first.end() - 1);
    each([&](std::size_t bin, int cell) {
        bins.cells[static_cast<std::size_t>(next[bin]++)] = cell;
        return true;
    });
    return bins;
}

// Of the cells at a place the last for which f returns something.
template <class F>
auto last_of(const CellBins& bins, Point at, F f) -> decltype(f(0)) {
    if (bins.first.empty()) return std::nullopt;
    const int x = bin_of(at.x, bins.left, bins.right, bins.columns), y = bin_of(at.y, bins.bottom, bins.top, bins.rows);
    if (x < 0 || y < 0 || x >= bins.columns || y >= bins.rows) return std::nullopt;
    const auto bin = static_cast<std::size_t>(y) * static_cast<std::size_t>(bins.columns) + static_cast<std::size_t>(x);
    for (int i = bins.first[bin + 1]; i-- > bins.first[bin];)
        if (const auto found = f(bins.cells[static_cast<std::size_t>(i)])) return found;
    return std::nullopt;
}

}  // namespace

Result<WarpMesh> WarpMesh::parse(std::string_view text, const std::string& name, const WarpScreen& screen) {
    TRY(read, read_warp_nodes(text, name, screen));
    WarpMesh mesh;
    mesh.columns_ = read->columns, mesh.rows_ = read->rows, mesh.of_screen_ = read->of_screen;
    mesh.nodes_ = std::move(read->nodes);
    const int joined = read->joined ? mesh.columns_ : mesh.columns_ - 1;
    for (int row = 0; row + 1 < mesh.rows_; ++row)
        for (int column = 0; column < joined; ++column) {
            const int next = (column + 1) % mesh.columns_, start = row * mesh.columns_, above = start + mesh.columns_;
            const std::array cell{start + column, start + next, above + next, above + column};
            if (std::ranges::all_of(cell,
                                    [&](int node) { return mesh.nodes_[static_cast<std::size_t>(node)].light >= 0; }))
                mesh.cells_.push_back(cell);
        }
    if (Status found = mesh.find_bins(); !found) {
        Error error = found.error();
        error.file = name;
        return error;
    }
    mesh.find_least_area();
    return mesh;
}

Status WarpMesh::find_bins() {
    if (cells_.empty()) return Done{};  // nothing is drawn
    TRY(on_screen, bins_of(nodes_, cells_, columns_, rows_, screen, {kWidestScreen, 1.0}));
    TRY(in_picture, bins_of(nodes_, cells_, columns_, rows_, picture, {2.0, 2.0}));
    bins_ = std::move(*on_screen), bins_of_picture_ = std::move(*in_picture);
    return Done{};
}

std::optional<WarpPlace> WarpMesh::at(double x, double y) const {
    return last_of(bins_, {x, y}, [&](int cell) {
        std::optional<WarpPlace> place;
        any_triangle(
            nodes_, cells_[static_cast<std::size_t>(cell)],
            [&](const WarpNode& a, const WarpNode& b, const WarpNode& c) {
                const auto weight = within({x, y}, a, b, c, screen);
                if (!weight) return false;
                const Point p = screen(b) - screen(a), q = screen(c) - screen(a);
                const double area = cross(p, q);
                const auto mixed = [&](double WarpNode::*part) {
                    return a.*part + weight->x * (b.*part - a.*part) + weight->y * (c.*part - a.*part);
                };
                const auto slopes = [&](double WarpNode::*part) {
                    const double along = b.*part - a.*part, across = c.*part - a.*part;
                    return Point{(along * q.y - across * p.y) / area, (across * p.x - along * q.x) / area};
                };
                const Point du = slopes(&WarpNode::u), dv = slopes(&WarpNode::v);
                place = WarpPlace{
                    mixed(&WarpNode::u), mixed(&WarpNode::v), mixed(&WarpNode::light), {du.x, du.y, dv.x, dv.y}};
                return true;
            });
        return place;
    });
}

std::optional<std::array<double, 2>> WarpMesh::place_of(double u, double v) const {
    return last_of(bins_of_picture_, {u, v}, [&](int cell) {
        std::optional<std::array<double, 2>> place;
        any_triangle(nodes_, cells_[static_cast<std::size_t>(cell)],
                     [&](const WarpNode& a, const WarpNode& b, const WarpNode& c) {
                         const auto weight = within({u, v}, a, b, c, picture);
                         if (weight)
                             place = {a.x + weight->x * (b.x - a.x) + weight->y * (c.x - a.x),
                                      a.y + weight->x * (b.y - a.y) + weight->y * (c.y - a.y)};
                         return weight.has_value();
                     });
        return place;
    });
}

void WarpMesh::find_least_area() {
    for (const auto& cell : cells_)
        any_triangle(nodes_, cell, [&](const WarpNode& a, const WarpNode& b, const WarpNode& c) {
            const double on_screen = cross(screen(b) - screen(a), screen(c) - screen(a)),
                         there = cross(picture(b) - picture(a), picture(c) - picture(a));
            if (on_screen != 0.0) least_area_ = std::min(least_area_, std::fabs(there / on_screen));
            return false;
        });
}

std::array<double, 2> input_half(const CameraSpec& camera) {
    const double aspect = camera.whole_width() * camera.pixel_aspect / camera.whole_height();
    const ProjectionRow& row = projection_of(camera);
    if (row.circle) return {std::min(aspect, 1.0), std::min(aspect, 1.0)};
    return {aspect, row.mesh_aspect > 0.0 ? aspect / row.mesh_aspect : 1.0};
}

namespace {

FileCache<WarpMesh> loaded(16, kLargestMeshFile);
std::atomic<int> loads = 0;  // grows when one is read

// Of files that tell of places in shares of a screen: for this one.
FileCache<WarpMesh>& loaded_for(const WarpScreen& screen) {
    constexpr std::size_t kMostScreens = 8;
    static std::mutex mutex;
    static std::map<WarpScreen, std::shared_ptr<FileCache<WarpMesh>>> screens;
    thread_local std::shared_ptr<FileCache<WarpMesh>> found;  // outlives the list's
    const std::lock_guard lock(mutex);
    if (screens.size() >= kMostScreens && !screens.contains(screen)) screens.clear();
    auto& cache = screens[screen];
    if (!cache) cache = std::make_shared<FileCache<WarpMesh>>(4, kLargestMeshFile);
    return *(found = cache);
}

WarpScreen screen_of(const CameraSpec& camera) {
    return {camera.whole_width(), camera.whole_height(), camera.pixel_aspect};
}

// For rays, of which there are many: the file is not looked at again.
const WarpMesh* mesh_of(const CameraSpec& camera) {
    thread_local std::filesystem::path::string_type path;
    thread_local WarpScreen screen;
    thread_local std::shared_ptr<const WarpMesh> mesh;
    thread_local int known = -1;
    if (known == loads && path == camera.warp.native() && screen == screen_of(camera)) return mesh.get();
    known = loads, path = camera.warp.native(), screen = screen_of(camera);
    mesh = held_mesh(camera.warp);
    if (mesh) return mesh.get();
    mesh = loaded.known(camera.warp);
    if (mesh && mesh->of_screen()) mesh = loaded_for(screen).known(camera.warp);
    if (!mesh)
        if (const auto read = load_warp_mesh(camera)) mesh = *read, known = loads;
    return mesh.get();
}

// In half heights of the screen from its middle, right and up.
Point on_screen(const CameraSpec& camera, double x, double y) {
    const double half = 0.5 * camera.whole_height();
    if (camera.part) x += camera.part->left, y += camera.part->top;
    return {(x - 0.5 * camera.whole_width()) * camera.pixel_aspect / half, 1.0 - y / half};
}

}  // namespace

Result<std::shared_ptr<const WarpMesh>> load_warp_mesh(const std::filesystem::path& file, const WarpScreen& screen) {
    const auto parse = [&](std::string_view text, const std::string& name) {
        return WarpMesh::parse(text, name, screen);
    };
    bool fresh = false, fresh_for = false;
    auto mesh = loaded.get(file, parse, &fresh);
    if (mesh && (*mesh)->of_screen()) mesh = loaded_for(screen).get(file, parse, &fresh_for);
    if (fresh || fresh_for) ++loads;
    return mesh;
}

Result<std::shared_ptr<const WarpMesh>> load_warp_mesh(const CameraSpec& camera) {
    if (auto held = held_mesh(camera.warp)) return held;
    return load_warp_mesh(camera.warp, screen_of(camera));
}

std::optional<WarpedPlace> warped_place(const CameraSpec& camera, double x, double y) {
    const WarpMesh* mesh = mesh_of(camera);
    if (mesh == nullptr) return std::nullopt;
    const auto [half_x, half_y] = input_half(camera);
    const Point at = on_screen(camera, x, y);
    const auto place = mesh->at(at.x, at.y);
    const bool beside = !place || place->u < 0.0 || place->u > 1.0 || place->v < 0.0 || place->v > 1.0;
    if (beside && !(place && mesh->of_points())) return std::nullopt;
    const double half_px = 0.5 * camera.whole_height(),
                 area = place->slopes[0] * place->slopes[3] - place->slopes[1] * place->slopes[2];
    return WarpedPlace{{(2 * place->u - 1) * half_x * half_px, (2 * place->v - 1) * half_y * half_px},
                       place->light,
                       mesh->of_points() ? 0.0 : std::sqrt(4 * half_x * half_y * std::fabs(area))};
}

std::optional<std::array<double, 2>> unwarped_place(const CameraSpec& camera, std::array<double, 2> at) {
    const WarpMesh* mesh = mesh_of(camera);
    if (mesh == nullptr) return std::nullopt;
    const auto [half_x, half_y] = input_half(camera);
    const double half_px = 0.5 * camera.whole_height();
    const double u = 0.5 * (at[0] / (half_x * half_px) + 1), v = 0.5 * (at[1] / (half_y * half_px) + 1);
    if (!(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0)) return std::nullopt;
    const auto place = mesh->place_of(u, v);
    if (!place) return std::nullopt;
    const double left = camera.part ? camera.part->left : 0, top = camera.part ? camera.part->top : 0;
    return std::array{(*place)[0] * half_px / camera.pixel_aspect + 0.5 * camera.whole_width() - left,
                      (1.0 - (*place)[1]) * half_px - top};
}

double smallest_warp_share(const CameraSpec& camera) {
    if (camera.warp.empty()) return 1.0;
    const WarpMesh* mesh = mesh_of(camera);
    const auto [half_x, half_y] = input_half(camera);
    if (mesh == nullptr) return 1.0;
    return std::clamp(std::sqrt(4 * half_x * half_y * mesh->least_area()), kNarrowestShare, kWidestShare);
}

double warp_light(const CameraSpec& camera, double x, double y) {
    if (camera.warp.empty()) return 1.0;
    const auto place = warped_place(camera, x, y);
    if (!place) return 0.0;
    const double light = std::max(place->light, 0.0);
    return camera.warp_intensity == WarpIntensity::kDisplay ? std::pow(light, kDisplayPower) : light;
}

}  // namespace nullscope
