// Electrons of a power law and of a kappa distribution: the reference's coefficients against sums over the harmonics of their gyration
// (tests/vectors/electrons.csv), closed forms, a cold plasma and thermal electrons; the shader's table against the reference.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "reference/electron_light.h"
#include "reference/emission.h"
#include "reference/stokes_coefficients.h"
#include "reference/synchrotron_integrals.h"
#include "support/folders.h"
#include "table/electron_table.h"

using namespace nullscope;
using reference::SynchrotronElectrons;

namespace {

constexpr double kRest_K = 5.92989658e9, kCyclotron_Hz = 2.79924899e6;  // m c^2/k; e/(2 pi m c) a gauss
constexpr double kCharge2 = 7.69566e-30, kRefraction = 8.447972557e-3;  // e^2/c, erg s; e^2/(m c), cm^2/s
constexpr double kElectron_g = 9.1093837e-28, kSpeed = 2.99792458e10;

ElectronSpec power_law(double p, double low, double high) { return {ElectronKind::kPowerLaw, p, low, high, 0}; }
ElectronSpec kappa_law(double kappa) { return {ElectronKind::kKappa, 0, 1, 1, kappa}; }

std::vector<std::vector<double>> rows_of_vectors() {
    std::ifstream file(test::data_folder() / "vectors/electrons.csv");
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#' || line[0] == 'p') continue;
        std::istringstream words(line);
        std::vector<double>& row = rows.emplace_back();
        for (std::string word; std::getline(words, word, ',');) row.push_back(std::stod(word));
    }
    return rows;
}

}  // namespace

TEST_CASE("electrons: j and alpha of I, Q, V are sums over harmonics") {
    // Formulas are of ultrarelativistic electrons: worst at 100 nu_B.
    constexpr double kHarmonics = 0.022;  // 0.0197 of V at 100 nu_B, w = 3
    const auto rows = rows_of_vectors();
    REQUIRE(rows.size() == 40);
    std::array<double, 4> worst{};  // below and above 1000 nu_B
    for (const auto& row : rows) {
        const bool kappa = row[3] > 0;
        const SynchrotronElectrons electrons(kappa ? kappa_law(row[3]) : power_law(row[0], row[1], row[2]), false);
        const double field = 30, nu = row[5] * kCyclotron_Hz * field, unit = kCharge2 * kCyclotron_Hz * field;
        const auto found = electrons.at(1, row[4] * kRest_K, field, std::cos(row[6]), nu);
        const double j = found.emissivity / unit, a = found.absorptivity / unit * 2 * kElectron_g * nu * nu;
        const double told[] = {j, j * found.emitted_q,  j * found.emitted_v,
                               a, a * found.absorbed_q, a * found.absorbed_v};
        const std::size_t part = (kappa ? 2 : 0) + (row[5] > 1000 ? 1 : 0);
        INFO("p ", row[0], " kappa ", row[3], " w ", row[4], " nu/nu_B ", row[5]);
        for (std::size_t i = 0; i < 6; ++i) {
            CHECK(told[i] == doctest::Approx(row[7 + i]).epsilon(kHarmonics));
            worst[part] = std::max(worst[part], std::abs(told[i] / row[7 + i] - 1));
        }
    }
    fmt::print(
        "electrons: of sums over harmonics, power law within {:.2g}, {:.2g} above 1000 nu_B, kappa {:.2g}, {:.2g}\n",
        worst[0], worst[1], worst[2], worst[3]);
}

// Far from both ends, Rybicki and Lightman 1979, 6.36 and 6.53; fractions of Q (p + 1)/(p + 7/3) and (p + 2)/(p + 10/3).
TEST_CASE("electrons: a power law between its ends has its closed form") {
    for (const double p : {1.5, 2.0, 3.0, 4.0}) {
        const SynchrotronElectrons electrons(power_law(p, 10, 1e7), false);
        const double field = 10, cosine = 0.5, sine = std::sqrt(0.75), nu = 1e14,
                     x = nu / (kCyclotron_Hz * field * sine);
        const auto found = electrons.at(1, 0, field, cosine, nu);
        const double norm = (p - 1) / (std::pow(10, 1 - p) - std::pow(1e7, 1 - p)),
                     unit = norm * kCharge2 * kCyclotron_Hz * field * sine;
        const double emitted = unit * std::sqrt(3.0) / (p + 1) * 0.5 * std::tgamma(p / 4 + 19.0 / 12) *
                               std::tgamma(p / 4 - 1.0 / 12) * std::pow(x / 3, -(p - 1) / 2),
                     absorbed = unit * std::sqrt(3.0) / 4 * std::tgamma((3 * p + 2) / 12) *
                                std::tgamma((3 * p + 22) / 12) * std::pow(x / 3, -p / 2) * 1 / (kElectron_g * nu * nu);
        INFO("p ", p);
        CHECK(found.emissivity == doctest::Approx(emitted).epsilon(p < 2 ? 0.02 : 1e-3));
        CHECK(found.absorptivity == doctest::Approx(absorbed).epsilon(1e-3));
        CHECK(found.emitted_q == doctest::Approx((p + 1) / (p + 7.0 / 3)).epsilon(p < 2 ? 0.02 : 1e-3));
        CHECK(found.absorbed_q == doctest::Approx((p + 2) / (p + 10.0 / 3)).epsilon(1e-3));
    }
}

// Light along and across the field: Appleton and Hartree's refractive indices.
TEST_CASE("electrons: Faraday's of slow ones are a cold plasma's") {
    const SynchrotronElectrons electrons(power_law(2, 1, 1.001), false);
    const double density = 1e4, field = 2, nu = 3e9;
    const double x = density * kRefraction * kSpeed / M_PI / (nu * nu), y = kCyclotron_Hz * field / nu;
    const auto along = electrons.at(density, 0, field, 1, nu), across = electrons.at(density, 0, field, 0, nu);
    const double right = std::sqrt(1 - x / (1 - y)), left = std::sqrt(1 - x / (1 + y));
    CHECK(along.rotation == doctest::Approx(2 * M_PI * nu / kSpeed * (left - right)).epsilon(0.01));
    const double ordinary = std::sqrt(1 - x), extraordinary = std::sqrt(1 - x * (1 - x) / (1 - x - y * y));
    CHECK(across.conversion == doctest::Approx(2 * M_PI * nu / kSpeed * (ordinary - extraordinary)).epsilon(0.02));
}

// Of a power law at high frequencies: rotation falls as (p - 1)/(p + 1) (ln(2 gamma_min) + 1/(p + 1))/gamma_min^2, conversion grows by 2 <gamma>.
TEST_CASE("electrons: Faraday's of fast ones at high frequencies") {
    const double p = 3.5, low = 50, density = 1e5, field = 1e-6, cosine = 0.6, nu = 1e12;
    const SynchrotronElectrons electrons(power_law(p, low, 1e6), false);
    const auto found = electrons.at(density, 0, field, cosine, nu);
    const double gyro = kCyclotron_Hz * field, turn = kRefraction * density * gyro / (nu * nu);
    CHECK(found.rotation / (2 * turn * cosine) ==
          doctest::Approx((p - 1) / (p + 1) * (std::log(2 * low) + 1 / (p + 1)) / (low * low)).epsilon(2e-3));
    CHECK(found.conversion / (turn * gyro / nu * (1 - cosine * cosine)) ==
          doctest::Approx(2 * low * (p - 1) / (p - 2)).epsilon(2e-3));
}

TEST_CASE("electrons: a large kappa has the light and Faraday's numbers of thermal electrons") {
    const SynchrotronElectrons electrons(kappa_law(2000), false);
    for (const double theta : {10.0, 30.0})
        for (const double x : {1.0, 10.0, 30.0}) {
            const double field = 20, cosine = 0.4, sine = std::sqrt(1 - cosine * cosine), density = 1e4;
            const double temperature = theta * kRest_K, nu = x * 1.5 * kCyclotron_Hz * field * sine * theta * theta;
            const auto found = electrons.at(density, temperature, field, cosine, nu);
            const auto thermal = reference::thermal_stokes(density, temperature, field, cosine, nu, true);
            const double emitted = reference::synchrotron_at(density, temperature, field, sine, nu);
            INFO("theta ", theta, " nu/nu_c ", x);
            CHECK(found.emissivity == doctest::Approx(emitted).epsilon(0.03));
            CHECK(found.absorptivity == doctest::Approx(emitted / reference::planck(temperature, nu)).epsilon(0.03));
            CHECK(found.emitted_q == doctest::Approx(thermal.emitted_q).epsilon(0.02));
            CHECK(found.absorbed_q == doctest::Approx(found.emitted_q).epsilon(0.01));
            CHECK(found.emitted_v == doctest::Approx(thermal.emitted_v).epsilon(0.02));
            CHECK(found.rotation == doctest::Approx(thermal.rotation).epsilon(0.03));
            CHECK(found.conversion == doctest::Approx(thermal.conversion).epsilon(0.04));
        }
}

// Between X = 1 and 100, where they were fitted; at higher frequencies the fit of conversion stays where it is, the integral grows on.
TEST_CASE("electrons: Faraday's of kappa = 5 are near the fits of Marszewski et al. 2021 (ApJ 921, 17)") {
    constexpr double kFit = 0.09;
    const SynchrotronElectrons electrons(kappa_law(5), false);
    const double field = 20, cosine = 0.4, sine = std::sqrt(1 - cosine * cosine), w = 20;
    double worst = 0;
    for (const double x : {1.0, 3.0, 10.0, 30.0, 100.0}) {
        const double gyro = kCyclotron_Hz * field, nu = x * gyro * sine * 25 * w * w,
                     turn = kRefraction * gyro / (nu * nu);
        const auto found = electrons.at(1, w * kRest_K, field, cosine, nu);
        const double converted = turn * gyro * sine * sine / nu * (12.5 * w - std::sqrt(w)) *
                                 (1 - std::exp(-std::pow(x, 0.84) / 8) -
                                  std::sin(0.375 * x) * std::exp(-2.25 * std::pow(x, 0.541))),
                     turned = 2 * turn * cosine * std::cyl_bessel_k(0, 1 / w) / std::cyl_bessel_k(2, 1 / w) *
                              (1 - 0.17 * std::log(1 + 0.313 / std::sqrt(x))) * (w + 13.0 / 14) / (2 * w + 13.0 / 14);
        for (const double ratio : {found.conversion / converted, found.rotation / turned})
            worst = std::max(worst, std::abs(ratio - 1));
    }
    fmt::print("electrons: rotation and conversion within {:.2g} of published fits\n", worst);
    CHECK(worst < kFit);
}

TEST_CASE("electrons: the shader's table is the reference's integrals") {
    constexpr double kTable = 2e-4;  // of its texels
    for (const bool kappa : {false, true})
        for (const bool isotropic : {false, true}) {
            const ElectronEnergies energies{kappa, kappa ? 3.8 : 2.6, 20, 1e4, isotropic};
            const ElectronSpec spec = kappa ? kappa_law(3.8) : power_law(2.6, 20, 1e4);
            const TexelGrid grid = electron_texels(energies);
            const ElectronCells cells = electron_cells(energies);
            const auto texel = [&](int cell, int row) {
                return grid.texels.data() +
                       4 * (static_cast<std::size_t>(row) * (kElectronCells + 1) + static_cast<std::size_t>(cell));
            };
            for (int cell = 12; cell < kElectronCells - 20; cell += 97) {
                const auto i =
                    reference::electron_integrals(spec, isotropic, std::exp2(cells.first + cell / cells.per_octave));
                INFO("kappa ", kappa, " isotropic ", isotropic, " cell ", cell);
                const float *first = texel(cell, 0), *second = texel(cell, 1);
                CHECK(std::exp2(first[0]) == doctest::Approx(i.emitted).epsilon(kTable));
                CHECK(std::exp2(first[1]) == doctest::Approx(i.absorbed).epsilon(kTable));
                if (isotropic) continue;
                CHECK(first[2] == doctest::Approx(i.emitted_q / i.emitted).epsilon(kTable));
                CHECK(first[3] == doctest::Approx(i.absorbed_q / i.absorbed).epsilon(kTable));
                CHECK(std::exp2(second[0]) == doctest::Approx(i.emitted_v / i.emitted).epsilon(kTable));
                CHECK(std::exp2(second[1]) == doctest::Approx(i.absorbed_v / i.absorbed).epsilon(kTable));
                const double measure = std::exp2(static_cast<double>(second[2]));
                CHECK(std::abs(measure * second[3] - i.conversion) < kTable * measure);
                const double turned = texel(cell, 2)[0];
                CHECK(std::abs(turned - i.rotation) < kTable * std::abs(texel(12, 2)[0]));
            }
            for (int cell = 50; cell < kElectronCells; cell += 200) {
                const double log2_w = kElectronColdest + (kElectronHottest - kElectronColdest) * cell / kElectronCells;
                const auto means = reference::electron_means(spec, std::exp2(log2_w));
                const float* third = texel(cell, 2);
                INFO("kappa ", kappa, " log2 w ", log2_w);
                if (kappa)
                    CHECK(std::exp2(third[1]) == doctest::Approx(std::exp2(3 * log2_w) / means.sum).epsilon(kTable));
                CHECK(std::exp2(third[2]) == doctest::Approx(means.rotation).epsilon(kTable));
                CHECK(std::exp2(third[3]) == doctest::Approx(means.inverse).epsilon(kTable));
            }
        }
}
