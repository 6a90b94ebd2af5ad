#include "table/orbit_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "table/delay_column.h"
#include "table/nystrom.h"
#include "table/throat_orbit.h"

namespace nullscope {
namespace {

constexpr int kCellsPerOctave = 12;  // ORBIT_CELLS_PER_OCTAVE
constexpr int kRows = kOrbitRows;
constexpr double kLargestStep = 0.08;  // rad; local error 1e-12

using State = OrbitState;  // its derivatives by delta follow the variational equation

State step(const OrbitEquation& equation, const State& s, double h) {
    return nystrom_step(s, h, [&](double zeta, double vary) {
        return std::array{-equation.half_v_slope(zeta), -equation.half_v_curvature(zeta) * vary};
    });
}

using Column = std::array<State, kRows + 1>;

// The orbit of one ray at v = 0 ... 1. Rays near the critical one linger at the photon sphere, where errors grow like exp(phi):
// so the first half is integrated from the camera and the second half backward from the end, and d(phi_end)/d(delta) is what makes
// their derivatives meet in the middle. Amplification of the local error: at most exp(phi_end / 2).
Column integrate(const RayFan& fan, Segment segment, const FanRay& ray, double& end_per_delta) {
    const SphericalMetric& spacetime = fan.spacetime();
    const OrbitEquation& equation = *spacetime.orbit_equation();
    const bool sky = segment == Segment::kSky;
    const double q = ray.q;
    const double beta_per_delta = sky ? 1.0 : -1.0;  // beta grows away from the shadow's middle
    const double cell = ray.phi_end / kRows;
    const auto advance = [&](State s) {
        // Deep inside the horizon orbits bend faster.
        const double pace = std::sqrt(std::max(1.0, 0.5 * std::fabs(equation.half_v_curvature(s.zeta))));
        const int substeps = std::max(1, static_cast<int>(std::ceil(pace * cell / kLargestStep)));
        for (int j = 0; j < substeps; ++j) s = step(equation, s, cell / substeps);
        return s;
    };
    constexpr int kMiddle = kRows / 2;
    Column orbit{};
    orbit[0] = {fan.zeta0(), ray.slope, 0.0, -beta_per_delta * q / ray.sin_beta};
    for (int i = 1; i <= kMiddle; ++i) orbit[i] = advance(orbit[i - 1]);

    // Backward: zeta(phi) = Y(phi_end - phi), Y(0) = end value with V = 0, Y'(0) = q towards the camera.
    const double inward = sky ? 1.0 : -1.0;
    const double q_per_delta = -ray.slope / ray.sin_beta * beta_per_delta;
    State y{sky ? 0.0 : 1.0 / *spacetime.horizon_radius(), inward * q, 0.0, inward * q_per_delta};
    Column back{};
    back[kRows] = y;
    for (int i = kRows - 1; i >= kMiddle; --i) back[i] = advance(back[i + 1]);
    const State& f = orbit[kMiddle];
    y = back[kMiddle];
    const double y_curvature = -equation.half_v_slope(y.zeta);
    end_per_delta = ((f.vary - y.vary) * y.slope - (f.vary_slope + y.vary_slope) * y_curvature) /
                    (y.slope * y.slope + y_curvature * y_curvature);
    for (int i = kMiddle + 1; i <= kRows; ++i) {
        const State& b = back[i];
        orbit[i] = {b.zeta, -b.slope, b.vary + b.slope * end_per_delta,
                    -(b.vary_slope - equation.half_v_slope(b.zeta) * end_per_delta)};
    }
    return orbit;
}

// One column: texels (Z, Z_d, Z_v, Z_dv) at v = 0 ... 1, derivatives by delta and by v.
std::vector<std::array<double, 4>> places(const RayFan& fan, Segment segment, const FanRay& ray, const Column& orbit,
                                          double end_per_delta) {
    const OrbitEquation& equation = *fan.spacetime().orbit_equation();
    std::vector<std::array<double, 4>> texels(kRows + 1);
    for (int i = 0; i <= kRows; ++i) {
        const double v = static_cast<double>(i) / kRows;
        const State& o = orbit[i];
        const double curvature = -equation.half_v_slope(o.zeta);
        double z = o.zeta, z_v = o.slope * ray.phi_end;
        double z_d = o.vary + o.slope * v * end_per_delta;
        double z_dv = ray.phi_end * (o.vary_slope + curvature * v * end_per_delta) + o.slope * end_per_delta;
        if (segment == Segment::kSky) {  // divide by 1 - v; at v = 1 the limits, with zeta'' = 0 there
            if (i < kRows) {
                const double rest = 1.0 - v;
                z /= rest, z_d /= rest;
                z_v = (z_v + z) / rest, z_dv = (z_dv + z_d) / rest;
            } else {
                z = -z_v, z_d = -z_dv;
                z_v = 0.0, z_dv = 0.0;
            }
        }
        texels[i] = {z, z_d, z_v / kRows, z_dv / kRows};
    }
    return texels;
}

}  // namespace

OrbitMap build_orbit_map(const RayFan& fan, bool delays) {
    constexpr int kColumns = kCellsPerOctave + 1;
    const int sky = fan.octaves(Segment::kSky) * kColumns, captured = fan.octaves(Segment::kCaptured) * kColumns;
    OrbitMap map{{std::max(sky, captured), 2 * (kRows + 1), {}}, {}};
    map.places.texels.assign(static_cast<std::size_t>(map.places.width) * map.places.height * 4, 0.0f);
    if (delays) map.delays = map.places;
    tbb::parallel_for(0, sky + captured, [&](int i) {
        const Segment segment = i < sky ? Segment::kSky : Segment::kCaptured;
        const int at = i < sky ? i : i - sky;
        const double u_octave = std::exp2(at / kColumns);
        const double u = u_octave * (1.0 + static_cast<double>(at % kColumns) / kCellsPerOctave);
        // The very first column would be the critical ray itself: it stands for 1/64 of the first cell.
        const double node = std::max(fan.delta_at(u), fan.w0() / (64.0 * kCellsPerOctave));
        const double delta = fan.mirrored(segment, node);
        const double delta_per_cell = (delta == node ? 1.0 : -1.0) * fan.delta_slope(u) * u_octave / kCellsPerOctave;
        const auto put = [&](TexelGrid& grid, const auto& texels) {
            for (int row = 0; row <= kRows; ++row) {
                const std::size_t line = row + (segment == Segment::kSky ? 0 : kRows + 1);
                float* out = grid.texels.data() + 4 * (line * grid.width + at);
                const auto& texel = texels[static_cast<std::size_t>(row)];
                out[0] = static_cast<float>(texel[0]);
                out[1] = static_cast<float>(texel[1] * delta_per_cell);
                out[2] = static_cast<float>(texel[2]);
                out[3] = static_cast<float>(texel[3] * delta_per_cell);
            }
        };
        if (fan.spacetime().by_proper_length()) return put(map.places, throat_column(fan, segment, delta));
        const FanRay ray = fan.ray(segment, delta);
        double end_per_delta = 0.0;
        const Column orbit = integrate(fan, segment, ray, end_per_delta);
        put(map.places, places(fan, segment, ray, orbit, end_per_delta));
        if (delays) put(map.delays, delay_column(fan, segment, ray, orbit, end_per_delta));
    });
    return map;
}

TexelGrid side_by_side(const TexelGrid& places, const TexelGrid& delays) {
    constexpr std::ptrdiff_t kTexel = 4;
    TexelGrid both{2 * places.width, places.height, {}};
    both.texels.reserve(2 * places.texels.size());
    for (auto a = places.texels.begin(), b = delays.texels.begin(); a != places.texels.end();
         a += kTexel, b += kTexel) {
        both.texels.insert(both.texels.end(), a, a + kTexel);
        both.texels.insert(both.texels.end(), b, b + kTexel);
    }
    return both;
}

}  // namespace nullscope
