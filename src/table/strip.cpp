#include "table/strip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nullscope {
namespace {

constexpr int kCoarse = 16;  // ENDS_CELLS_PER_OCTAVE: cubics that follow the family
constexpr int kFine = 1024;  // STRIP_CELLS_PER_OCTAVE: straight lines that follow the cubics, one octave a row

using Cubic = std::array<double, 4>;
double value(const Cubic& c, double f) { return c[0] + f * (c[1] + f * (c[2] + f * c[3])); }

// The cubic through the four Chebyshev nodes of [0, 1], as coefficients of 1, f, f^2, f^3.
constexpr std::array<double, 4> kNodes = {0.038060233744356625, 0.30865828381745514, 0.6913417161825449,
                                          0.9619397662556434};
Cubic cubic_through(const std::array<double, 4>& y) {
    // Newton's divided differences, then expanded to powers of f.
    std::array<double, 4> d = y;
    for (int level = 1; level < 4; ++level)
        for (int i = 3; i >= level; --i) d[i] = (d[i] - d[i - 1]) / (kNodes[i] - kNodes[i - level]);
    Cubic c{d[3], 0, 0, 0};  // Horner on polynomials: c = c (f - node) + d
    int degree = 0;
    for (int i = 2; i >= 0; --i) {
        ++degree;
        for (int p = degree; p >= 1; --p) c[p] = c[p - 1] - kNodes[i] * c[p];
        c[0] = d[i] - kNodes[i] * c[0];
    }
    return c;
}

struct Cell {
    Cubic cos_phi, ratio, end;
    Cubic bare_cos, bare_ratio;  // without what is swept in a wormhole's tube: that turns faster than a cubic follows
};

// by_centre: of captured rays by their angle from the inward radial, instead of that from the critical direction.
Cell coarse_cell(const RayFamily& family, Segment segment, bool by_centre, int cell) {
    const double u_octave = std::exp2(cell / kCoarse);
    std::array<double, 4> cos_phi{}, ratio{}, end{}, bare_cos{}, bare_ratio{};
    for (int i = 0; i < 4; ++i) {
        const double u = u_octave * (1.0 + (cell % kCoarse + kNodes[i]) / kCoarse);
        const double delta = by_centre ? std::max(family.critical_angle() - family.delta_at(u), 0.0)
                                       : family.mirrored(segment, family.delta_at(u));
        const FanRay ray = family.ray(segment, delta);
        cos_phi[i] = std::cos(ray.phi_end);
        ratio[i] = std::sin(ray.phi_end) / ray.sin_beta;
        end[i] = ray.phi_end / ray.sin_beta;
        bare_cos[i] = std::cos(ray.phi_end - ray.in_tube);
        bare_ratio[i] = std::sin(ray.phi_end - ray.in_tube) / ray.sin_beta;
    }
    return {cubic_through(cos_phi), cubic_through(ratio), cubic_through(end), cubic_through(bare_cos),
            cubic_through(bare_ratio)};
}

// The straight line that errs least, against 0 ... 1: through the Chebyshev nodes, where it has these values.
constexpr double kNode = 0.14644660940672624;  // (1 - 1/sqrt 2)/2
std::array<float, 2> line_through(double low, double high) {
    const double slope = (high - low) / (1.0 - 2.0 * kNode);
    return {static_cast<float>(low - kNode * slope), static_cast<float>(slope)};
}

// (cos(phi), sin(phi)/sin(alpha)) at the place f of a coarse cell.
std::array<double, 2> at_place(const RayFamily& family, Segment segment, int at, const Cell& cell, double f) {
    if (!family.has_tube()) return {value(cell.cos_phi, f), value(cell.ratio, f)};
    const double u = std::exp2(at / kCoarse) * (1.0 + (at % kCoarse + f) / kCoarse);
    const FanRay ray = family.tube_ray(segment, family.mirrored(segment, family.delta_at(u)));
    const double c = value(cell.bare_cos, f), r = value(cell.bare_ratio, f);
    const double turn_c = std::cos(ray.in_tube), turn_s = std::sin(ray.in_tube);
    return {c * turn_c - r * ray.sin_beta * turn_s, r * turn_c + c * turn_s / ray.sin_beta};
}

}  // namespace

Strip build_strip(const RayFamily& family) {
    const int sky_cells = family.octaves(Segment::kSky) * kCoarse,
              captured_cells = family.octaves(Segment::kCaptured) * kCoarse;
    constexpr int kPerCoarse = kFine / kCoarse;
    Strip strip;
    const bool inner = family.spacetime().inner_end() != InnerEnd::kHorizon;  // something to see there
    const bool back = family.spacetime().inner_end() == InnerEnd::kSameSky;
    strip.sky = {kFine, (sky_cells + (inner ? captured_cells : 0) + (back ? captured_cells : 0)) / kCoarse, {}};
    strip.sky.texels.assign(static_cast<std::size_t>(strip.sky.width) * strip.sky.height * 4, 0.0f);
    strip.ends = {std::max(sky_cells, captured_cells), back ? 9 : inner ? 6 : 4, {}};
    strip.ends.texels.assign(static_cast<std::size_t>(strip.ends.width) * strip.ends.height * 4, 0.0f);
    tbb::parallel_for(0, sky_cells + captured_cells * (back ? 2 : 1), [&](int i) {
        const bool sky = i < sky_cells, centre = i >= sky_cells + captured_cells;
        const int at = sky ? i : centre ? i - sky_cells - captured_cells : i - sky_cells;
        const Segment segment = sky ? Segment::kSky : Segment::kCaptured;
        const Cell cell = coarse_cell(family, segment, centre, at);
        const auto put = [&](int row, const Cubic& cubic) {  // ENDS_ROW_...
            float* out = strip.ends.texels.data() + 4 * (static_cast<std::size_t>(row) * strip.ends.width + at);
            std::transform(cubic.begin(), cubic.end(), out, [](double c) { return static_cast<float>(c); });
        };
        put(sky ? 0 : centre ? 6 : 1, cell.end);
        if (!sky && !inner) return;
        put(sky ? 2 : centre ? 7 : 4, cell.cos_phi);
        put(sky ? 3 : centre ? 8 : 5, cell.ratio);
        float* out = strip.sky.texels.data() + static_cast<std::size_t>(4) * kPerCoarse * i;
        for (int j = 0; j < kPerCoarse; ++j, out += 4) {
            const double a = static_cast<double>(j) / kPerCoarse, b = static_cast<double>(j + 1) / kPerCoarse;
            const auto low = at_place(family, segment, at, cell, a + kNode * (b - a)),
                       high = at_place(family, segment, at, cell, b - kNode * (b - a));
            const auto c = line_through(low[0], high[0]), r = line_through(low[1], high[1]);
            out[0] = c[0], out[1] = c[1], out[2] = r[0], out[3] = r[1];
        }
    });
    return strip;
}

}  // namespace nullscope
