// The gas of a disc, as the reference has it: the law's promises.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/disc_gas.h"
#include "support/costly.h"

namespace {

using namespace nullscope;
using reference::gas_at;
using reference::GasFactors;

double kepler(double r) { return std::sqrt(0.5) / (r * std::sqrt(r)); }

DiscSpec disc_of(double contrast, double winding = 5) {
    DiscSpec disc;
    disc.material.texture = TextureKind::kGas;
    disc.gas = {contrast, winding};
    return disc;
}

constexpr double kAges = 1e5;  // r_s/c: time enough for every ring to stand anyhow to its neighbours

// At one radius, at random times and azimuths.
struct Ring {
    double light = 0, gaps = 0, square = 0;
};
Ring ring_of(const DiscSpec& disc, double r, double whole, int count, std::mt19937& random) {
    std::uniform_real_distribution<double> time(0, kAges), azimuth(-M_PI, M_PI);
    Ring ring;
    for (int i = 0; i < count; ++i) {
        const GasFactors gas = gas_at(disc, r, azimuth(random), time(random), whole, kepler);
        ring.light += gas.light / count, ring.gaps += gas.gaps / count, ring.square += gas.light * gas.light / count;
    }
    return ring;
}

// The ring's own cells and their neighbours are a few hundred numbers: that, and not the count of places, is what the mean is off by.
TEST_CASE("disc gas: over time the mean of its light is 1 at every radius" * test::costly()) {
    constexpr double kMean = 0.08, kMeanOfAll = 0.01;
    std::mt19937 random(11);
    const DiscSpec disc = disc_of(0.6);
    double worst = 0, light = 0, gaps = 0;
    constexpr int kRings = 48;
    for (int i = 0; i < kRings; ++i) {
        const double r = 1.5 * std::pow(20.0, i / (kRings - 1.0));
        const Ring ring = ring_of(disc, r, 1, 20000, random);
        worst = std::max({worst, std::abs(ring.light - 1), std::abs(ring.gaps - 1)});
        light += ring.light / kRings, gaps += ring.gaps / kRings;
    }
    fmt::print("disc gas: light {:.4f}, gaps {:.4f}, a ring's off by {:.4f} at most\n", light, gaps, worst);
    CHECK(worst < kMean);
    CHECK(std::abs(light - 1) < kMeanOfAll);
    CHECK(std::abs(gaps - 1) < kMeanOfAll);
}

TEST_CASE("disc gas: without contrast it is smooth, and more contrast spreads it more") {
    std::mt19937 random(3);
    double before = 0;
    for (const double contrast : {0.0, 0.3, 0.6, 1.0}) {
        const Ring ring = ring_of(disc_of(contrast), 6.0, 1, 20000, random);
        const double spread = ring.square - ring.light * ring.light;
        if (contrast == 0)
            CHECK(spread < 1e-10);  // rounding of sums
        else
            CHECK(spread > 1.5 * before);
        before = spread;
    }
}

// Two copies that fade into each other would halve it in between.
TEST_CASE("disc gas: its spread is the same at all times" * test::costly()) {
    constexpr double kBeat = 0.15;  // 1500 clumps and filaments of all sizes: a few large ones make most of it
    const DiscSpec disc = disc_of(0.4);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> depth(std::log(2.0), std::log(40.0)), azimuth(-M_PI, M_PI);
    double least = 1e9, most = 0;
    for (int frame = 0; frame < 24; ++frame) {
        double sum = 0, square = 0;
        constexpr int kPlaces = 40000;
        for (int i = 0; i < kPlaces; ++i) {
            const double light =
                gas_at(disc, std::exp(depth(random)), azimuth(random), 2000 + 3.7 * frame, 1, kepler).light;
            sum += light / kPlaces, square += light * light / kPlaces;
        }
        least = std::min(least, square - sum * sum), most = std::max(most, square - sum * sum);
    }
    fmt::print("disc gas: variance {:.4f} to {:.4f} over 24 frames\n", least, most);
    CHECK(most < (1 + kBeat) * least);
}

TEST_CASE("disc gas: no seam in azimuth, radius or time, and the same each time") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> depth(std::log(1.5), std::log(50.0)), azimuth(-M_PI, M_PI), time(0, 1e4);
    const DiscSpec disc = disc_of(0.7);
    constexpr double kStep = 1e-9;
    // A step over a seam changes the light by some tenth of itself; the finest octave's slope is some 3000 for each unit of ln r.
    constexpr double kSmooth = 1e-4;
    double worst = 0;
    const auto compare = [&](double r, double at, double t, double r2, double at2, double t2) {
        const double a = gas_at(disc, r, at, t, 1, kepler).light, b = gas_at(disc, r2, at2, t2, 1, kepler).light;
        worst = std::max(worst, std::abs(a - b) / (1 + a));
    };
    for (int i = 0; i < 20000; ++i) {
        const double r = std::exp(depth(random)), at = azimuth(random), t = time(random);
        compare(r, M_PI - kStep, t, r, -M_PI + kStep, t);
        compare(r, at, t, r * (1 + kStep), at, t);
        compare(r, at, t, r, at + kStep, t + kStep);
        CHECK(gas_at(disc, r, at, t, 1, kepler).light == gas_at(disc, r, at, t, 1, kepler).light);
    }
    for (int octave = 0; octave < 9; ++octave)  // where the rings of each octave meet, and cells of each
        for (int ring = 0; ring < 10; ++ring) {
            const double r = std::exp((ring - 0.37 * octave) * 0.3 / (1 << octave) + 1), at = azimuth(random);
            compare(r * (1 - kStep), at, 3, r * (1 + kStep), at, 3);
        }
    fmt::print("disc gas: steps of 1e-9 change it by {:.2g} at most\n", worst);
    CHECK(worst < kSmooth);
}

// Gas that has moved for a time t is still gas turned by Omega t, about each ring's own middle: to a share of its own width.
TEST_CASE("disc gas: it goes round with the disc") {
    const DiscSpec disc = disc_of(0.7);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> depth(std::log(3.0), std::log(12.0)), azimuth(-M_PI, M_PI);
    constexpr double kTime = 2.0;
    double along = 0, beside = 0, still = 0;
    for (int i = 0; i < 4000; ++i) {
        const double r = std::exp(depth(random)), at = azimuth(random), turned = kepler(r) * kTime;
        const double a = std::log(gas_at(disc, r, at, 100, 1, kepler).light + 0.01),
                     b = std::log(gas_at(disc, r, at + turned, 100 + kTime, 1, kepler).light + 0.01),
                     c = std::log(gas_at(disc, r, at - turned, 100 + kTime, 1, kepler).light + 0.01),
                     d = std::log(gas_at(disc, r, at, 100 + kTime, 1, kepler).light + 0.01);
        along += (a - b) * (a - b), beside += (a - c) * (a - c), still += (a - d) * (a - d);
    }
    fmt::print("disc gas: change along its orbit over that at rest {:.3f}, against the orbit {:.3f}\n", along / still,
               beside / still);
    CHECK(along < 0.5 * still);
    CHECK(beside > still);
}

}  // namespace
