#include "reference/electron_light.h"

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "reference/chebyshev.h"
#include "reference/electron.h"
#include "reference/synchrotron_integrals.h"

namespace nullscope::reference {
namespace {

constexpr std::size_t kIntegrals = 8, kLogarithms = 6, kTerms = 13;
constexpr double kLeastAcross = 1e-3, kWidestPiece = 2;  // of pieces of ln s

std::array<double, kIntegrals> as_array(const ElectronIntegrals& i) {
    return {i.emitted, i.emitted_q, i.emitted_v, i.absorbed, i.absorbed_q, i.absorbed_v, i.conversion, i.rotation};
}

}  // namespace

// By ln s, logarithms but for Faraday's, and by ln w, logarithms.
struct SynchrotronElectrons::Tables {
    Tables(const ElectronSpec& e, bool isotropic)
        : by_frequency(
              [&](double log_s) {
                  auto values = as_array(electron_integrals(e, isotropic, std::exp(log_s)));
                  for (std::size_t i = 0; i < kLogarithms; ++i) values[i] = std::log(std::max(values[i], 1e-306));
                  return values;
              },
              low(e), high(e), static_cast<std::size_t>(std::ceil((high(e) - low(e)) / kWidestPiece))),
          by_width(
              [&](double log_w) {
                  const ElectronMeans m = electron_means(e, std::exp(log_w));
                  return std::array{std::log(m.rotation), std::log(m.inverse), std::log(m.sum)};
              },
              std::log(0.05), std::log(3e4), e.kind == ElectronKind::kKappa ? 27 : 1) {}
    static double low(const ElectronSpec& e) {
        return 2 * std::log(e.kind == ElectronKind::kKappa ? 1 / e.kappa : e.gamma_min) - 16;
    }
    static double high(const ElectronSpec& e) {
        return e.kind == ElectronKind::kKappa ? 24 : 2 * std::log(e.gamma_max) + 6;
    }
    ChebyshevPieces<kIntegrals, kTerms> by_frequency;
    ChebyshevPieces<3, kTerms> by_width;
};

SynchrotronElectrons::SynchrotronElectrons(const ElectronSpec& electrons, bool isotropic)
    : spec_(electrons), isotropic_(isotropic), tables_(std::make_shared<const Tables>(electrons, isotropic)) {}

ElectronLight SynchrotronElectrons::at(double density, double temperature, double field, double cosine,
                                       double nu) const {
    const bool kappa = spec_.kind == ElectronKind::kKappa;
    if (!(field > 0)) return {};
    // N = count u^2 f of energies gamma = wide u.
    const double w = theta_of(std::max(temperature, kColdest_K));
    const auto [log_rotation, log_inverse, log_sum] = tables_->by_width(kappa ? std::log(w) : 0.0);
    double wide = 1, count = 1;
    if (kappa) {
        wide = std::max(spec_.kappa * w - 1, 1.0);
        count = std::pow(spec_.kappa * w / wide, spec_.kappa + 1) * wide * wide * wide * std::exp(-log_sum);
    }
    const double sine = isotropic_ ? 1 : std::max(std::sqrt(std::max(1 - cosine * cosine, 0.0)), kLeastAcross);
    const double gyro = gyro_frequency(field), s = nu / (1.5 * gyro * sine * wide * wide), log_s = std::log(s);
    std::array<double, kIntegrals> i{};
    if (tables_->by_frequency.holds(log_s)) {
        i = tables_->by_frequency(log_s);
        for (std::size_t n = 0; n < kLogarithms; ++n) i[n] = std::exp(i[n]);
    } else {
        i = as_array(electron_integrals(spec_, isotropic_, s));
    }
    const auto [emitted, emitted_q, emitted_v, absorbed, absorbed_q, absorbed_v, conversion, rotation] = i;
    ElectronLight light{};
    const bool dark = !(emitted > 0) || (kappa && temperature < kColdest_K);
    const double unit = std::sqrt(3.0) / 2 * kCharge * kCharge / kLight * gyro * sine * count * density;
    if (!dark) {
        const double v = 4 * cosine / (3 * sine * wide);
        const auto circular = [&](double share, double linear) {
            const double most = std::sqrt(std::max(1 - linear * linear, 0.0));
            return std::clamp(v * share, -most, most);
        };
        light.emissivity = unit * emitted;
        light.absorptivity = unit * absorbed / (wide * 2 * kElectron * nu * nu);
        light.emitted_q = emitted_q / emitted, light.emitted_v = circular(emitted_v / emitted, light.emitted_q);
        light.absorbed_q = absorbed_q / absorbed, light.absorbed_v = circular(absorbed_v / absorbed, light.absorbed_q);
    }
    if (isotropic_) return light;
    const double turn = density * kCharge * kCharge / (kElectron * kLight) * gyro / (nu * nu);
    light.conversion = turn * gyro * sine * sine / nu * (count * wide * conversion - std::exp(log_inverse));
    light.rotation = 2 * turn * cosine * std::max(std::exp(log_rotation) + count / (wide * wide) * rotation, 0.0);
    return light;
}

}  // namespace nullscope::reference
