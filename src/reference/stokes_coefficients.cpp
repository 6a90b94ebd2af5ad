#include "reference/stokes_coefficients.h"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/bessel.hpp>

#include "reference/electron.h"

namespace nullscope::reference {
namespace {

constexpr double kLeastFieldSine = 1e-3;

struct Ratios {
    double zero, one;  // of K_0 and K_1 to K_2
};
Ratios bessel_ratios(double x) {
    constexpr double kAsymptotic = 500;  // beyond: underflow
    if (x > kAsymptotic) return {1 - 2 / x * (1 - 1.5 / x), 1 - 1.5 / x};
    const double two = boost::math::cyl_bessel_k(2, x);
    return {boost::math::cyl_bessel_k(0, x) / two, boost::math::cyl_bessel_k(1, x) / two};
}

}  // namespace

StokesCoefficients thermal_stokes(double electrons, double temperature, double field, double cosine, double nu,
                                  bool faraday) {
    const double sine = std::max(std::sqrt(std::max(1 - cosine * cosine, 0.0)), kLeastFieldSine);
    const double theta = theta_of(temperature), gyro = gyro_frequency(field),
                 x = nu / (1.5 * gyro * sine * theta * theta);
    const double third = 1 / std::cbrt(x), intensity = 1 + third * (1.92 + third * 0.9977);
    StokesCoefficients found{};
    found.emitted_q = (1 + third * (0.93193 + third * 0.499873)) / intensity;
    const double circular = 1.81348 / x + 3.42319 * third * third + 0.0292545 / std::sqrt(x) + 2.03773 * third,
                 most = std::sqrt(1 - found.emitted_q * found.emitted_q);
    found.emitted_v = std::clamp(4 * cosine / (3 * theta * sine) * circular / (2.5651 * intensity), -most, most);
    if (!faraday) return found;
    const double plasma = electrons * kCharge * kCharge / (kElectron * kLight);
    const double big = theta * std::sqrt(std::sqrt(2.0) * 1000 * gyro * sine / nu);
    const Ratios ratios = bessel_ratios(1 / theta);
    const double lack = 0.43793091 * std::log1p(0.00185777 * std::pow(big, 1.50316886)),
                 rest = std::max(1 - lack / boost::math::cyl_bessel_k(0, 1 / std::max(theta, 1.0)), 0.0);
    found.rotation = 2 * plasma * gyro * cosine / (nu * nu) * ratios.zero * rest;
    const double far = 0.011 * std::exp(-big / 47.2),
                 ultra = std::pow(2.0, -1.0 / 3) / std::pow(3.0, 23.0 / 6) * 1e4 * M_PI * std::pow(big, -8.0 / 3);
    const double shape = 2.011 * std::exp(-std::pow(big, 1.035) / 4.7) -
                         std::cos(big / 2) * std::exp(-std::pow(big, 1.2) / 2.73) - far +
                         (far - ultra) * 0.5 * (1 + std::tanh(10 * std::log(big / 120)));
    found.conversion = plasma * gyro * gyro * sine * sine / (nu * nu * nu) * shape * (ratios.one + 6 * theta);
    return found;
}

}  // namespace nullscope::reference
