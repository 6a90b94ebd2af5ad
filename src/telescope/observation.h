// What an array's stations see together as the Earth turns: scans, baselines of each, thermal noise.
#pragma once
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "telescope/stations.h"
#include "telescope/visibility.h"

namespace nullscope {

struct ObservationPlan {
    double right_ascension = 0, declination = 0;  // of the source, rad
    double frequency_hz = 230e9;
    std::vector<double> hours;  // Greenwich mean sidereal time, or UT of the day `mjd`
    std::optional<int> mjd{};
    double least_elevation =
        0;  // rad, of the source over a station's horizon, whose normal points away from Earth's centre
};

struct Scan {
    double hour = 0;              // as the plan has it
    std::vector<std::size_t> up;  // stations that see the source, ascending
    std::size_t first = 0;        // of its baselines: (up[0], up[1]), (up[0], up[2]), ..., (up[1], up[2]), ...
    std::size_t at(std::size_t a, std::size_t b) const {  // of up[a] and up[b], a < b
        return first + a * (2 * up.size() - a - 1) / 2 + (b - a - 1);
    }
};

struct StationPair {
    std::size_t first, second;
};
// Baselines from the second station to the first, which stands before it in the table.
struct Observation {
    std::vector<Scan> scans;  // those in which two stations or more see the source
    std::vector<StationPair> pairs;
    std::vector<Baseline> baselines;
};

// Hours of Greenwich mean sidereal time, [0, 24), of a day's hour in UT1: the formula of the Astronomical Almanac, within 0.1 s from 1950 to 2050.
// UTC is within 0.9 s of UT1.
double sidereal_hours(int mjd, double hour);

// Right ascension and declination count from the equator and equinox of the Earth's rotation; precession, nutation, polar motion and refraction are
// left out: in 2017 the equinox of a catalogue (J2000) is 0.2 degrees off. Errors (bad input): more than kMostBaselines.
Result<Observation> observe(const std::vector<Station>& stations, const ObservationPlan& plan);

// Thermal noise of the real and of the imaginary part of each of I, Q, U and V, Jy: of the mean of both hands, sampled with two bits
// (efficiency 0.88): sqrt(S_1 S_2/(2 bandwidth time))/(0.88 sqrt(2)).
double thermal_noise(const Station& first, const Station& second, double bandwidth_hz, double integration_s);

// Its real and its imaginary part have mean 0 and variance 1 each: by its place in a list, the same on every machine (Box and Muller, of
// SplitMix64's bits).
std::complex<double> noise_at(std::uint64_t seed, std::uint64_t index);

}  // namespace nullscope
