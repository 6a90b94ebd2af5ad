#include "table/orbit_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/nystrom.h"
#include "table/delay_column.h"
#include "table/throat_orbit.h"

namespace nullscope {
namespace {

constexpr double kLargestStep = 0.08;  // rad; local error 1e-12, between its ends 1e-10

MetOrbit integrate(const RayFamily& family, Segment segment, const FanRay& ray) {
    const OrbitEquation& equation = *family.spacetime().orbit_equation();
    const bool sky = segment == Segment::kSky;
    const double q = ray.q;
    const double beta_per_delta = sky ? 1.0 : -1.0;  // beta grows away from the shadow's middle
    const double cell = ray.phi_end / family.orbit_rows();
    // Its derivatives by delta follow the variational equation.
    const auto force = [&](double zeta, double vary) {
        return std::array{-equation.half_v_slope(zeta), -equation.half_v_curvature(zeta) * vary};
    };
    // Steps of several rows where these are close together, or several for a row.
    const auto follow = [&](OrbitState* states, int rows) {
        BentState<OrbitState> here{states[0], force(states[0].at, states[0].vary)};
        for (int row = 0; row < rows;) {
            // Deep inside the horizon orbits bend faster.
            const double pace = std::sqrt(std::max(1.0, 0.5 * std::fabs(equation.half_v_curvature(here.state.at))));
            const double rows_a_step = kLargestStep / (pace * cell);
            const int together = static_cast<int>(std::clamp(rows_a_step, 1.0, static_cast<double>(rows - row)));
            const int substeps = std::max(1, static_cast<int>(std::ceil(1.0 / rows_a_step)));
            const double h = together * cell / substeps;
            const BentState<OrbitState> before = here;
            for (int j = 0; j < substeps; ++j) here = nystrom_step(here, h, force);
            for (int k = 1; k < together; ++k)
                states[row + k] = nystrom_between(before, here, h, static_cast<double>(k) / together);
            row += together;
            states[row] = here.state;
        }
    };
    // Backward: zeta(phi) = Y(phi_end - phi), Y(0) = end value, Y'(0) = sqrt(q^2 - V) there, q where V = 0, towards the camera.
    const double inward = sky ? 1.0 : -1.0;
    const double q_per_delta = -ray.slope / ray.sin_beta * beta_per_delta;
    const double end_slope = sky ? family.slope_at_sky(q) : q;
    return meet(family.orbit_rows(), {family.zeta0(), ray.slope, 0.0, -beta_per_delta * q / ray.sin_beta},
                {sky ? 0.0 : 1.0 / *family.spacetime().horizon_radius(), inward * end_slope, 0.0,
                 inward * q_per_delta * (q / end_slope)},
                follow, [&](double zeta) { return -equation.half_v_slope(zeta); });
}

}  // namespace

OrbitTable build_orbit_table(const RayFamily& family, bool delays) {
    const int cells = family.orbit_cells(), columns = cells + 1, rows = family.orbit_rows();
    const int sky = family.octaves(Segment::kSky) * columns, captured = family.octaves(Segment::kCaptured) * columns;
    OrbitTable map{{std::max(sky, captured), 2 * (rows + 1), {}}, {}};
    map.places.texels.assign(static_cast<std::size_t>(map.places.width) * map.places.height * 4, 0.0f);
    if (delays) map.delays = map.places;
    tbb::parallel_for(0, sky + captured, [&](int i) {
        const Segment segment = i < sky ? Segment::kSky : Segment::kCaptured;
        const int at = i < sky ? i : i - sky;
        const double u_octave = std::exp2(at / columns);
        const double u = u_octave * (1.0 + static_cast<double>(at % columns) / cells);
        // The very first column would be the critical ray itself: it stands for 1/64 of the first cell.
        const double node = std::max(family.delta_at(u), family.w0() / (64.0 * cells));
        const double delta = family.mirrored(segment, node);
        const double delta_per_cell = (delta == node ? 1.0 : -1.0) * family.delta_slope(u) * u_octave / cells;
        const auto put = [&](TexelGrid& grid, const OrbitTexels& texels) {
            for (int row = 0; row <= rows; ++row) {
                const std::size_t line = row + (segment == Segment::kSky ? 0 : rows + 1);
                float* out = grid.texels.data() + 4 * (line * grid.width + at);
                const auto& texel = texels[static_cast<std::size_t>(row)];
                out[0] = static_cast<float>(texel[0]);
                out[1] = static_cast<float>(texel[1] * delta_per_cell);
                out[2] = static_cast<float>(texel[2]);
                out[3] = static_cast<float>(texel[3] * delta_per_cell);
            }
        };
        if (family.spacetime().by_proper_length()) return put(map.places, throat_column(family, segment, delta));
        const FanRay ray = family.ray(segment, delta);
        const MetOrbit orbit = integrate(family, segment, ray);
        put(map.places, place_texels(orbit, ray.phi_end, segment == Segment::kSky, [&](double zeta) {
                return -family.spacetime().orbit_equation()->half_v_slope(zeta);
            }));
        if (delays) put(map.delays, delay_column(family, segment, ray, orbit));
    });
    return map;
}

TexelGrid side_by_side(const TexelGrid& places, const TexelGrid& delays) {
    TexelGrid both{2 * places.width, places.height, std::vector<float>(2 * places.texels.size())};
    float* out = both.texels.data();
    for (std::size_t i = 0; i < places.texels.size(); i += 4, out += 8) {
        std::copy_n(places.texels.data() + i, 4, out);
        std::copy_n(delays.texels.data() + i, 4, out + 4);
    }
    return both;
}

}  // namespace nullscope
