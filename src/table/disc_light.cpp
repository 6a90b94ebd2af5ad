#include "table/disc_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "light/black_body.h"
#include "numeric/gauss.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/leaning_circle.h"

namespace nullscope {
namespace {

constexpr double kDark = -64.0;  // log2: nothing of it is left in a float picture

// E and L of circular orbits have dE = Omega dL; with x = ln r both derivatives are taken of L alone.
struct Ring {
    double r, omega, gain;  // E - Omega L
    double momentum;
};

Ring ring_at(const Spacetime& spacetime, Sense sense, double r) {
    const CircularOrbit orbit = circular_orbit(spacetime, r, sense).value_or(CircularOrbit{1, 0, 1, 0});
    return {r, orbit.omega, orbit.energy - orbit.omega * orbit.momentum, orbit.momentum};
}

// Derivative by r of a function that is smooth on the scale of r and of the way to the horizon: six points, error h^6.
template <class Function>
double slope(const Spacetime& spacetime, Function f, double r) {
    constexpr double kStep = 4e-3, kOfWay = 0.05;
    const double h = std::min(kStep, kOfWay * (1.0 - spacetime.horizon_radius().value_or(0.0) / r));
    const auto at = [&](int n) { return f(r * std::exp(n * h)); };
    return (45.0 * (at(1) - at(-1)) - 9.0 * (at(2) - at(-2)) + (at(3) - at(-3))) / (60.0 * h * r);
}

// Of (E - Omega L) L' dr between two radii: eight points of Gauss.
double gained_between(const Spacetime& spacetime, Sense sense, double a, double b) {
    return gauss_rule(kEightNode, kEightWeight, a, b, [&](double r) {
        return ring_at(spacetime, sense, r).gain *
               slope(
                   spacetime, [&](double at) { return ring_at(spacetime, sense, at).momentum; }, r);
    });
}

}  // namespace

std::vector<double> disc_flux(const Spacetime& spacetime, const std::vector<double>& radii, Sense sense) {
    std::vector<double> flux(radii.size(), 0.0);
    const auto isco = innermost_stable_orbit(spacetime, sense);
    if (!isco) return flux;
    std::vector<std::size_t> order(radii.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radii[a] < radii[b]; });
    const double horizon = spacetime.horizon_radius().value_or(0.0);
    double from = *isco, gained = 0.0;
    for (const std::size_t i : order) {
        const double r = radii[i];
        if (r <= *isco) continue;
        while (from < r) {  // pieces of at most a tenth of r, and half of the way to the horizon
            const double to = std::min(r, from + std::min(0.1 * from, 0.5 * (from - horizon)));
            gained += gained_between(spacetime, sense, from, to);
            from = to;
        }
        const Ring ring = ring_at(spacetime, sense, r);
        const double omega_slope = slope(
            spacetime, [&](double at) { return ring_at(spacetime, sense, at).omega; }, r);
        flux[i] = std::max(-omega_slope * gained / (4.0 * M_PI * r * ring.gain * ring.gain), 0.0);
    }
    return flux;
}

FluxPeak disc_flux_peak(const Spacetime& spacetime, Sense sense) {
    const auto isco = innermost_stable_orbit(spacetime, sense);
    if (!isco) return {1.0, 0.0};
    double low = *isco, high = std::min(4.0 * *isco, outermost_circular_orbit(spacetime));  // one maximum between them
    constexpr double kGolden = 0.6180339887498949;
    while (high - low > 1e-8 * high) {
        const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
        const std::vector<double> flux = disc_flux(spacetime, {a, b}, sense);
        if (flux[0] < flux[1])
            low = a;
        else
            high = b;
    }
    const double r = 0.5 * (low + high);
    return {r, disc_flux(spacetime, {r}, sense).front()};
}

double disc_temperature_K(double flux, double mass_suns, double rate_eddington) {
    constexpr double kSun_m3_s2 = 1.32712440018e20, kLight_m_s = 299792458.0;  // GM
    constexpr double kProton_kg = 1.67262192369e-27, kThomson_m2 = 6.6524587321e-29,
                     kStefan = 5.670374419e-8;  // CODATA 2018
    const double gm = mass_suns * kSun_m3_s2, radius_m = 2.0 * gm / (kLight_m_s * kLight_m_s);
    // Of the mass that falls in.
    const double power_W = 10.0 * rate_eddington * 4.0 * M_PI * gm * kProton_kg * kLight_m_s / kThomson_m2;
    return std::pow(flux * power_W / (radius_m * radius_m * kStefan), 0.25);
}

Vec3 disc_velocity(const Spacetime& spacetime, const DiscMatterFlow& flow, double r, ShiftParts parts) {
    const double lapse = std::sqrt(spacetime.lapse_squared(r)), scale = parts.gravity ? 1.0 : lapse;
    const MatterVelocity u = parts.doppler ? flow.at(r) : MatterVelocity{1.0 / lapse, 0.0, 0.0};
    const Equator equator = *spacetime.equator(r);
    const double g_rr = equator.radial / equator.across2;
    return {scale * u.u_t, scale * u.u_phi / (parts.straight ? lapse : 1.0), scale * u.u_r * g_rr};
}

std::array<double, 2> disc_lapses(const Spacetime& spacetime, double r, ShiftParts parts) {
    const auto equator = spacetime.equator(r);
    const double lapse = equator ? std::sqrt(std::max(equator->across2, 0.0)) / r : 1.0;
    return {lapse, parts.straight ? 1.0 : lapse};
}

TexelGrid disc_flow_row(const Spacetime& spacetime, double inner, double outer, ShiftParts parts, Sense sense,
                        std::optional<double> leaning, const RingLight& shines) {
    const double horizon = spacetime.horizon_radius().value_or(0.0);
    const double from = std::max(inner, (1.0 + 1e-6) * horizon);
    std::vector<double> radii;
    for (int i = 0; i <= kDiscFlowCells; ++i)
        radii.push_back(std::max(inner * std::pow(outer / inner, double(i) / kDiscFlowCells), from));
    const std::vector<double> flux = shines ? shines(radii) : disc_flux(spacetime, radii, sense);
    const double peak = shines ? 1.0 : disc_flux_peak(spacetime, sense).flux;
    const DiscMatterFlow matter(spacetime, sense);
    TexelGrid row{kDiscFlowCells + 1, kDiscFlowRows, {}};
    std::vector<float> factors;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double lapse = std::sqrt(spacetime.lapse_squared(radii[i])), scale = parts.gravity ? 1.0 : lapse;
        const Vec3 u = leaning ? Vec3{1.0, leaning_rate(spacetime, radii[i], sense, *leaning).value_or(0.0), 0.0}
                               : disc_velocity(spacetime, matter, radii[i], parts);
        const double heat = flux[i] > 0.0 ? std::max(0.25 * std::log2(flux[i] / peak), kDark) : kDark;
        for (const double value : {heat, u.x, u.y, u.z}) row.texels.push_back(static_cast<float>(value));
        const double factor = scale / (parts.straight ? lapse : 1.0);
        const auto lapses = disc_lapses(spacetime, radii[i], parts);
        for (const double value : {factor, lapses[0], lapses[1], 1.0 / scale})
            factors.push_back(static_cast<float>(value));
    }
    row.texels.insert(row.texels.end(), factors.begin(), factors.end());
    return row;
}

TexelGrid black_body_row() {
    TexelGrid row{kBlackBodyCells + 1, 1, {}};
    for (int i = 0; i <= kBlackBodyCells; ++i) {
        const Vec3 xyz = black_body_xyz(std::exp2(kColdest + (kHottest - kColdest) * i / kBlackBodyCells));
        const Vec3 rgb = rec709_from_xyz(xyz / xyz.y);
        for (const double value : {rgb.x, rgb.y, rgb.z, std::log2(xyz.y)})
            row.texels.push_back(static_cast<float>(value));
    }
    return row;
}

}  // namespace nullscope
