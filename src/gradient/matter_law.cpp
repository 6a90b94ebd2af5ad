#include "gradient/matter_law.h"

#include <algorithm>
#include <cmath>

#include "plan/medium.h"

namespace nullscope::matter_law {
namespace {

// Cgs, CODATA 2018.
constexpr double kCharge = 4.80320471e-10, kLight = 2.99792458e10, kElectron = 9.1093837e-28, kBoltzmann = 1.380649e-16,
                 kPlanck = 6.62607015e-27;

Number gyro_frequency(const Number& field) { return kCharge / (2 * M_PI * kElectron * kLight) * field; }  // Hz
Number theta_of(const Number& temperature) { return kBoltzmann / (kElectron * kLight * kLight) * temperature; }
bool is_dark(const Number& temperature, const Number& field) {
    return temperature.value < kColdest_K || !(field.value > 0);
}

}  // namespace

Number power(const Number& base, double exponent) {
    const double value = std::pow(base.value, exponent);
    return chained(base, value, exponent * value / base.value);
}

// e^x K_2 is the integral of cosh(2t) exp(-2x sinh^2(t/2)) over t > 0, of an even function that falls faster than any exponential: the trapezoidal rule
// converges geometrically. Its derivative by x has -2 sinh^2(t/2) more.
Number log_scaled_bessel_k2(const Number& x) {
    constexpr double kNegligible = 1e-16, kLongest = 0.16;
    const double step = std::min(kLongest, 0.8 / std::sqrt(x.value));
    double sum = 0.5, slope = 0, grown = 1;  // grown: e^t
    const double growth = std::exp(step);
    for (int i = 1; i < 4000; ++i) {
        grown *= growth;
        const double less = 1 / grown, twice_half2 = 0.5 * (grown + less) - 1;
        const double term = 0.5 * (grown * grown + less * less) * std::exp(-x.value * twice_half2);
        sum += term, slope -= term * twice_half2;
        if (x.value * twice_half2 > 2 && term * twice_half2 < kNegligible * sum) break;
    }
    return chained(x, std::log(step * sum), slope / sum);
}

Number synchrotron_at(const Number& electrons, const Number& temperature, const Number& field, const Number& sine,
                      const Number& nu) {
    if (is_dark(temperature, field)) return Number(0.0);
    constexpr double kPower = 1.8877486253633868, kLeastSine = 1e-3;  // 2^(11/12)
    const Number theta = theta_of(temperature), colder = 1.0 / theta;
    const Number nu_s =
        2.0 / 9 * (gyro_frequency(field) * theta * theta * (sine.value > kLeastSine ? sine : Number(kLeastSine)));
    const Number sixth = power(nu / nu_s, 1.0 / 6), third = sixth * sixth, shape = third * sixth + kPower * sixth;
    constexpr double kConstant = M_SQRT2 * M_PI * kCharge * kCharge / (3 * kLight);
    return kConstant * (electrons * nu_s * shape * shape * exp(colder - third - log_scaled_bessel_k2(colder)));
}

Number synchrotron_mean(const Number& electrons, const Number& temperature, const Number& field, const Number& nu) {
    if (is_dark(temperature, field)) return Number(0.0);
    const Number theta = theta_of(temperature), colder = 1.0 / theta;
    const Number x = 2.0 / 3 * (nu / (gyro_frequency(field) * theta * theta));
    const Number twelfth = power(x, 1.0 / 12), quarter = twelfth * twelfth * twelfth, third = quarter * twelfth;
    constexpr double kConstant = kCharge * kCharge / (kLight * 1.7320508075688772) * 4.0505;
    const Number shape = 1.0 + 0.4 / quarter + 0.5316 / (quarter * quarter);
    return kConstant *
           (electrons * nu / (twelfth * twelfth) * shape * exp(colder - 1.8899 * third - log_scaled_bessel_k2(colder)));
}

Number bremsstrahlung(const Number& electrons, const Number& temperature, const Number& nu) {
    constexpr double kCharge2 = kCharge * kCharge;
    static const double constant = 32 * M_PI * kCharge2 * kCharge2 * kCharge2 /
                                   (3 * kElectron * kLight * kLight * kLight) *
                                   std::sqrt(2 * M_PI / (3 * kBoltzmann * kElectron)) / (4 * M_PI);
    const Number t = temperature.value < 1 ? Number(1.0) : temperature;
    Number gaunt = std::sqrt(3.0) / M_PI * (17.7 + 1.5 * log(t) - log(nu));
    if (gaunt.value < 1) gaunt = Number(1.0);
    return constant * (electrons * electrons / sqrt(t) * exp(-(kPlanck / kBoltzmann) * (nu / t)) * gaunt);
}

Number planck(const Number& temperature, const Number& nu) {
    const Number x = kPlanck / kBoltzmann * (nu / temperature);
    return 2 * kPlanck / (kLight * kLight) * (nu * nu * nu / chained(x, std::expm1(x.value), std::exp(x.value)));
}

}  // namespace nullscope::matter_law
