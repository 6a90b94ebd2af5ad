// One column of the orbit table: a ray's orbit, followed from both of its ends.
//
// Rays near the critical one linger where errors grow like exp(phi): so the first half is integrated from the camera
// and the second half backward from the end, and d(phi_end)/d(delta) is what makes their derivatives meet in the
// middle. Amplification of the local error: at most exp(phi_end / 2).
#pragma once
#include <array>
#include <vector>

namespace nullscope {

using OrbitTexels = std::vector<std::array<double, 4>>;  // (Z, Z_d, Z_v, Z_dv) at v = 0 ... 1, by delta and by row

// What is followed by the swept angle phi, zeta or the W of table/throat_orbit.h; its slope, and the derivatives of
// both by delta at fixed phi.
struct OrbitState {
    double at, slope, vary, vary_slope;
};

struct MetOrbit {
    std::vector<OrbitState> states;  // at equal steps of phi from the camera to the end
    double end_per_delta;            // d phi_end/d delta
};

// rows: steps. start: at the camera; end: at the ray's end, of the orbit that is followed backward. follow(state, rows): the states
// of that many more rows, written behind it; bend(at): at''.
template <class Follow, class Bend>
MetOrbit meet(int rows, const OrbitState& start, const OrbitState& end, const Follow& follow, const Bend& bend) {
    const int middle = rows / 2, rest = rows - middle;
    const auto places = [](int count) { return std::vector<OrbitState>(static_cast<std::size_t>(count) + 1); };
    MetOrbit orbit{places(rows), 0.0};
    auto& states = orbit.states;
    states[0] = start;
    follow(states.data(), middle);
    std::vector<OrbitState> from_end = places(rest);
    from_end[0] = end;
    follow(from_end.data(), rest);
    const OrbitState &f = states[middle], &b = from_end.back();
    const double curvature = bend(b.at);
    orbit.end_per_delta = ((f.vary - b.vary) * b.slope - (f.vary_slope + b.vary_slope) * curvature) /
                          (b.slope * b.slope + curvature * curvature);
    for (int i = middle + 1; i <= rows; ++i) {
        const OrbitState& back = from_end[rows - i];
        states[i] = {back.at, -back.slope, back.vary + back.slope * orbit.end_per_delta,
                     -(back.vary_slope + bend(back.at) * orbit.end_per_delta)};
    }
    return orbit;
}

// from_sky: Z is the state over 1 - v, at v = 1 its limit where the bend vanishes; else the state.
template <class Bend>
OrbitTexels place_texels(const MetOrbit& orbit, double phi_end, bool from_sky, const Bend& bend) {
    const int rows = static_cast<int>(orbit.states.size()) - 1;
    OrbitTexels texels(orbit.states.size());
    for (int i = 0; i <= rows; ++i) {
        const double v = static_cast<double>(i) / rows, rest = 1.0 - v;
        const OrbitState& o = orbit.states[i];
        double z = o.at, z_v = o.slope * phi_end, z_d = o.vary + o.slope * v * orbit.end_per_delta;
        double z_dv = phi_end * (o.vary_slope + bend(o.at) * v * orbit.end_per_delta) + o.slope * orbit.end_per_delta;
        if (from_sky && i < rows) {
            z /= rest, z_d /= rest;
            z_v = (z_v + z) / rest, z_dv = (z_dv + z_d) / rest;
        } else if (from_sky) {
            z = -z_v, z_d = -z_dv;
            z_v = 0.0, z_dv = 0.0;
        }
        texels[static_cast<std::size_t>(i)] = {z, z_d, z_v / rows, z_dv / rows};
    }
    return texels;
}

}  // namespace nullscope
