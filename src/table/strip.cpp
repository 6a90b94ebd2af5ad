#include "table/strip.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

namespace nullscope {
namespace {

constexpr int kCellsPerOctave = 16;  // STRIP_CELLS_PER_OCTAVE
constexpr int kRows = 3;             // STRIP_ROWS

int octaves(const RayFan& fan, Segment segment) {
    return static_cast<int>(std::floor(std::log2(1.0 + fan.w_limit(segment) / fan.w0()))) + 1;
}

// Coefficients of the cubic through the four Chebyshev nodes of [0, 1].
constexpr std::array<double, 4> kNodes = {0.038060233744356625, 0.30865828381745514, 0.6913417161825449, 0.9619397662556434};
std::array<float, 4> cubic_through(const std::array<double, 4>& y) {
    // Newton's divided differences, then expanded to powers of f.
    std::array<double, 4> d = y;
    for (int level = 1; level < 4; ++level)
        for (int i = 3; i >= level; --i) d[i] = (d[i] - d[i - 1]) / (kNodes[i] - kNodes[i - level]);
    std::array<double, 4> c{d[3], 0, 0, 0};  // Horner on polynomials: c = c (f - node) + d
    int degree = 0;
    for (int i = 2; i >= 0; --i) {
        ++degree;
        for (int p = degree; p >= 1; --p) c[p] = c[p - 1] - kNodes[i] * c[p];
        c[0] = d[i] - kNodes[i] * c[0];
    }
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), static_cast<float>(c[3])};
}

}  // namespace

TexelGrid build_strip(const RayFan& fan) {
    const int sky_cells = octaves(fan, Segment::kSky) * kCellsPerOctave;
    const int captured_cells = octaves(fan, Segment::kCaptured) * kCellsPerOctave;
    TexelGrid strip{std::max(sky_cells, captured_cells), 2 * kRows, {}};
    strip.texels.assign(static_cast<std::size_t>(strip.width) * strip.height * 4, 0.0f);
    const auto fill = [&](Segment segment, int cell) {
        const double u_octave = std::exp2(cell / kCellsPerOctave);
        std::array<std::array<double, 4>, kRows> values{};
        for (int i = 0; i < 4; ++i) {
            const double u = u_octave * (1.0 + (cell % kCellsPerOctave + kNodes[i]) / kCellsPerOctave);
            const FanRay ray = fan.ray(segment, fan.mirrored(segment, (u - 1.0) * fan.w0()));
            values[0][i] = std::cos(ray.phi_end);
            values[1][i] = std::sin(ray.phi_end) / ray.sin_beta;
            values[2][i] = ray.phi_end / ray.sin_beta;
        }
        for (int row = 0; row < kRows; ++row) {
            const auto c = cubic_through(values[row]);
            const std::size_t line = row + (segment == Segment::kSky ? 0 : kRows);
            std::copy(c.begin(), c.end(), strip.texels.begin() + 4 * (line * strip.width + cell));
        }
    };
    tbb::parallel_for(0, sky_cells + captured_cells, [&](int i) {
        if (i < sky_cells) fill(Segment::kSky, i);
        else fill(Segment::kCaptured, i - sky_cells);
    });
    return strip;
}

}  // namespace nullscope
