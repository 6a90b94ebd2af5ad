#include "render/star_mesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kStarsPerCell = 2.0;   // of the grid of stars
constexpr double kWide = 0.25;          // rad of sky in a cell above which it is divided: cubics over it are off by more than 0.01 px
constexpr double kBent = 0.1;           // the same, of how far a cell's middle may be from the mean of its corners, over its extent
constexpr double kWidest = 0.8;         // rad; a cell that still covers more holds no images
// Triangles are taken so much larger (of their heights), lest a star falls between those of cells of two sizes: what is found twice
// comes out at one place.
constexpr double kOver = 0.01, kOverDivided = 0.1;
constexpr double kSame_px = 0.05;
constexpr int kNewton = 8;
constexpr double kFound_px = 1e-4;

struct Node {
    Vec3 sky;
    double g = 0;
    bool there = false;
};

struct Cell {
    double x, y, size;            // px, lower left corner
    std::array<Node, 4> corners;  // (0, 0), (1, 0), (0, 1), (1, 1)
};

struct Local {
    Vec3 sky, by_x, by_y;
    double g = 0;
    bool there = true;
};

// Lagrange's cubics through -1, 0, 1, 2, and their slopes.
std::array<double, 4> cubic(double t) {
    return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2, (t + 1) * t * (t - 1) / 6};
}
std::array<double, 4> cubic_slope(double t) {
    return {-(3 * t * t - 6 * t + 2) / 6, (3 * t * t - 4 * t - 1) / 2, -(3 * t * t - 2 * t - 2) / 2, (3 * t * t - 1) / 6};
}

double edge(Vec3 a, Vec3 b, Vec3 star) { return dot(cross(a - star, b - star), star); }

}  // namespace

StarMesh::StarMesh(std::vector<Vec3> stars) {
    rows_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(stars.size()) / (2 * kStarsPerCell))), 1, 1024);
    columns_ = 2 * rows_;
    const auto cell_of = [&](Vec3 v) {
        const int row = std::clamp(static_cast<int>(0.5 * (v.z + 1) * rows_), 0, rows_ - 1);
        const int column = std::clamp(static_cast<int>((std::atan2(v.y, v.x) / (2 * M_PI) + 0.5) * columns_), 0, columns_ - 1);
        return static_cast<std::size_t>(row * columns_ + column);
    };
    first_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_) + 1, 0);
    for (const Vec3 star : stars) ++first_[cell_of(star) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    stars_.resize(stars.size());
    numbers_.resize(stars.size());
    std::vector<int> next = first_;
    for (std::size_t i = 0; i < stars.size(); ++i) {
        const auto at = static_cast<std::size_t>(next[cell_of(stars[i])]++);
        stars_[at] = stars[i];
        numbers_[at] = static_cast<int>(i);
    }
}

template <class Visit>
void StarMesh::near(Vec3 middle, double radius, const Visit& visit) const {
    const double theta = std::atan2(std::hypot(middle.x, middle.y), middle.z);
    const double high = std::cos(std::max(theta - radius, 0.0)), low = std::cos(std::min(theta + radius, M_PI));
    const int from = std::clamp(static_cast<int>(0.5 * (low + 1) * rows_), 0, rows_ - 1), to = std::clamp(static_cast<int>(0.5 * (high + 1) * rows_), 0, rows_ - 1);
    const double reach = std::sin(radius), flat = std::sin(theta), turn = reach < flat ? std::asin(reach / flat) : M_PI;
    const double at = (std::atan2(middle.y, middle.x) / (2 * M_PI) + 0.5) * columns_, wide = turn / (2 * M_PI) * columns_;
    const int left = static_cast<int>(std::floor(at - wide)), right = std::min(static_cast<int>(std::floor(at + wide)), left + columns_ - 1);
    for (int row = from; row <= to; ++row)
        for (int column = left; column <= right; ++column) {
            const auto cell = static_cast<std::size_t>(row * columns_ + (column + columns_) % columns_);
            for (int i = first_[cell]; i < first_[cell + 1]; ++i) visit(i);
        }
}

// One call of images(): the mesh's nodes, and what is found in a strip of cells.
class MeshWalk {
public:
    MeshWalk(const StarMesh& mesh, const CoreInput& input, int width, int height, double margin, const StarMesh::Seen& seen)
        : mesh_(mesh), input_(input), seen_(seen), across_(0.5 * width + margin), up_(0.5 * height + margin),
          pitch_(std::max(1.0, std::sqrt(4 * across_ * up_ / kMeshCells))), columns_(static_cast<int>(std::ceil(2 * across_ / pitch_))),
          rows_(static_cast<int>(std::ceil(2 * up_ / pitch_))), nodes_(static_cast<std::size_t>((columns_ + 3) * (rows_ + 3))) {
        tbb::parallel_for(-1, rows_ + 2, [&](int j) {
            for (int i = -1; i <= columns_ + 1; ++i) nodes_[number(i, j)] = traced(x_of(i), y_of(j));
        });
    }

    int rows() const { return rows_; }

    void row(int j, std::vector<MeshImage>& found) const {
        for (int i = 0; i < columns_; ++i) {
            const Cell cell{x_of(i), y_of(j), pitch_, {node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)}};
            std::array<Node, 16> stencil;
            bool whole = true;
            for (int n = 0; n < 16; ++n) {
                stencil[static_cast<std::size_t>(n)] = node(i - 1 + n % 4, j - 1 + n / 4);
                whole = whole && stencil[static_cast<std::size_t>(n)].there;
            }
            if (!whole) {
                divided(cell, found);
                continue;
            }
            const auto smooth = [&](double x, double y) { return interpolated(stencil, (x - cell.x) / pitch_, (y - cell.y) / pitch_); };
            const Local middle = smooth(cell.x + 0.5 * pitch_, cell.y + 0.5 * pitch_);
            if (coarse(cell, middle.sky)) divided(cell, found);
            else stars_in(cell, kOver, smooth, found);
        }
    }

private:
    double x_of(int i) const { return i * pitch_ - across_; }
    double y_of(int j) const { return j * pitch_ - up_; }
    std::size_t number(int i, int j) const { return static_cast<std::size_t>((j + 1) * (columns_ + 3) + i + 1); }
    const Node& node(int i, int j) const { return nodes_[number(i, j)]; }

    Node traced(double x, double y) const {
        const RayPixel ray = trace_core64(input_, x, y);
        return {ray.sky, ray.g, ray.fate == Fate::kEscaped};
    }

    Local interpolated(const std::array<Node, 16>& stencil, double s, double t) const {
        const auto a = cubic(s), b = cubic(t), da = cubic_slope(s), db = cubic_slope(t);
        Local local;
        for (std::size_t n = 0; n < 16; ++n) {
            const std::size_t i = n % 4, j = n / 4;
            const Vec3 sky = stencil[n].sky;
            local.sky = local.sky + a[i] * b[j] * sky;
            local.by_x = local.by_x + da[i] * b[j] / pitch_ * sky;
            local.by_y = local.by_y + a[i] * db[j] / pitch_ * sky;
            local.g += a[i] * b[j] * stencil[n].g;
        }
        return local;
    }

    // By rays `step` px to either side.
    Local differenced(double x, double y, double step) const {
        const Node here = traced(x, y), left = traced(x - step, y), right = traced(x + step, y), below = traced(x, y - step), above = traced(x, y + step);
        return {here.sky, (right.sky - left.sky) / (2 * step), (above.sky - below.sky) / (2 * step), here.g,
                here.there && left.there && right.there && below.there && above.there};
    }

    static double extent(const Cell& cell) {
        const auto& c = cell.corners;
        return std::max(length(c[3].sky - c[0].sky), length(c[2].sky - c[1].sky));
    }

    static bool coarse(const Cell& cell, Vec3 middle) {
        const auto& c = cell.corners;
        const Vec3 mean = 0.25 * (c[0].sky + c[1].sky + c[2].sky + c[3].sky);
        const double across = extent(cell);
        return across > kWide || length(middle - mean) > kBent * across;
    }

    void divided(const Cell& cell, std::vector<MeshImage>& found) const {
        const auto& c = cell.corners;
        const int there = static_cast<int>(std::count_if(c.begin(), c.end(), [](const Node& n) { return n.there; }));
        const double half = 0.5 * cell.size;
        const Node middle = traced(cell.x + half, cell.y + half);
        if (there == 0 && !middle.there) return;
        const bool split = cell.size > 1.5 * kMeshFinest_px && (there < 4 || !middle.there || coarse(cell, middle.sky));
        if (!split) {
            if (there >= 3) stars_in(cell, kOverDivided, [&](double x, double y) { return differenced(x, y, 0.25 * cell.size); }, found);
            return;
        }
        const Node left = traced(cell.x, cell.y + half), right = traced(cell.x + cell.size, cell.y + half);
        const Node below = traced(cell.x + half, cell.y), above = traced(cell.x + half, cell.y + cell.size);
        divided({cell.x, cell.y, half, {c[0], below, left, middle}}, found);
        divided({cell.x + half, cell.y, half, {below, c[1], middle, right}}, found);
        divided({cell.x, cell.y + half, half, {left, middle, c[2], above}}, found);
        divided({cell.x + half, cell.y + half, half, {middle, right, above, c[3]}}, found);
    }

    template <class Map>
    void stars_in(const Cell& cell, double over, const Map& map, std::vector<MeshImage>& found) const {
        const auto& c = cell.corners;
        Vec3 sum;
        for (const Node& n : c)
            if (n.there) sum = sum + n.sky;
        const Vec3 middle = normalized(sum);
        double radius = 0;
        for (const Node& n : c)
            if (n.there) radius = std::max(radius, angle_between(middle, n.sky));
        if (radius > kWidest) return;
        radius *= 1 + 4 * over;
        const double most = 2 * (1 - std::cos(radius));   // of the square of the chord
        constexpr std::array<std::array<std::size_t, 3>, 2> kTriangles = {{{0, 1, 3}, {0, 3, 2}}};
        mesh_.near(middle, radius, [&](int i) {
            const Vec3 star = mesh_.stars_[static_cast<std::size_t>(i)], off = star - middle;
            if (dot(off, off) > most) return;
            for (const auto& t : kTriangles) {
                const Node &p = c[t[0]], &q = c[t[1]], &r = c[t[2]];
                if (!p.there || !q.there || !r.there) continue;
                const double u = edge(q.sky, r.sky, star), v = edge(r.sky, p.sky, star), w = edge(p.sky, q.sky, star), all = u + v + w;
                if (!(std::min({u * all, v * all, w * all}) >= -over * all * all)) continue;
                const double area = std::fabs(all) / (cell.size * cell.size), g = (u * p.g + v * q.g + w * r.g) / all;
                if (!seen_(mesh_.numbers_[static_cast<std::size_t>(i)], 0.25 * area, g)) continue;
                const std::array<double, 3> by{u / all, v / all, w / all};
                MeshImage image{cell.x, cell.y, g, area, mesh_.numbers_[static_cast<std::size_t>(i)]};
                for (std::size_t k = 0; k < 3; ++k) image.x += by[k] * (t[k] % 2 == 1) * cell.size, image.y += by[k] * (t[k] >= 2) * cell.size;
                const bool inside = std::min({by[0], by[1], by[2]}) >= 0;
                if ((refined(image, star, cell, map) || inside) && std::fabs(image.x) < across_ && std::fabs(image.y) < up_) found.push_back(image);
            }
        });
    }

    // Newton's steps to where the map has the star. False: they lead nowhere near; the image is left as it is.
    template <class Map>
    static bool refined(MeshImage& image, Vec3 star, const Cell& cell, const Map& map) {
        double x = image.x, y = image.y;
        for (int step = 0; step < kNewton; ++step) {
            const Local at = map(x, y);
            if (!at.there) return false;
            const Vec3 off = star - at.sky;
            const double xx = dot(at.by_x, at.by_x), xy = dot(at.by_x, at.by_y), yy = dot(at.by_y, at.by_y), det = xx * yy - xy * xy;
            const double ox = dot(at.by_x, off), oy = dot(at.by_y, off), dx = (yy * ox - xy * oy) / det, dy = (xx * oy - xy * ox) / det;
            if (!(std::fabs(dx) + std::fabs(dy) < 2 * cell.size)) return false;
            x += dx, y += dy;
            if (std::max(std::fabs(x - cell.x - 0.5 * cell.size), std::fabs(y - cell.y - 0.5 * cell.size)) > 1.5 * cell.size) return false;
            if (std::fabs(dx) + std::fabs(dy) > kFound_px) continue;
            image.x = x, image.y = y, image.g = at.g, image.area = length(cross(at.by_x, at.by_y));
            return image.area > 0;
        }
        return false;
    }

    const StarMesh& mesh_;
    const CoreInput& input_;
    const StarMesh::Seen& seen_;
    double across_, up_, pitch_;
    int columns_, rows_;
    std::vector<Node> nodes_;
};

std::vector<MeshImage> StarMesh::images(const CoreInput& input, int width, int height, double margin_px, const Seen& seen) const {
    std::vector<MeshImage> all;
    if (stars_.empty()) return all;
    const MeshWalk walk(*this, input, width, height, margin_px, seen);
    std::vector<std::vector<MeshImage>> rows(static_cast<std::size_t>(walk.rows()));
    tbb::parallel_for(0, walk.rows(), [&](int j) { walk.row(j, rows[static_cast<std::size_t>(j)]); });
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    std::stable_sort(all.begin(), all.end(), [](const MeshImage& a, const MeshImage& b) { return a.star < b.star; });
    std::vector<MeshImage> kept;
    std::size_t first = 0;   // in kept, of this star
    for (const MeshImage& image : all) {
        if (!kept.empty() && kept.back().star != image.star) first = kept.size();
        const bool known = std::any_of(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end(), [&](const MeshImage& other) {
            return std::hypot(other.x - image.x, other.y - image.y) < kSame_px;
        });
        if (!known) kept.push_back(image);
    }
    return kept;
}

}  // namespace nullscope
