#include "compare/ray_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace nullscope {
namespace {

constexpr int kMostSteps = 20;
constexpr double kLongestStep_px = 16.0, kConverged_px = 1e-3;  // how far off the place found may be
// Of the step from pixel to pixel: by how much it may change. Two pixels from a shadow's edge it does by half.
constexpr double kUneven = 0.75;
// What the polynomial of one degree less may have otherwise; half of what is promised (kMotionError_px of the tests). Next to a shadow's edge,
// where images crowd as 1/distance, that is some three pixels from it. What is less exact is not known.
constexpr double kMostDoubt_px = 0.01;
constexpr double kOtherImage = 1.0;  // rad: images of one thing by rays that have swept angles this different are two

bool is_on_sky(const RayPixel& pixel) { return pixel.fate == Fate::kEscaped || pixel.fate == Fate::kOtherSide; }
bool alike(const RayPixel& a, const RayPixel& b) {
    return a.hit == b.hit && (a.hit != 0 || a.fate == b.fate) && std::abs(a.angle - b.angle) < kOtherImage;
}
Vec3 place_of(const RayPixel& pixel) { return pixel.hit == 0 ? pixel.sky : Vec3{pixel.u, pixel.v, pixel.w}; }

struct Sample {
    Vec3 place, along_x, along_y;  // and how it changes by a pixel to the right and downward
    double delay = 0;
    double doubt_px = 0;  // what the polynomial of one degree less has otherwise
};

// Of places in the picture next to a sample: by how many pixels it is to be moved for the place to change by that.
std::array<double, 2> pixels_for(const Sample& at, Vec3 change) {
    const double aa = dot(at.along_x, at.along_x), ab = dot(at.along_x, at.along_y), bb = dot(at.along_y, at.along_y),
                 det = aa * bb - ab * ab, fx = dot(at.along_x, change), fy = dot(at.along_y, change);
    if (!(det > 1e-12 * aa * bb)) return {kNotANumber, kNotANumber};
    return {(bb * fx - ab * fy) / det, (aa * fy - ab * fx) / det};
}

// Lagrange's weights of N points at 0, 1 ... N - 1 for the value at t, and for its derivative.
template <int N>
std::array<std::array<double, 2>, N> lagrange(double t) {
    std::array<std::array<double, 2>, N> weights;
    for (int i = 0; i < N; ++i) {
        double value = 1, slope = 0;
        for (int j = 0; j < N; ++j) {
            if (j == i) continue;
            slope = (slope * (t - j) + value) / (i - j);
            value *= (t - j) / (i - j);
        }
        weights[static_cast<std::size_t>(i)] = {value, slope};
    }
    return weights;
}

// Whether places go on evenly from pixel to pixel. About a rotating hole nothing else tells two images of a thing that touch.
bool goes_on(Vec3 a, Vec3 b, Vec3 c) {
    const double before = length(b - a), behind = length(c - b);
    return length((c - b) - (b - a)) <= kUneven * std::max(before, behind);
}

template <int N>
bool is_one_image(const RayFrame& frame, int ix, int iy) {
    for (int i = 0; i < N; ++i)
        for (int j = 0; j + 2 < N; ++j) {
            const auto along = [&](int k) { return place_of(frame.at(ix + k, iy + i)); };
            const auto down = [&](int k) { return place_of(frame.at(ix + i, iy + k)); };
            if (!goes_on(along(j), along(j + 1), along(j + 2)) || !goes_on(down(j), down(j + 1), down(j + 2)))
                return false;
        }
    return true;
}

// By the N x N pixels from (ix, iy) on; nothing where one of them sees another thing than `like`.
template <int N>
std::optional<Sample> interpolated(const RayFrame& frame, const RayPixel& like, int ix, int iy, double x, double y) {
    if (ix < 0 || iy < 0 || ix + N > frame.width || iy + N > frame.height) return {};
    for (int row = 0; row < N; ++row)
        for (int column = 0; column < N; ++column)
            if (!alike(frame.at(ix + column, iy + row), like)) return {};
    if (!is_one_image<N>(frame, ix, iy)) return {};
    const auto across = lagrange<N>(x - ix), down = lagrange<N>(y - iy);
    Sample s;
    for (std::size_t row = 0; row < N; ++row)
        for (std::size_t column = 0; column < N; ++column) {
            const RayPixel& pixel = frame.at(ix + static_cast<int>(column), iy + static_cast<int>(row));
            const Vec3 place = place_of(pixel);
            s.place = s.place + across[column][0] * down[row][0] * place;
            s.along_x = s.along_x + across[column][1] * down[row][0] * place;
            s.along_y = s.along_y + across[column][0] * down[row][1] * place;
            s.delay += across[column][0] * down[row][0] * pixel.delay;
        }
    return s;
}

// By N x N pixels about (x, y), which lies between them: the cell in their middle, or at a side where their middle sees another thing.
template <int N>
std::optional<Sample> about(const RayFrame& frame, const RayPixel& like, double x, double y) {
    static_assert(N == 3 || N == 4);
    constexpr std::array<int, 3> kFirst = N == 4 ? std::array{-1, -2, 0} : std::array{-1, 0, -1};
    for (std::size_t k = 0; k < (N == 4 ? 9 : 4); ++k) {
        const std::size_t side = N == 4 ? 3 : 2;
        const int ix = static_cast<int>(std::floor(x)) + kFirst[k % side],
                  iy = static_cast<int>(std::floor(y)) + kFirst[k / side];
        std::optional<Sample> found = interpolated<N>(frame, like, ix, iy, x, y);
        if (!found) continue;
        const auto nearer = [](double t) { return 2 * t > N - 1 ? 1 : 0; };
        const auto less = interpolated<N - 1>(frame, like, ix + nearer(x - ix), iy + nearer(y - iy), x, y);
        const auto [dx, dy] = pixels_for(*found, found->place - less->place);
        found->doubt_px = std::hypot(dx, dy);
        return found;
    }
    return {};
}

// Pixels about (x, y) that see the same thing as `like`; x, y in px, pixel centres at whole numbers: the cubic through 4 x 4 of them, beside a
// rim the parabolas through 3 x 3 or, to come closer, lines through 2 x 2, which are continued beyond them.
std::optional<Sample> sample(const RayFrame& frame, const RayPixel& like, double x, double y) {
    if (const auto found = about<4>(frame, like, x, y)) return found;
    if (const auto found = about<3>(frame, like, x, y)) return found;
    const int cx = static_cast<int>(std::floor(x)), cy = static_cast<int>(std::floor(y));
    for (const auto& [dx, dy] :
         {std::array{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}})
        if (auto found = interpolated<2>(frame, like, cx + dx, cy + dy, x, y)) {
            found->doubt_px = kNotANumber;
            return found;
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
                const auto [dx, dy] = pixels_for(*there, off);
                const double far = std::hypot(dx, dy);
                if (!std::isfinite(far)) break;
                if (far < kConverged_px) {
                    if (!(there->doubt_px < kMostDoubt_px)) break;
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
