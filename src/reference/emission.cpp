#include "reference/emission.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/black_body.h"
#include "plan/medium.h"
#include "reference/chebyshev.h"
#include "reference/electron.h"
#include "reference/seen_light.h"
#include "scene/known_object.h"

namespace nullscope::reference {
namespace {

bool is_dark(double temperature, double field) { return temperature < kColdest_K || !(field > 0); }

}  // namespace

// e^x K_2, the integral of cosh(2t) exp(-2x sinh^2(t/2)): the trapezoidal rule converges faster than any power.
double scaled_bessel_k2_by_sum(double x) {
    const double step = std::min(1.0 / 8, 2.0 / 3 / std::sqrt(x));  // exp(-44) of it at most
    double sum = 0.5;
    for (double t = step;; t += step) {
        const double half = std::sinh(0.5 * t), term = std::cosh(2 * t) * std::exp(-2 * x * half * half);
        sum += term;
        if (x * half * half > 1 && term < 1e-17 * sum) return step * sum;
    }
}

// By its logarithm as a function of that of x, which is regular for arguments of x up to a quarter turn.
double bessel_k2(double x) {
    constexpr double kLeast = -16, kMost = 6;  // ln x
    constexpr std::size_t kTerms = 13, kPieces = 2 * static_cast<std::size_t>(kMost - kLeast);
    static const ChebyshevPieces<1, kTerms> pieces(
        [](double log_x) { return std::array{std::log(scaled_bessel_k2_by_sum(std::exp(log_x)))}; }, kLeast, kMost,
        kPieces);
    const double log_x = std::log(x);
    if (!pieces.holds(log_x)) return std::exp(-x) * scaled_bessel_k2_by_sum(x);
    return std::exp(pieces(log_x)[0] - x);
}

double synchrotron_at(double electrons, double temperature, double field, double sine, double nu) {
    if (is_dark(temperature, field)) return 0;
    const double theta = theta_of(temperature),
                 nu_s = 2.0 / 9 * gyro_frequency(field) * theta * theta * std::max(sine, 1e-3), x = nu / nu_s;
    constexpr double kPower = 1.8877486253633868;  // 2^(11/12)
    const double third = std::cbrt(x), shape = std::sqrt(x) + kPower * std::sqrt(third);
    return electrons * std::sqrt(2.0) * M_PI * kCharge * kCharge * nu_s / (3 * bessel_k2(1 / theta) * kLight) * shape *
           shape * std::exp(-third);
}

double synchrotron_mean(double electrons, double temperature, double field, double nu) {
    if (is_dark(temperature, field)) return 0;
    const double theta = theta_of(temperature), x = 2 * nu / (3 * gyro_frequency(field) * theta * theta);
    const double third = std::cbrt(x), half = std::sqrt(x);
    return kCharge * kCharge / (kLight * std::sqrt(3.0)) * electrons * nu / bessel_k2(1 / theta) * 4.0505 /
           std::sqrt(third) * (1 + 0.4 / std::sqrt(half) + 0.5316 / half) * std::exp(-1.8899 * third);
}

namespace {

// erg/(s cm^3 Hz sr) of thermal electrons among as many protons.
double bremsstrahlung(double electrons, double temperature, double nu) {
    const double t = std::max(temperature, 1.0), charge2 = kCharge * kCharge,
                 gaunt = std::max(std::sqrt(3.0) / M_PI * (17.7 + std::log(std::pow(t, 1.5) / nu)), 1.0);
    const double constant = 32 * M_PI * charge2 * charge2 * charge2 / (3 * kElectron * kLight * kLight * kLight) *
                            std::sqrt(2 * M_PI / (3 * kBoltzmann * kElectron)) / (4 * M_PI);
    return constant * electrons * electrons / std::sqrt(t) * std::exp(-kPlanck * nu / (kBoltzmann * t)) * gaunt;
}

}  // namespace

double planck(double temperature, double nu) {
    return 2 * kPlanck * nu * nu * nu / (kLight * kLight) / std::expm1(kPlanck * nu / (kBoltzmann * temperature));
}

namespace {

// Of a node along which source and absorption are even: light `emitted` along it without absorption.
MatterLight even_light(const MediumSpec& spec, double emitted, double depth) {
    const double share = depth > 1e-8 ? -std::expm1(-depth) / depth : 1 - 0.5 * depth;
    return {emitted * share * spec.brightness * spec.colour, std::exp(-depth)};
}

// Of a black body that is seen with its frequencies times `ratio`, over one of spec.temperature_K, whose brightness is unit_light.
MatterLight black_body_light(const MediumSpec& spec, const LightSpec& light, double unit_light, double temperature_K,
                             double ratio, double depth) {
    const Vec3 source = seen_black_body(temperature_K, ratio, light) / unit_light;
    const Vec3 coloured{source.x * spec.colour.x, source.y * spec.colour.y, source.z * spec.colour.z};
    return {-std::expm1(-depth) * spec.brightness * coloured, std::exp(-depth)};
}

}  // namespace

Emission::Emission(const Scene& scene) : spec_(*scene.medium), light_(scene.light) {
    unit_light_ = std::exp2(log2_brightness(spec_.temperature_K, light_.bolometric));
    unit_cgs_ = medium_light_cgs(spec_.frequency_GHz);
    length_cm_ = 100 * schwarzschild_radius_m(scene.object.mass().value_or(0.0));
    if (spec_.kind != MediumKind::kGas) opacity_ = spec_.opacity;
    if (spec_.has_electrons()) electrons_.emplace(spec_.electrons, spec_.field_direction == FieldDirection::kIsotropic);
}

Emission::Seen Emission::seen(const MatterState& matter, const PlaceMetric& g, const MediumNode& node, double energy,
                              double momentum) const {
    // The photon's covariant components; the ray is followed backward.
    const std::array<double, 4> k = {-energy, -g.g_rr * node.r_slope, -g.g_thetatheta * node.theta_slope, momentum};
    // The observer of no angular momentum: e_t = (d_t + omega d_phi)/lapse.
    const double omega = -g.g_tphi / g.g_phiphi, lapse = std::sqrt(g.g_tphi * g.g_tphi / g.g_phiphi - g.g_tt);
    const std::array<double, 4> along = {(k[0] + omega * k[3]) / lapse, k[1] / std::sqrt(g.g_rr),
                                         k[2] / std::sqrt(g.g_thetatheta), k[3] / std::sqrt(g.g_phiphi)};
    const std::array<double, 3> u = {matter.velocity.x, matter.velocity.y, matter.velocity.z};
    const double gamma = std::sqrt(1 + u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    const double out = u[0] * along[1] + u[1] * along[2] + u[2] * along[3];
    const double frequency = -(gamma * along[0] + out);
    if (spec_.field_direction == FieldDirection::kIsotropic) return {frequency, 0};
    // The field's unit vector, boosted with the matter.
    std::array<double, 3> b = {matter.field_way.x, matter.field_way.y, matter.field_way.z};
    if (spec_.field_direction != FieldDirection::kFile) {
        const Vec3 way = field_way_of(spec_);
        b = {way.x, way.y, way.z};
    }
    const double moved = u[0] * b[0] + u[1] * b[1] + u[2] * b[2],
                 straight = b[0] * along[1] + b[1] * along[2] + b[2] * along[3];
    return {frequency, (moved * along[0] + straight + moved / (1 + gamma) * out) / frequency};
}

MatterLight Emission::at(const MatterState& matter, const PlaceMetric& g, const MediumNode& node, double energy,
                         double momentum) const {
    const auto [frequency, cosine] = seen(matter, g, node, energy, momentum);
    const double ratio = 1 / frequency, length = node.way * frequency;
    if (spec_.law() == MediumEmission::kBlackBody)
        return black_body_light(spec_, light_, unit_light_, matter.temperature_K, ratio,
                                matter.density * opacity_ * length);
    const double shift = light_.shift ? frequency : 1, bright = light_.beaming ? ratio * ratio * ratio : 1;
    const auto [emitted, absorbed] = coefficients(matter, 1e9 * spec_.frequency_GHz * shift, cosine);
    return even_light(spec_, bright * emitted * length * length_cm_ / unit_cgs_, absorbed * length * length_cm_);
}

Emission::Coefficients Emission::coefficients(const MatterState& matter, double nu, double cosine) const {
    double emitted = 0;
    switch (spec_.law()) {
        case MediumEmission::kPowerLaw: {
            constexpr double kReference = 230e9;
            const double along = spec_.emissivity * matter.density, x = nu / kReference;
            return {along * std::pow(x, -spec_.spectral_index),
                    spec_.absorption * along * std::pow(x, -2.5 - spec_.spectral_index)};
        }
        case MediumEmission::kBlackBody: break;
        case MediumEmission::kSynchrotron:
            if (electrons_) {
                const ElectronLight light =
                    electrons_->at(matter.density, matter.temperature_K, matter.field_G, cosine, nu);
                return {light.emissivity, light.absorptivity};
            }
            emitted = spec_.field_direction == FieldDirection::kIsotropic
                          ? synchrotron_mean(matter.density, matter.temperature_K, matter.field_G, nu)
                          : synchrotron_at(matter.density, matter.temperature_K, matter.field_G,
                                           std::sqrt(std::max(1 - cosine * cosine, 0.0)), nu);
            break;
        case MediumEmission::kBremsstrahlung: emitted = bremsstrahlung(matter.density, matter.temperature_K, nu); break;
    }
    return {emitted, emitted > 0 ? emitted / planck(matter.temperature_K, nu) : 0};  // Kirchhoff's law
}

}  // namespace nullscope::reference
