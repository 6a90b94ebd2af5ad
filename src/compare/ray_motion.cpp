#include "compare/ray_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace nullscope {
namespace {

constexpr int kMostSteps = 20;
constexpr double kLongestStep_px = 16.0, kConverged_px = 1e-3, kLeft_px = 0.05;  // how far off the place found may be
constexpr double kOtherImage = 1.0;  // rad: images of one thing by rays that have swept angles this different are two

bool is_on_sky(const RayPixel& pixel) { return pixel.fate == Fate::kEscaped || pixel.fate == Fate::kOtherSide; }
bool alike(const RayPixel& a, const RayPixel& b) {
    return a.hit == b.hit && (a.hit != 0 || a.fate == b.fate) && std::abs(a.angle - b.angle) < kOtherImage;
}
Vec3 place_of(const RayPixel& pixel) { return pixel.hit == 0 ? pixel.sky : Vec3{pixel.u, pixel.v, pixel.w}; }

struct Sample {
    Vec3 place, along_x, along_y;  // and how it changes by a pixel to the right and downward
    double delay = 0;
};

// Between four pixels that see the same thing as `like`; x, y in px, pixel centres at whole numbers. At a rim the cell is continued beyond them.
std::optional<Sample> sample(const RayFrame& frame, const RayPixel& like, double x, double y) {
    const int cx = static_cast<int>(std::floor(x)), cy = static_cast<int>(std::floor(y));
    for (const auto& [dx, dy] :
         {std::array{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
        const int ix = cx + dx, iy = cy + dy;
        if (ix < 0 || iy < 0 || ix + 1 >= frame.width || iy + 1 >= frame.height) continue;
        const RayPixel *a = &frame.at(ix, iy), *b = &frame.at(ix + 1, iy), *c = &frame.at(ix, iy + 1),
                       *d = &frame.at(ix + 1, iy + 1);
        if (!alike(*a, like) || !alike(*b, like) || !alike(*c, like) || !alike(*d, like)) continue;
        const double u = x - ix, v = y - iy;
        const Vec3 pa = place_of(*a), pb = place_of(*b), pc = place_of(*c), pd = place_of(*d);
        Sample s;
        s.along_x = (1 - v) * (pb - pa) + v * (pd - pc);
        s.along_y = (1 - u) * (pc - pa) + u * (pd - pb);
        s.place = (1 - v) * ((1 - u) * pa + u * pb) + v * ((1 - u) * pc + u * pd);
        s.delay = (1 - v) * ((1 - u) * a->delay + u * b->delay) + v * ((1 - u) * c->delay + u * d->delay);
        return s;
    }
    return {};
}

}  // namespace

RayMotion ray_motion(const RayFrame& now, const RayFrame& next, double time, const MovedPlace& moved) {
    RayMotion motion;
    const std::size_t count = now.pixels.size();
    motion.right.assign(count, 0.0f), motion.up.assign(count, 0.0f), motion.known.assign(count, 0.0f);
    for (int row = 0; row < now.height; ++row)
        for (int column = 0; column < now.width; ++column) {
            const RayPixel& pixel = now.at(column, row);
            if (pixel.hit == kStarHit || (pixel.hit == 0 && !is_on_sky(pixel))) continue;
            double x = column, y = row;
            for (int step = 0; step < kMostSteps; ++step) {
                const auto there = sample(next, pixel, x, y);
                if (!there) break;
                const Vec3 target = pixel.hit == 0 ? pixel.sky : moved(pixel, time - (there->delay - pixel.delay));
                const Vec3 off = target - there->place;
                const double aa = dot(there->along_x, there->along_x), ab = dot(there->along_x, there->along_y),
                             bb = dot(there->along_y, there->along_y), det = aa * bb - ab * ab;
                if (!(det > 1e-12 * aa * bb)) break;
                const double fx = dot(there->along_x, off), fy = dot(there->along_y, off);
                const double dx = (bb * fx - ab * fy) / det, dy = (aa * fy - ab * fx) / det, far = std::hypot(dx, dy);
                if (far < kConverged_px || (step == kMostSteps - 1 && far < kLeft_px)) {
                    const std::size_t i = now.index(column, row);
                    motion.right[i] = static_cast<float>(x + dx - column);
                    motion.up[i] = static_cast<float>(row - y - dy);
                    motion.known[i] = 1.0f;
                    break;
                }
                const double scale = std::min(1.0, kLongestStep_px / far);
                x += scale * dx, y += scale * dy;
            }
        }
    return motion;
}

}  // namespace nullscope
