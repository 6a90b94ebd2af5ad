#include "table/synchrotron_kernels.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

struct Bessels {
    double third, two_thirds, third_beyond;  // K_1/3, K_2/3, integral of K_1/3 beyond x
};
// Integrals over t of exp(-x cosh t) cosh(n t), over cosh t of the last: the trapezoidal rule converges faster than any power.
Bessels bessels(double x) {
    const double step = std::min(0.25, 0.7 / std::sqrt(x)), end = x + 45.0;
    Bessels sum{0.5, 0.5, 0.5};
    for (double t = step;; t += step) {
        const double wide = std::cosh(t);
        if (x * wide > end) break;
        const double term = std::exp(-x * (wide - 1.0)), third = term * std::cosh(t / 3.0);
        sum.third += third;
        sum.two_thirds += term * std::cosh(2.0 * t / 3.0);
        sum.third_beyond += third / wide;
    }
    const double scale = step * std::exp(-x);
    return {scale * sum.third, scale * sum.two_thirds, scale * sum.third_beyond};
}

// Of Scorer's function: pi Gi - 1/z, its derivative, and its integral beyond z; with t = exp(y), where that rule is as good.
struct Scorer {
    double value, slope, beyond;
};
Scorer scorer(double z) {
    constexpr double kStep = 1.0 / 16, kFirst = -14.0, kEnd = 80.0;  // exp(3 kFirst) of the integrand
    const double last = std::log(kEnd / z);
    Scorer sum{0, 0, 0};
    for (double y = kFirst; y < last; y += kStep) {
        const double t = std::exp(y), part = kStep * std::expm1(-t * t * t / 3.0) * std::exp(-0.5 * z * t),
                     phase = 0.5 * std::sqrt(3.0) * z * t;
        sum.value -= part * t * std::cos(phase + 2.0 * M_PI / 3.0);
        sum.slope += part * t * t * std::cos(phase + M_PI / 3.0);
        sum.beyond += part * std::cos(phase);
    }
    return sum;
}

constexpr double kLeast = 1e-9, kMost = 700.0;  // x
constexpr double kSteps = 32.0;                 // of ln x
constexpr std::size_t kLogarithms = kConverted;

}  // namespace

KernelValues synchrotron_kernels(double x) {
    const auto [third, two_thirds, beyond] = bessels(x);
    const double five_thirds = third + 4.0 / (3.0 * x) * two_thirds, four_thirds = two_thirds + 2.0 / (3.0 * x) * third;
    const double z = std::cbrt(2.25 * x * x);
    const Scorer s = scorer(z);
    const double v = x * third + beyond;
    return {x * (2.0 * two_thirds - beyond),
            x * two_thirds,
            v,
            x * x * five_thirds,
            0.5 * x * x * (third + five_thirds),
            v + x * x * (two_thirds + four_thirds),
            (1.0 + z * z * (z * z * s.value - s.slope)) / 3.0,
            5.0 / 9.0 * z * s.value + 0.5 * s.beyond - 4.0 / 9.0 * z * z * s.slope};
}

// Crusius and Schlickeiser 1986 (A&A 164, L16), as Ghisellini, Guilbert and Svensson 1988 (ApJ 334, L5) have it.
KernelValues mean_synchrotron_kernels(double x) {
    const double y = 0.5 * x;
    const auto [b, two_thirds, unused] = bessels(y);
    const double a = two_thirds + 2.0 / (3.0 * y) * b;                    // K_4/3
    const double da = -b - 4.0 / (3.0 * y) * a, db = -a + b / (3.0 * y);  // derivatives
    const double f = a * b - 0.6 * y * (a * a - b * b),
                 slope = da * b + a * db - 0.6 * (a * a - b * b) - 1.2 * y * (a * da - b * db);
    KernelValues values{};
    values[kOfI] = 2.0 * y * y * f;
    values[kAbsorbedI] = -2.0 * y * y * (f + y * slope);  // of i - x di/dx
    return values;
}

KernelTable::KernelTable(bool isotropic) : isotropic_(isotropic) {
    const auto steps = static_cast<std::size_t>(std::ceil(kSteps * std::log(kMost / kLeast)));
    for (std::size_t i = 0; i <= steps + 1; ++i) {
        const double x = kLeast * std::exp((static_cast<double>(i) - 1.0) / kSteps);
        KernelValues values = isotropic ? mean_synchrotron_kernels(x) : synchrotron_kernels(x);
        for (std::size_t k = 0; k < kLogarithms; ++k) values[k] = std::log(std::max(values[k], 1e-306));
        nodes_.push_back(values);
    }
}

KernelValues KernelTable::at(double log_x) const {
    KernelValues found{};
    if (log_x > std::log(kMost)) {
        found[kConverted] = 1.0;
        return found;
    }
    const double at = kSteps * (log_x - std::log(kLeast)) + 1.0;
    const double whole = std::clamp(std::floor(at), 1.0, static_cast<double>(nodes_.size() - 3));
    const auto i = static_cast<std::size_t>(whole);
    const double t = at - whole;
    // The cubic through four nodes; a straight line below them.
    std::array<double, 4> share{-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
                                -t * (t + 1.0) * (t - 2.0) / 2.0, t * (t + 1.0) * (t - 1.0) / 6.0};
    if (t < 0.0) share = {0.0, 1.0 - t, t, 0.0};
    for (std::size_t k = 0; k < kSynchrotronKernels; ++k) {
        double sum = 0.0;
        for (std::size_t n = 0; n < 4; ++n) sum += share[n] * nodes_[i + n - 1][k];
        if (k < kLogarithms) sum = isotropic_ && k != kOfI && k != kAbsorbedI ? 0.0 : std::exp(sum);
        found[k] = sum;
    }
    if (t < 0.0) found[kConverted] = 0.0;  // 1e-12 of it
    return found;
}

const KernelTable& kernel_table(bool isotropic) {
    static const KernelTable one(false), mean(true);
    return isotropic ? mean : one;
}

}  // namespace nullscope
