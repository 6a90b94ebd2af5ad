#include "light/black_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/cie_1931.h"

namespace nullscope {
namespace {

// CODATA 2018, exact by definition of the units.
constexpr double kPlanck_Js = 6.62607015e-34, kLight_m_s = 299792458.0, kBoltzmann_J_K = 1.380649e-23;
constexpr double kPlanckLight = kPlanck_Js * kLight_m_s;  // J m

// Planck's law at one wavelength, W sr^-1 m^-2 a metre of it: scale/(exp(hc/(heat temperature)) - 1). What does not depend on the temperature
// is formed once: a power costs as much as the exponential.
struct PlanckTerm {
    double scale, heat;
};
std::array<PlanckTerm, kCie1931.size()> planck_terms() {
    std::array<PlanckTerm, kCie1931.size()> terms{};
    double wavelength_nm = kCieFirst_nm;
    for (PlanckTerm& term : terms) {
        const double wavelength_m = 1e-9 * wavelength_nm;
        term = {2.0 * kPlanckLight * kLight_m_s / std::pow(wavelength_m, 5), wavelength_m * kBoltzmann_J_K};
        wavelength_nm += kCieStep_nm;
    }
    return terms;
}

const std::array<PlanckTerm, kCie1931.size()>& known_terms() {
    static const std::array<PlanckTerm, kCie1931.size()> terms = planck_terms();
    return terms;
}

}  // namespace

Vec3 black_body_xyz(double temperature_K) {
    const std::array<PlanckTerm, kCie1931.size()>& terms = known_terms();
    Vec3 sum{0, 0, 0};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const double radiance = terms[i].scale / std::expm1(kPlanckLight / (terms[i].heat * temperature_K));
        sum = sum + radiance * Vec3{kCie1931[i].x, kCie1931[i].y, kCie1931[i].z};
    }
    return 1e-9 * kCieStep_nm * sum;
}

// d/dT of scale/(e^x - 1), x = hc/(heat T): scale x/T (1 + 1/(e^x - 1))/(e^x - 1).
BlackBodySlope black_body_slope(double temperature_K) {
    const std::array<PlanckTerm, kCie1931.size()>& terms = known_terms();
    BlackBodySlope sum;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const double x = kPlanckLight / (terms[i].heat * temperature_K), share = 1 / std::expm1(x);
        const Vec3 radiance = terms[i].scale * share * Vec3{kCie1931[i].x, kCie1931[i].y, kCie1931[i].z};
        sum.xyz = sum.xyz + radiance, sum.slope = sum.slope + x / temperature_K * (1 + share) * radiance;
    }
    constexpr double kWidth = 1e-9 * kCieStep_nm;
    return {kWidth * sum.xyz, kWidth * sum.slope};
}

Vec3 rec709_from_xyz(Vec3 c) {
    return {3.2409699419 * c.x - 1.5373831776 * c.y - 0.4986107603 * c.z,
            -0.9692436363 * c.x + 1.8759675015 * c.y + 0.0415550574 * c.z,
            0.0556300797 * c.x - 0.2039769589 * c.y + 1.0569715142 * c.z};
}

Vec3 into_gamut(Vec3 c) {
    const double least = std::min({c.x, c.y, c.z});
    if (least >= 0.0) return c;
    const double y = 0.2126390059 * c.x + 0.7151686788 * c.y + 0.0721923154 * c.z;  // > 0 for light
    const double keep = y / (y - least);
    return {y + keep * (c.x - y), y + keep * (c.y - y), y + keep * (c.z - y)};
}

double log2_brightness(double temperature_K, bool bolometric) {
    return bolometric ? 4.0 * std::log2(temperature_K) : std::log2(black_body_xyz(temperature_K).y);
}

}  // namespace nullscope
