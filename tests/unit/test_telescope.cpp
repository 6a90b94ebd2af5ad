// Arrays of telescopes: tables and their faults, tracks as the Earth turns, closure quantities, noise.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "support/folders.h"
#include "telescope/baseline_list.h"
#include "telescope/closure.h"
#include "telescope/observation.h"
#include "telescope/stations.h"

namespace {

using namespace nullscope;

constexpr double kRadian = M_PI / 180, kEarth = 6.371e6, kWave = 1.3e-3;  // m
constexpr double kHz = 299792458.0 / kWave;

Station on_equator(const char* name, double longitude_deg) {
    return {name, 1000, {kEarth * std::cos(kRadian * longitude_deg), kEarth * std::sin(kRadian * longitude_deg), 0}};
}

std::vector<double> every(double step, double to) {
    std::vector<double> hours;
    for (int i = 0; i * step <= to; ++i) hours.push_back(i * step);
    return hours;
}

Observation seen_by(const std::vector<Station>& stations, ObservationPlan plan) {
    plan.frequency_hz = kHz;
    const auto seen = observe(stations, plan);
    REQUIRE(seen);
    return *seen;
}

std::vector<Station> shipped_array(const char* name) {
    const auto file = test::source_folder() / "assets/telescopes" / name;
    const auto stations = read_stations(*read_text(file), file.string());
    REQUIRE_MESSAGE(stations, stations.error().message());
    return *stations;
}

TEST_CASE("telescope: a station to the east has a positive u, one to the north a positive v") {
    const std::vector<Station> pair = {on_equator("east", 10), on_equator("west", 0)};
    const Observation seen = seen_by(pair, {.hours = {0}});  // the source is over the western one
    REQUIRE(seen.baselines.size() == 1);
    CHECK(seen.baselines[0].u == doctest::Approx(kEarth * std::sin(10 * kRadian) / kWave).epsilon(1e-12));
    CHECK(std::fabs(seen.baselines[0].v) < 1e-6);
    std::vector<Station> tall = {{"north", 1000, {kEarth * std::cos(0.2), 0, kEarth * std::sin(0.2)}},
                                 on_equator("south", 0)};
    const Observation upward = seen_by(tall, {.hours = {0}});
    CHECK(upward.baselines[0].v == doctest::Approx(kEarth * std::sin(0.2) / kWave).epsilon(1e-12));
}

TEST_CASE("telescope: tracks are ellipses about their axis' height, and turn with the Earth") {
    const auto stations = shipped_array("eht-2017.csv");
    CHECK(stations.size() == 8);
    const double declination = 12.391 * kRadian;
    const Observation seen = seen_by(
        stations,
        {.right_ascension = 3.276, .declination = declination, .hours = every(1, 23), .least_elevation = -M_PI / 2});
    CHECK(seen.scans.size() == 24);
    CHECK(seen.pairs.size() == 24 * 28);
    for (std::size_t i = 0; i < seen.pairs.size(); ++i) {
        const auto &a = stations[seen.pairs[i].first].place, &b = stations[seen.pairs[i].second].place;
        const double across = std::hypot(a[0] - b[0], a[1] - b[1]) / kWave, axial = (a[2] - b[2]) / kWave;
        const auto [u, v] = seen.baselines[i];
        CHECK(std::hypot(u, (v - axial * std::cos(declination)) / std::sin(declination)) ==
              doctest::Approx(across).epsilon(1e-9));
    }
    const Observation later = seen_by(
        stations,
        {.right_ascension = 3.276 + M_PI / 12, .declination = declination, .hours = {8}, .least_elevation = -M_PI / 2});
    for (std::size_t i = 0; i < 28; ++i)
        CHECK(later.baselines[i].u == doctest::Approx(seen.baselines[7 * 28 + i].u).epsilon(1e-9));
}

TEST_CASE("telescope: stations see what is above their least elevation") {
    const std::vector<Station> pair = {on_equator("a", 0), on_equator("b", 60)};
    // a sees the source of 60 degrees for 4 hours about hour 4, b about hour 0.
    for (const auto& [hour, seen_by_both] :
         {std::pair{-0.1, false}, {0.1, true}, {3.9, true}, {4.1, false}, {12.0, false}}) {
        const double at = hour;  // clang 14 hands no structured binding to a lambda
        CHECK_MESSAGE(
            seen_by(pair, {.right_ascension = M_PI / 3, .hours = {hour}, .least_elevation = M_PI / 6}).scans.empty() !=
                seen_by_both,
            at);
    }
}

TEST_CASE("telescope: a dish in space goes round, and the Earth hides the source from it") {
    const auto stations = shipped_array("eht-2017-space.csv");
    CHECK(stations.back().orbit);
    std::vector<Station> pair = {on_equator("ground", 0), {"space", 1000, {}, StationOrbit{7e6, 0, 0, 0}}};
    // One radius of 7000 km about the equator: it is 65.7 degrees about the far side that the Earth covers, asin(6378137/7e6).
    const double period = 2 * M_PI * std::sqrt(7e6 * 7e6 * 7e6 / 3.986004418e14), covered = std::asin(6378137.0 / 7e6);
    int hidden = 0, all = 0;
    for (double part = 0.0005; part < 1; part += 0.001, ++all)
        hidden += seen_by(pair, {.hours = {1e-9 + part * period / 3600 * 1.00273790935}, .least_elevation = -M_PI / 2})
                      .scans.empty();
    CHECK(static_cast<double>(hidden) / all == doctest::Approx(covered / M_PI).epsilon(0.01));
    const Observation twice =
        seen_by(pair, {.hours = {0, period / 3600 * 1.00273790935}, .least_elevation = -M_PI / 2});
    REQUIRE(twice.baselines.size() == 2);
    const double turned = kRadian * 15 * 1.00273790935 * period / 3600;  // of the ground, meanwhile
    CHECK(twice.baselines[1].u == doctest::Approx(kEarth / kWave * std::sin(turned)).epsilon(1e-6));
    // Over the pole of its orbit it is where the ascending node says.
    pair[1].orbit = StationOrbit{2e7, M_PI / 2, M_PI / 2, M_PI / 2};  // over the north pole
    const Observation north = seen_by(pair, {.hours = {0}});
    CHECK(north.baselines[0].v == doctest::Approx(-2e7 / kWave).epsilon(1e-12));
}

TEST_CASE("telescope: sidereal time is the almanac's") {
    CHECK(sidereal_hours(51544, 12) == doctest::Approx(18.697374558).epsilon(1e-9));
    // astropy 8.0.2, Time.sidereal_time("mean", "greenwich"): less UT1 - UTC, 0.46 s
    CHECK(std::fabs(sidereal_hours(57854, 0) - 13.293638737 + 0.4567 / 3600) < 3e-5);
    CHECK(std::fabs(sidereal_hours(57854, 5.25) - 18.558012664 + 0.4562 / 3600) < 3e-5);
    const auto stations = shipped_array("eht-2017.csv");
    const Observation by_ut = seen_by(stations, {.right_ascension = 3.2, .hours = {2}, .mjd = 57854}),
                      by_gmst = seen_by(stations, {.right_ascension = 3.2, .hours = {sidereal_hours(57854, 2)}});
    REQUIRE(by_ut.baselines.size() == by_gmst.baselines.size());
    CHECK(by_ut.baselines[0].u == doctest::Approx(by_gmst.baselines[0].u).epsilon(1e-12));
}

TEST_CASE("telescope: gains and delays of stations leave closure quantities alone") {
    const auto stations = shipped_array("eht-2017.csv");
    const Observation seen = seen_by(stations, {.hours = {0, 3}, .least_elevation = -M_PI / 2});
    std::vector<std::complex<double>> light, changed;
    for (std::size_t i = 0; i < seen.pairs.size(); ++i) {
        light.push_back(std::polar(1.0 + 0.1 * static_cast<double>(i % 7), 0.3 * static_cast<double>(i * i % 11)));
        const auto gain = [&](std::size_t s) {
            return std::polar(1.0 + 0.2 * static_cast<double>(s), 0.7 * static_cast<double>(s * s));
        };
        changed.push_back(light[i] * gain(seen.pairs[i].first) * std::conj(gain(seen.pairs[i].second)));
    }
    const auto phases = closure_phases(seen, light), others = closure_phases(seen, changed);
    REQUIRE(phases.size() == 2 * 56);
    for (std::size_t i = 0; i < phases.size(); ++i)
        CHECK(std::fabs(std::remainder(phases[i].phase - others[i].phase, 2 * M_PI)) < 1e-12);
    CHECK(phases[0].stations == std::array<std::size_t, 3>{0, 1, 2});
    CHECK(std::fabs(std::remainder(phases[0].phase - std::arg(light[0]) - std::arg(light[7]) + std::arg(light[1]),
                                   2 * M_PI)) < 1e-12);
    const auto amplitudes = closure_amplitudes(seen, light), other = closure_amplitudes(seen, changed);
    REQUIRE(amplitudes.size() == 2 * 70);
    for (std::size_t i = 0; i < amplitudes.size(); ++i)
        for (const std::size_t k : {0u, 1u})
            CHECK(amplitudes[i].log[k] == doctest::Approx(other[i].log[k]).epsilon(1e-10));
    // Stations 1, 2, 3, 4 of the first scan: pairs 12, 13, 14, ... are the first ones.
    const auto log_of = [&](std::size_t i) { return std::log(std::abs(light[i])); };
    CHECK(amplitudes[0].log[0] == doctest::Approx(log_of(0) + log_of(13) - log_of(1) - log_of(8)));
    CHECK(amplitudes[0].log[1] == doctest::Approx(log_of(0) + log_of(13) - log_of(2) - log_of(7)));
}

TEST_CASE("telescope: thermal noise has its variance, and a seed is one noise") {
    const Station alma{"ALMA", 74}, lmt{"LMT", 4500};
    CHECK(thermal_noise(alma, lmt, 2e9, 60) == doctest::Approx(9.46496096e-4).epsilon(1e-8));
    std::complex<double> sum, squares;
    double product = 0, fourth = 0;
    constexpr int kDraws = 200000;
    for (int i = 0; i < kDraws; ++i) {
        const std::complex<double> one = noise_at(5, static_cast<std::uint64_t>(i));
        sum += one, squares += std::complex(one.real() * one.real(), one.imag() * one.imag());
        product += one.real() * one.imag(), fourth += std::pow(one.real(), 4);
    }
    constexpr double kFew = 5 / 447.2;  // standard deviations of a mean of kDraws
    CHECK(std::abs(sum) / kDraws < kFew);
    CHECK(squares.real() / kDraws == doctest::Approx(1).epsilon(1.5 * kFew));
    CHECK(squares.imag() / kDraws == doctest::Approx(1).epsilon(1.5 * kFew));
    CHECK(std::fabs(product) / kDraws < kFew);
    CHECK(fourth / kDraws == doctest::Approx(3).epsilon(5 * kFew));
    CHECK(noise_at(5, 17) == noise_at(5, 17));
    CHECK(noise_at(5, 17) != noise_at(6, 17));
    CHECK(noise_at(5, 17) != noise_at(5, 18));
}

TEST_CASE("telescope: a bad table is refused with file, line and column") {
    const std::string head = "station,x_m,y_m,z_m,sefd_jy\n", good = "A,6371000,0,0,100\n";
    const auto stations = [](const std::string& text) {
        const auto read = read_stations(text, "s.csv");
        return read ? std::string("read") : read.error().message();
    };
    CHECK(stations(head + good + "B,0,6371000,0,100\n") == "read");
    for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
             {"", "s.csv:1: header: there is none"},
             {"# a\n" + head, "s.csv:1: row: there is none"},
             {"# a\nstation,x_m\n" + good, "s.csv:2: sefd_jy: this column is missing"},
             {"station,x_m,y_m,z_m,sefd_jy,diameter\n", "s.csv:1: header: unknown column \"diameter\""},
             {"station,station,sefd_jy\n", "s.csv:1: station: this column is there twice"},
             {head + good, "s.csv:2: station: one station has no baseline"},
             {head + good + good, "s.csv:3: station: A is there twice"},
             {head + good + "B,0,6371000,0\n", "s.csv:3: row: 4 fields; allowed: 5"},
             {head + good + "B,0,637one,0,100\n", "s.csv:3: y_m: \"637one\" is no number"},
             {head + good + "B,0,6371,0,100\n",
              "s.csv:3: x_m: 6371 m from Earth's centre; allowed: [6.35e+06, 6.39e+06]"},
             {head + good + "B,0,6371000,0,0\n", "s.csv:3: sefd_jy: 0 is out of range"},
             {head + good + "B,0,6371000,0,nan\n", "s.csv:3: sefd_jy"},
             {head + good + "B,,6371000,0,1\n", "s.csv:3: x_m: this is missing"},
             {head + good + "a\"b,0,6371000,0,1\n", "s.csv:3: station"},
             {head + good + "\"B,0,6371000,0,1\n", "s.csv:3: row: a quote is not closed"},
             {"station,sefd_jy,radius_km,inclination_deg,node_deg\nS,1,7000,0,0\n",
              "s.csv:2: phase_deg: this is missing"},
             {"station,sefd_jy,radius_km,inclination_deg,node_deg,phase_deg,x_m\nS,1,7000,0,0,0,5\n",
              "s.csv:2: x_m: a place on Earth and an orbit"}}) {
        const std::string found = stations(text);
        CHECK_MESSAGE(found.starts_with(says), found);
    }
    const auto baselines = [](const std::string& text) {
        const auto read = read_baselines(text, "b.csv", 230.0);
        return read ? std::string("read") : read.error().message();
    };
    CHECK(baselines("v,u,time_h,frequency_ghz\n1e9,2e9,3,230\n") == "read");
    CHECK(baselines("u,v\n1e9,two\n").starts_with("b.csv:2: v: \"two\" is no number"));
    CHECK(baselines("u,v\n1,1\n1e99,1\n").starts_with("b.csv:3: u: 1e+99 is out of range"));
    CHECK(baselines("u,v,frequency_ghz\n1,1,345\n")
              .starts_with("b.csv:2: frequency_ghz: 345 is not the light's; allowed: 230"));
    const auto list = read_baselines("v,u,time_h\n1,2,3\n\n4,5,6\n", "b.csv", {});
    REQUIRE(list);
    CHECK(list->baselines[1].u == 5);
    CHECK(list->time_h == std::vector<double>{3, 6});
    CHECK(list->lines == std::vector<int>{2, 4});
}

}  // namespace
