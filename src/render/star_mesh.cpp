#include "render/star_mesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "render/star_cell.h"
#include "scene/projection.h"
#include "scene/warp_mesh.h"

namespace nullscope {
namespace {

using namespace mesh;

constexpr double kPartPerOctave = 2.0;  // how fast StarGlow::part changes, at most
// rad of sky in a cell above which it is divided: interpolation over it is off by more than 0.01 px.
constexpr double kWide = 0.15;
// The same, of how far a cell's middle may be from the mean of its corners, over its extent.
constexpr double kBentMesh = 0.05;
constexpr double kWidest = 0.5;        // rad from its middle up to which it is asked which stars are in it ...
constexpr double kWidestFinest = 1.0;  // ... where it is not divided any more; what covers more holds no images
// Triangles are taken so much larger (of their heights), lest a star falls between those of cells of two sizes: what is found twice
// comes out at one place.
constexpr double kOver = 0.01, kOverDivided = 0.1, kOverFinest = 0.3;
// Of the differences between rays, over the cell, where it is not smooth enough to interpolate.
constexpr double kStep = 0.01;
constexpr double kSame_px = 0.05;
// The area of an image is at least this part of its triangle's; within a cell that is to be divided of the cell's.
constexpr double kLeastArea = 0.7, kLeastAreaDivided = 0.4;
// Of log2 of an image's area over its triangle's: beyond it, next to where images merge, the slopes are rays'.
constexpr double kUneven = 0.1;
constexpr int kNewton = 8;
constexpr double kFound = 3e-3,
                 kStray = 2.0;  // a step that ends them, and how far outside of the cell they may lead; of its size

bool is_coarse(const Cell& cell, Vec3 middle) {
    const auto& c = cell.corners;
    const Vec3 mean = 0.25 * (c[0].sky + c[1].sky + c[2].sky + c[3].sky);
    const double across = extent(cell);
    return across > kWide || length(middle - mean) > kBentMesh * across;
}

}  // namespace

// One call of images(): the mesh's nodes, and what is found in a row of cells.
class MeshWalk {
    using Star = StarGrid::Star;
    using Known = std::unordered_map<long long, Node>;  // of a row's cells that are divided

public:
    MeshWalk(const StarGrid& stars, const CoreInput& input, const MeshArea& area, const StarMesh::Seeing& seeing,
             const std::function<bool()>& give_up)
        : stars_(stars),
          input_(input),
          seeing_(seeing),
          area_(area),
          pitch_(std::max(1.0, std::sqrt((area.right - area.left) * (area.top - area.bottom) /
                                         (seeing.quick ? kQuickCells : kMeshCells)))),
          columns_(static_cast<int>(std::ceil((area.right - area.left) / pitch_))),
          rows_(static_cast<int>(std::ceil((area.top - area.bottom) / pitch_))),
          nodes_(static_cast<std::size_t>((columns_ + 3) * (rows_ + 3))) {
        tbb::parallel_for(-1, rows_ + 2, [&](int j) {
            if (give_up()) return;
            for (int i = -1; i <= columns_ + 1; ++i) nodes_[number(i, j)] = traced(x_of(i), y_of(j));
        });
    }

    int rows() const { return rows_; }

    void row(int j, std::vector<MeshImage>& found) const {
        Known known;
        for (int i = 0; i < columns_; ++i) {
            const Cell cell{x_of(i), y_of(j), pitch_, {node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)}};
            std::array<std::array<Node, 4>, 4> nodes;
            bool whole = true;
            for (int n = 0; n < 16; ++n) {
                Node& one = nodes[static_cast<std::size_t>(n / 4)][static_cast<std::size_t>(n % 4)];
                one = node(i - 1 + n % 4, j - 1 + n / 4);
                whole = whole && one.there;
            }
            const auto smooth = [&](double x, double y) { return interpolated(nodes, cell, x, y); };
            const bool fine =
                whole && (seeing_.quick ? cap_of(cell).radius < kWidest
                                        : !is_coarse(cell, smooth(cell.x + 0.5 * pitch_, cell.y + 0.5 * pitch_).sky));
            if (!fine && !seeing_.quick) divided(cell, nullptr, known, found);
            if (fine)
                for (const Star& one : candidates(cell, kLeastArea))
                    find(
                        cell, one, kOver, [&] { return smooth; }, found);
        }
    }

private:
    double x_of(int i) const { return area_.left + i * pitch_; }
    double y_of(int j) const { return area_.bottom + j * pitch_; }
    std::size_t number(int i, int j) const {
        return static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(columns_ + 3) +
               static_cast<std::size_t>(i + 1);
    }
    const Node& node(int i, int j) const { return nodes_[number(i, j)]; }

    Node traced(double x, double y) const {
        const RayPixel ray = trace_core64(input_, x, y);
        return {ray.sky, ray.g, ray.fate == Fate::kEscaped};
    }

    // At a corner, side or middle of a divided cell: traced once a row of the mesh.
    Node cached(double x, double y, Known& known) const {
        const double unit = 0.5 * kMeshFinest * pitch_;
        const long long key = (std::llround((y - area_.bottom) / unit) << 32) + std::llround((x - area_.left) / unit);
        const auto [at, is_new] = known.try_emplace(key);
        if (is_new) at->second = traced(x, y);
        return at->second;
    }

    // By rays `step` px to either side; without slopes where one of them does not reach the sky.
    Local differenced(double x, double y, double step) const {
        const Node here = traced(x, y), left = traced(x - step, y), right = traced(x + step, y),
                   below = traced(x, y - step), above = traced(x, y + step);
        if (!here.there || !left.there || !right.there || !below.there || !above.there) return {};
        return {here.sky, (right.sky - left.sky) / (2 * step), (above.sky - below.sky) / (2 * step), here.g};
    }

    // By this area of sky, sr/px^2.
    bool seen(int star, double area, double g) const {
        const double light = stars_.light(star).light, own = stars_.light(star).temperature,
                     shifted = own + std::log2(std::max(g, 1e-9));
        const StarGlow& glow = stars_.glow();
        return light + glow.brightness(seeing_.beaming ? shifted : own) + glow.part(seeing_.shift ? shifted : own) -
                   std::log2(area) >
               seeing_.magnitude_limit;
    }

    // The stars near a cell's sky that could be seen in it; least: of the cell's area over what an image's can be.
    std::vector<Star> candidates(const Cell& cell, double least) const {
        std::vector<Star> list;
        const Cap cap = cap_of(cell);
        const auto [area, g] = bounds(cell, least);
        const Box box(cell);
        const double other =
            seeing_.shift ? std::min(kPartPerOctave * std::fabs(std::log2(g)), StarGlow::kMostPart) : 0.0;
        for (const StarGrid::Level& level : stars_.levels()) {
            const double bluer = seeing_.beaming && g > 1 ? stars_.glow().brightness(level.coldest + std::log2(g)) -
                                                                stars_.glow().brightness(level.coldest)
                                                          : 0.0;
            if (level.brightest + bluer + other - std::log2(area) < seeing_.magnitude_limit) break;
            StarGrid::visit_near(
                level, cap.middle, (1 + 4 * kOverDivided) * cap.radius, [&, area = area, g = g](const Star& one) {
                    if (box.has(one.place) && dot(one.place, cap.middle) > 0 && seen(one.number, area, g))
                        list.push_back(one);
                });
        }
        return list;
    }

    std::pair<double, double> bounds(const Cell& cell, double least) const {
        const auto& c = cell.corners;
        const double twice = std::min(length(cross(c[1].sky - c[0].sky, c[3].sky - c[0].sky)),
                                      length(cross(c[2].sky - c[0].sky, c[3].sky - c[0].sky)));
        return {std::max(least * twice / (cell.size * cell.size), 1e-30), std::max({c[0].g, c[1].g, c[2].g, c[3].g})};
    }

    // within: the stars that could be in it; nullptr: not known.
    void divided(const Cell& cell, const std::vector<Star>* within, Known& known, std::vector<MeshImage>& found) const {
        const int there = cell.there();
        const double half = 0.5 * cell.size;
        const bool finest = cell.size < 1.5 * kMeshFinest * pitch_;
        std::vector<Star> list;
        const bool narrow = there == 4 && cap_of(cell).radius < (finest ? kWidestFinest : kWidest);
        if (finest && !narrow) return;
        if (narrow) {
            list = within == nullptr ? candidates(cell, kLeastAreaDivided) : kept(cell, *within);
            if (list.empty()) return;
        }
        const Node middle = cached(cell.x + half, cell.y + half, known);
        if (there == 0 && !middle.there) return;
        const bool split = !finest && (!narrow || !middle.there || is_coarse(cell, middle.sky));
        if (!split && !middle.there) return;
        const auto& c = cell.corners;
        const auto side = [&](double x, double y) { return cached(cell.x + x * half, cell.y + y * half, known); };
        if (!split) {
            const auto by_rays = [&](double x, double y) { return differenced(x, y, kStep * cell.size); };
            if (is_coarse(cell, middle.sky)) {
                for (const Star& one : list)
                    find(
                        cell, one, kOverFinest, [&] { return by_rays; }, found);
                return;
            }
            std::optional<std::array<std::array<Node, 3>, 3>> nodes;
            const auto map = [&] {
                if (!nodes)
                    nodes = {{{c[0], side(1, 0), c[1]}, {side(0, 1), middle, side(2, 1)}, {c[2], side(1, 2), c[3]}}};
                return [&](double x, double y) { return interpolated(*nodes, cell, x, y); };
            };
            for (const Star& one : list) find(cell, one, kOverDivided, map, found);
            return;
        }
        const Node left = side(0, 1), right = side(2, 1), below = side(1, 0), above = side(1, 2);
        const std::vector<Star>* inner = narrow && middle.there ? &list : nullptr;
        divided({cell.x, cell.y, half, {c[0], below, left, middle}}, inner, known, found);
        divided({cell.x + half, cell.y, half, {below, c[1], middle, right}}, inner, known, found);
        divided({cell.x, cell.y + half, half, {left, middle, c[2], above}}, inner, known, found);
        divided({cell.x + half, cell.y + half, half, {middle, right, above, c[3]}}, inner, known, found);
    }

    std::vector<Star> kept(const Cell& cell, const std::vector<Star>& all) const {
        const Box box(cell);
        const auto [area, g] = bounds(cell, kLeastAreaDivided);
        std::vector<Star> list;
        for (const Star& one : all) {
            if (box.has(one.place) && seen(one.number, area, g)) list.push_back(one);
        }
        return list;
    }

    // map(): what gives the sky at a place in the cell; asked for where a star is in the cell.
    template <class MakeMap>
    void find(const Cell& cell, const Star& one, double over, const MakeMap& map, std::vector<MeshImage>& found) const {
        const auto& c = cell.corners;
        constexpr std::array<std::array<std::size_t, 3>, 2> kTriangles = {{{0, 1, 3}, {0, 3, 2}}};
        for (const auto& t : kTriangles) {
            const Node &p = c[t[0]], &q = c[t[1]], &r = c[t[2]];
            const double u = edge(q.sky, r.sky, one.place), v = edge(r.sky, p.sky, one.place),
                         w = edge(p.sky, q.sky, one.place), all = u + v + w;
            if (!(std::min({u * all, v * all, w * all}) >= -over * all * all) || all == 0) continue;
            const std::array<double, 3> by{u / all, v / all, w / all};
            MeshImage image{cell.x, cell.y, by[0] * p.g + by[1] * q.g + by[2] * r.g,
                            std::fabs(all) / (cell.size * cell.size), one.number};
            if (!seen(one.number, kLeastArea * image.area, image.g)) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                if (t[k] % 2 == 1) image.x += by[k] * cell.size;
                if (t[k] >= 2) image.y += by[k] * cell.size;
            }
            const bool inside = std::min({by[0], by[1], by[2]}) >= 0;
            const auto by_rays = [&](double x, double y) { return differenced(x, y, kStep * cell.size); };
            const bool met = refined(image, one.place, cell, map());
            const double outside = away(image, cell);
            const double uneven = std::fabs(std::log2(image.area * cell.size * cell.size / std::fabs(all)));
            if (!seeing_.quick && ((outside > over && inside) || uneven > kUneven))
                refined(image, one.place, cell, by_rays);
            if (met ? inside || outside <= over : inside && over == kOver) add(image, found);
        }
    }

    void add(const MeshImage& image, std::vector<MeshImage>& found) const {
        if (image.x > area_.left && image.x < area_.right && image.y > area_.bottom && image.y < area_.top &&
            seen(image.star, image.area, image.g))
            found.push_back(image);
    }

    // How far outside of the cell it is, over the cell's size.
    static double away(const MeshImage& image, const Cell& cell) {
        return std::max(std::fabs(image.x - cell.x - 0.5 * cell.size), std::fabs(image.y - cell.y - 0.5 * cell.size)) /
                   cell.size -
               0.5;
    }

    // Newton's steps to where the map has the star, none longer than the cell. False: they lead nowhere near; the image is left as it is.
    template <class Map>
    static bool refined(MeshImage& image, Vec3 star, const Cell& cell, const Map& map) {
        MeshImage at = image;
        for (int step = 0; step < kNewton; ++step) {
            const Local here = map(at.x, at.y);
            const Vec3 off = star - here.sky;
            const double xx = dot(here.by_x, here.by_x), xy = dot(here.by_x, here.by_y), yy = dot(here.by_y, here.by_y),
                         det = xx * yy - xy * xy;
            const double ox = dot(here.by_x, off), oy = dot(here.by_y, off), dx = (yy * ox - xy * oy) / det,
                         dy = (xx * oy - xy * ox) / det;
            const double most = std::max(std::fabs(dx), std::fabs(dy)),
                         part = most > cell.size ? cell.size / most : 1.0;
            at.x += part * dx, at.y += part * dy;
            if (!(away(at, cell) < kStray)) return false;
            if (most > kFound * cell.size) continue;
            at.g = here.g, at.area = length(cross(here.by_x, here.by_y));
            if (!(at.area > 0)) return false;
            image = at;
            return true;
        }
        return false;
    }

    const StarGrid& stars_;
    const CoreInput& input_;
    const StarMesh::Seeing& seeing_;
    MeshArea area_;
    double pitch_;
    int columns_, rows_;
    std::vector<Node> nodes_;
};

MeshArea mesh_area(const CameraSpec& camera, double margin_px) {
    const auto [x, y] = line_of_sight(camera);
    const auto [left, top] = camera.part ? std::array{camera.part->left, camera.part->top} : std::array{0, 0};
    const double right = (left + x) * camera.pixel_aspect, down = top + y;
    // With a warp mesh the projection's own picture, which may be higher than the screen, and never wider.
    if (!camera.warp.empty()) margin_px += std::max(0.5 * camera.whole_height() * (input_half(camera)[1] - 1.0), 0.0);
    return {-right - margin_px, camera.whole_width() * camera.pixel_aspect - right + margin_px,
            down - camera.whole_height() - margin_px, down + margin_px};
}

std::vector<MeshImage> StarMesh::images(const CoreInput& input, const MeshArea& area, const Seeing& seeing,
                                        const std::function<bool()>& give_up) const {
    std::vector<MeshImage> all;
    if (stars_.levels().empty()) return all;
    const MeshWalk walk(stars_, input, area, seeing, give_up);
    std::vector<std::vector<MeshImage>> rows(static_cast<std::size_t>(walk.rows()));
    tbb::parallel_for(0, walk.rows(), [&](int j) {
        if (!give_up()) walk.row(j, rows[static_cast<std::size_t>(j)]);
    });
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    std::stable_sort(all.begin(), all.end(), [](const MeshImage& a, const MeshImage& b) { return a.star < b.star; });
    std::vector<MeshImage> kept;
    std::size_t first = 0;  // in kept, of this star
    for (const MeshImage& image : all) {
        if (!kept.empty() && kept.back().star != image.star) first = kept.size();
        const bool known = std::any_of(
            kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end(),
            [&](const MeshImage& other) { return std::hypot(other.x - image.x, other.y - image.y) < kSame_px; });
        if (!known) kept.push_back(image);
    }
    return kept;
}

}  // namespace nullscope
