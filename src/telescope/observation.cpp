#include "telescope/observation.h"

#include <fmt/format.h>

#include <cmath>

#include "base/vec.h"
#include "telescope/baseline_list.h"

namespace nullscope {
namespace {

constexpr double kLight_m_per_s = 299792458.0, kHour = M_PI / 12;
constexpr double kEarth_m3_s2 = 3.986004418e14,
                 kEarthRadius_m = 6378137.0;  // IAU 2015 B3's GM, and the equator's radius
constexpr double kSiderealPerUt = 1.00273790935;

// Axes: the equinox, 90 degrees east of it, the north pole. since: s after hour 0.
Vec3 place_at(const Station& station, double sidereal, double since) {
    const double turn = sidereal * kHour, c = std::cos(turn), s = std::sin(turn);
    if (!station.orbit) {
        const auto [x, y, z] = station.place;
        return {c * x - s * y, s * x + c * y, z};
    }
    const StationOrbit& orbit = *station.orbit;
    const double rate = std::sqrt(kEarth_m3_s2 / orbit.radius_m) / orbit.radius_m;
    const double along = std::cos(orbit.phase + rate * since), ahead = std::sin(orbit.phase + rate * since);
    const Vec3 node{std::cos(orbit.node), std::sin(orbit.node), 0};
    const Vec3 north{-node.y * std::cos(orbit.inclination), node.x * std::cos(orbit.inclination),
                     std::sin(orbit.inclination)};
    return orbit.radius_m * (along * node + ahead * north);
}

bool sees(const Station& station, Vec3 place, Vec3 source, double least_elevation) {
    const double towards = dot(place, source);
    if (!station.orbit) return towards >= std::sin(least_elevation) * length(place);
    return towards >= 0 || length(place - towards * source) > kEarthRadius_m;  // not behind the Earth
}

// To the source, and across that direction to the east and to the north.
struct SkyAxes {
    Vec3 source, east, north;
    SkyAxes(double right_ascension, double declination) {
        const double ca = std::cos(right_ascension), sa = std::sin(right_ascension), cd = std::cos(declination),
                     sd = std::sin(declination);
        source = {cd * ca, cd * sa, sd}, east = {-sa, ca, 0}, north = {-sd * ca, -sd * sa, cd};
    }
};

std::uint64_t mixed(std::uint64_t state) {  // SplitMix64 (Steele, Lea and Flood 2014)
    state += 0x9e3779b97f4a7c15u;
    state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
    state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
    return state ^ (state >> 31);
}

}  // namespace

double sidereal_hours(int mjd, double hour) {
    const double days = mjd - 51544.5, centuries = days / 36525;
    const double found =
        6.697374558 + 0.06570982441908 * days + kSiderealPerUt * hour + 0.000026 * centuries * centuries;
    return found - 24 * std::floor(found / 24);
}

Result<Observation> observe(const std::vector<Station>& stations, const ObservationPlan& plan) {
    const SkyAxes axes(plan.right_ascension, plan.declination);
    const double per_wave = plan.frequency_hz / kLight_m_per_s;
    Observation seen;
    for (const double hour : plan.hours) {
        const double sidereal = plan.mjd ? sidereal_hours(*plan.mjd, hour) : hour;
        const double since = 3600 * (plan.mjd ? hour : hour / kSiderealPerUt);
        std::vector<Vec3> places;
        Scan scan{hour, {}, seen.baselines.size()};
        for (std::size_t i = 0; i < stations.size(); ++i) {
            places.push_back(place_at(stations[i], sidereal, since));
            if (sees(stations[i], places[i], axes.source, plan.least_elevation)) scan.up.push_back(i);
        }
        if (scan.up.size() < 2) continue;
        for (std::size_t a = 0; a < scan.up.size(); ++a)
            for (std::size_t b = a + 1; b < scan.up.size(); ++b) {
                const Vec3 waves = per_wave * (places[scan.up[a]] - places[scan.up[b]]);
                seen.pairs.push_back({scan.up[a], scan.up[b]});
                seen.baselines.push_back({dot(waves, axes.east), dot(waves, axes.north)});
            }
        if (seen.baselines.size() > kMostBaselines)
            return bad_input(fmt::format("{} scans of {} stations are too many", plan.hours.size(), stations.size()),
                             fmt::format("{} baselines in all", kMostBaselines));
        seen.scans.push_back(std::move(scan));
    }
    return seen;
}

double thermal_noise(const Station& first, const Station& second, double bandwidth_hz, double integration_s) {
    constexpr double kTwoBits = 0.88;
    return std::sqrt(first.sefd_jy * second.sefd_jy / (4 * bandwidth_hz * integration_s)) / kTwoBits;
}

std::complex<double> noise_at(std::uint64_t seed, std::uint64_t index) {
    const auto uniform = [&](std::uint64_t which) {  // (0, 1)
        return (static_cast<double>(mixed(mixed(seed) ^ (2 * index + which)) >> 11) + 0.5) * 0x1p-53;
    };
    return std::polar(std::sqrt(-2 * std::log(uniform(0))), 2 * M_PI * uniform(1));
}

}  // namespace nullscope
