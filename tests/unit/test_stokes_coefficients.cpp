// The reference's polarised coefficients of thermal electrons: against direct integrals over energies, and Faraday's against a cold plasma's dispersion
// and the limit of hot electrons.
#include <doctest/doctest.h>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <random>

#include "reference/matter_stokes.h"
#include "reference/stokes_coefficients.h"

using namespace nullscope;
using reference::thermal_stokes;

namespace {

constexpr double kFitError = 0.011;  // of ratios to I, of which each is within 0.9 % of its integral
constexpr double kElectron_K = 5.92989658e9, kGyro_Hz = 2.79924899e6;  // m c^2/k; e/(2 pi m c) a gauss
constexpr double kPlasma = 8.447972557e-3;                             // e^2/(m c), cm^2/s

double bessel(double order, double x) { return boost::math::cyl_bessel_k(order, x); }

double bessel_beyond(double order, double x) {
    static boost::math::quadrature::exp_sinh<double> rule;
    return rule.integrate([&](double t) { return t < 600 ? bessel(order, t) : 0.0; }, x,
                          std::numeric_limits<double>::infinity(), 1e-8);
}

// Of ultrarelativistic electrons: integrals over z = gamma/theta of z^power exp(-z) shape(x/z^2), over x.
template <class Shape>
double over_energies(double x, int power, const Shape& shape) {
    static boost::math::quadrature::tanh_sinh<double> rule;
    return rule.integrate(
               [&](double z) {
                   const double u = x / (z * z);
                   return u < 500 ? std::pow(z, power) * std::exp(-z) * shape(u) : 0.0;
               },
               1e-3, 60.0, 1e-6) /
           x;
}

}  // namespace

TEST_CASE("polarised coefficients: Q and V of thermal electrons are their integrals over energies") {
    for (int i = 0; i < 20; ++i) {
        const double x = std::pow(10.0, -3.0 + 0.3 * i), theta = 60 + 10 * i, cosine = -0.9 + 0.09 * i,
                     sine = std::sqrt(1 - cosine * cosine), field = 30;
        const double nu = x * 1.5 * kGyro_Hz * field * sine * theta * theta;
        const auto found = thermal_stokes(1, theta * kElectron_K, field, cosine, nu, false);
        const double intensity = over_energies(x, 2, [](double u) { return u * bessel_beyond(5.0 / 3, u); }),
                     linear = over_energies(x, 2, [](double u) { return u * bessel(2.0 / 3, u); }),
                     circular = over_energies(
                         x, 1, [](double u) { return u * bessel(1.0 / 3, u) + bessel_beyond(1.0 / 3, u); });
        INFO("nu/nu_c ", x);
        CHECK(found.emitted_q == doctest::Approx(linear / intensity).epsilon(kFitError));
        CHECK(found.emitted_v ==
              doctest::Approx(4 * cosine / (3 * theta * sine) * circular / intensity).epsilon(kFitError));
    }
}

// Light along and across the field: Appleton and Hartree's refractive indices.
TEST_CASE("polarised coefficients: Faraday's of cold electrons are a cold plasma's") {
    const double electrons = 1e4, field = 2, nu = 3e9, cold = 1e7, speed = 2.99792458e10;
    const double plasma2 = electrons * kPlasma * speed / M_PI, gyro = kGyro_Hz * field;  // Hz^2, Hz
    const double x = plasma2 / (nu * nu), y = gyro / nu;
    const auto along = thermal_stokes(electrons, cold, field, 1, nu, true),
               across = thermal_stokes(electrons, cold, field, 0, nu, true);
    const double right = std::sqrt(1 - x / (1 - y)), left = std::sqrt(1 - x / (1 + y));
    CHECK(along.rotation == doctest::Approx(2 * M_PI * nu / speed * (left - right)).epsilon(0.01));
    const double ordinary = std::sqrt(1 - x), extraordinary = std::sqrt(1 - x * (1 - x) / (1 - x - y * y));
    CHECK(across.conversion == doctest::Approx(2 * M_PI * nu / speed * (ordinary - extraordinary)).epsilon(0.02));
    CHECK(std::abs(across.rotation) < 1e-12 * along.rotation);
}

// Of hot electrons in a weak field rotation falls as K_0/K_2 -> (ln(2 theta) - 0.5772)/(2 theta^2).
TEST_CASE("polarised coefficients: rotation by hot electrons") {
    const double electrons = 1e5, field = 1e-3, nu = 230e9;
    for (const double theta : {20.0, 100.0, 1000.0}) {
        const auto found = thermal_stokes(electrons, theta * kElectron_K, field, 0.5, nu, true);
        const double cold = 2 * kPlasma * electrons * kGyro_Hz * field * 0.5 / (nu * nu);
        CHECK(found.rotation / cold ==
              doctest::Approx((std::log(2 * theta) - 0.5772156649) / (2 * theta * theta)).epsilon(0.02));
    }
}

// Rotation alone turns linear light by rho_V/2 of the way, conversion makes V of U; all together as powers of the matrix.
TEST_CASE("polarised coefficients: the reference's even matter") {
    const auto turned = reference::even_light({0, {}, {0, 0, 0.8}, {}});
    CHECK(turned.through[2][1] == doctest::Approx(std::sin(0.8)));
    CHECK(turned.through[1][2] == doctest::Approx(-std::sin(0.8)));
    const auto converted = reference::even_light({0, {}, {0.8, 0, 0}, {}});
    CHECK(converted.through[3][2] == doctest::Approx(std::sin(0.8)));
    // Absorption and emission in I and Q alone: two modes, each with its own depth.
    const auto dichroic = reference::even_light({1.0, {0.5, 0, 0}, {}, {2.0, 0.6, 0, 0}});
    const double both = 2.6 * -std::expm1(-1.5) / 1.5, other = 1.4 * -std::expm1(-0.5) / 0.5;
    CHECK(dichroic.light[0] == doctest::Approx(0.5 * (both + other)));
    CHECK(dichroic.light[1] == doctest::Approx(0.5 * (both - other)));
    CHECK(dichroic.through[0][1] == doctest::Approx(0.5 * (std::exp(-1.5) - std::exp(-0.5))));
}
