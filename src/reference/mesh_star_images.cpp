// All images of a point star, whatever the metric: the pixels' grid of the reference's rays, divided along the shadow's
// edge, says in which triangles of directions a star lies; from there Newton's steps on traced rays, until nothing
// moves any more.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "reference/star_images.h"

namespace nullscope::reference {
namespace {

constexpr double kWide = 0.3;          // rad of sky over a cell above which it is divided ...
constexpr double kFinest_px = 0.125;   // ... down to this
constexpr double kWidest = 1.0;        // rad; a cell that still covers more has no image to begin with
constexpr double kOutside = 0.1;       // how far (of its size) beyond a triangle a star is still tried
constexpr double kMeshStep_px = 1e-3;  // of the Jacobian's differences
constexpr double kSettled_px = 1e-7, kStray_px = 2.0, kSame_px = 1e-3;
constexpr int kMostNewtonSteps = 30;

// The star as a sum of three directions: their shares, which all are positive inside.
std::array<double, 3> shares(Vec3 star, Vec3 a, Vec3 b, Vec3 c) {
    const double all = dot(a, cross(b, c));
    return {dot(star, cross(b, c)) / all, dot(a, cross(star, c)) / all, dot(a, cross(b, star)) / all};
}

class MeshStarImages {
public:
    MeshStarImages(const FrameTracer& tracer, const Scene& scene, double margin_px)
        : tracer_(tracer),
          left_(-margin_px),
          top_(-margin_px),
          right_(scene.camera.width + margin_px),
          bottom_(scene.camera.height + margin_px) {
        const int columns = static_cast<int>(std::ceil(right_ - left_)),
                  rows = static_cast<int>(std::ceil(bottom_ - top_));
        std::vector<std::vector<Ray>> grid(static_cast<std::size_t>(rows + 1));
        tbb::parallel_for(0, rows + 1, [&](int j) {
            for (int i = 0; i <= columns; ++i) grid[static_cast<std::size_t>(j)].push_back(ray(left_ + i, top_ + j));
        });
        std::vector<std::vector<Cell>> found(static_cast<std::size_t>(rows));
        tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(rows), [&](std::size_t j) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i)
                add({left_ + static_cast<double>(i),
                     top_ + static_cast<double>(j),
                     1,
                     {grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]}},
                    found[j]);
        });
        for (const auto& row : found) cells_.insert(cells_.end(), row.begin(), row.end());
    }

    std::vector<StarImage> of(Vec3 direction) const {
        constexpr std::array<std::array<std::size_t, 3>, 2> kTriangles = {{{0, 1, 2}, {0, 2, 3}}};
        constexpr std::array<double, 4> kRight{0, 1, 1, 0}, kDown{0, 0, 1, 1};
        std::vector<StarImage> images;
        for (const Cell& cell : cells_) {
            if (dot(direction, cell.corners[0].sky) < 0.3) continue;  // no cell is so wide
            for (const auto& t : kTriangles) {
                const auto part =
                    shares(direction, cell.corners[t[0]].sky, cell.corners[t[1]].sky, cell.corners[t[2]].sky);
                if (!(std::min({part[0], part[1], part[2]}) > -kOutside)) continue;
                const double sum = part[0] + part[1] + part[2];
                StarImage image{cell.x, cell.y, -1, 0, 0};
                for (std::size_t k = 0; k < 3; ++k) {
                    image.x += cell.size * part[k] / sum * kRight[t[k]];
                    image.y += cell.size * part[k] / sum * kDown[t[k]];
                }
                if (!settle(direction, image) ||
                    !(image.x > left_ && image.x < right_ && image.y > top_ && image.y < bottom_))
                    continue;
                const bool known = std::any_of(images.begin(), images.end(), [&](const StarImage& other) {
                    return std::hypot(other.x - image.x, other.y - image.y) < kSame_px;
                });
                if (!known) images.push_back(image);
            }
        }
        return images;
    }

private:
    struct Ray {
        Vec3 sky;
        bool escaped;
    };
    struct Cell {
        double x, y, size;           // px: column, row from the top
        std::array<Ray, 4> corners;  // (0, 0), (1, 0), (1, 1), (0, 1)
    };
    Ray ray(double x, double y) const {
        const RayPtr ray = tracer_.ray(x, y);
        return {ray->end_direction(), ray->fate() == Fate::kEscaped};
    }
    void add(const Cell& cell, std::vector<Cell>& cells) const {
        const auto& c = cell.corners;
        const auto escaped = std::count_if(c.begin(), c.end(), [](const Ray& r) { return r.escaped; });
        if (escaped == 0) return;
        double wide = 0;
        for (std::size_t k = 0; k < 4; ++k)
            wide = std::max(wide, escaped == 4 ? angle_between(c[k].sky, c[(k + 2) % 4].sky) : 0.0);
        if (escaped == 4 && wide < kWide) return cells.push_back(cell);
        const double half = 0.5 * cell.size, x = cell.x, y = cell.y;
        if (half < kFinest_px) {
            if (escaped == 4 && wide < kWidest) cells.push_back(cell);
            return;
        }
        const Ray top = ray(x + half, y), right = ray(x + cell.size, y + half), bottom = ray(x + half, y + cell.size),
                  left = ray(x, y + half), middle = ray(x + half, y + half);
        add({x, y, half, {c[0], top, middle, left}}, cells);
        add({x + half, y, half, {top, c[1], right, middle}}, cells);
        add({x + half, y + half, half, {middle, right, c[2], bottom}}, cells);
        add({x, y + half, half, {left, middle, bottom, c[3]}}, cells);
    }
    bool settle(Vec3 direction, StarImage& image) const {
        const double from_x = image.x, from_y = image.y;
        for (int step = 0; step < kMostNewtonSteps; ++step) {
            const double x = image.x, y = image.y;
            const RayPtr here = tracer_.ray(x, y);
            const Ray w = ray(x - kMeshStep_px, y), e = ray(x + kMeshStep_px, y), n = ray(x, y - kMeshStep_px),
                      s = ray(x, y + kMeshStep_px);
            if (here->fate() != Fate::kEscaped || !w.escaped || !e.escaped || !n.escaped || !s.escaped) return false;
            const Vec3 by_x = (e.sky - w.sky) / (2 * kMeshStep_px), by_y = (s.sky - n.sky) / (2 * kMeshStep_px),
                       normal = cross(by_x, by_y);
            const double area2 = dot(normal, normal);
            if (!(area2 > 0)) return false;
            const Vec3 off = direction - here->end_direction();  // off = dx by_x + dy by_y + something along the normal
            double dx = dot(normal, cross(off, by_y)) / area2, dy = dot(normal, cross(by_x, off)) / area2;
            const double most = std::max(std::abs(dx), std::abs(dy));
            if (most > 0.5) dx *= 0.5 / most, dy *= 0.5 / most;
            image.x += dx, image.y += dy;
            if (std::hypot(image.x - from_x, image.y - from_y) > kStray_px) return false;
            if (most > kSettled_px) continue;
            image.solid_angle = std::sqrt(area2);
            image.g = here->g;
            return true;
        }
        return false;
    }

    const FrameTracer& tracer_;
    double left_, top_, right_, bottom_;
    std::vector<Cell> cells_;
};

}  // namespace

std::function<std::vector<StarImage>(Vec3)> images_by_mesh(const FrameTracer& tracer, const Scene& scene,
                                                           double margin_px) {
    return
        [images = std::make_shared<MeshStarImages>(tracer, scene, margin_px)](Vec3 star) { return images->of(star); };
}

}  // namespace nullscope::reference
