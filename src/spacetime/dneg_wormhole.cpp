#include "spacetime/dneg_wormhole.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

// f(x) = x atan x - ln(1 + x^2)/2 for x >= 0; its difference would cancel for small x, its series is that of atan, integrated.
double growth(double x) {
    constexpr double kSeries = 0.3;
    if (x > kSeries) return x * std::atan(x) - (x < 1e8 ? 0.5 * std::log1p(x * x) : std::log(x));
    const double x2 = x * x;
    double sum = 0.0, power = x2;
    for (int n = 0; n < 16; ++n, power *= -x2) sum += power / ((2 * n + 1) * (2 * n + 2));
    return sum;
}

}  // namespace

DnegWormhole::DnegWormhole(double throat, double length, double width)
    : throat_(throat), half_length_(0.5 * length * throat), mass_(width * throat / kWidthOverMass) {}

double DnegWormhole::areal_radius(double l) const {
    return throat_ + mass_ * growth(std::max(std::fabs(l) - half_length_, 0.0) / (M_PI_2 * mass_));
}

double DnegWormhole::radius_slope(double l) const {
    const double slope = M_2_PI * std::atan(std::max(std::fabs(l) - half_length_, 0.0) / (M_PI_2 * mass_));
    return l < 0.0 ? -slope : slope;
}

double DnegWormhole::radius_curvature(double l) const {
    const double x = (std::fabs(l) - half_length_) / (M_PI_2 * mass_);
    return x < 0.0 ? 0.0 : M_2_PI / (M_PI_2 * mass_ * (1.0 + x * x));
}

// R cos(chi) = sqrt((R - rho)(R + rho)): exact at the throat.
double DnegWormhole::chi_from_radius(double l) const {
    const double more = mass_ * growth(std::max(std::fabs(l) - half_length_, 0.0) / (M_PI_2 * mass_));
    const double cosine = std::sqrt(more) * std::sqrt(more + 2.0 * throat_);
    return std::atan2(throat_, l < 0.0 ? -cosine : cosine);
}

double DnegWormhole::x_of_chi(double chi) const {
    constexpr int kMostSteps = 60;
    const double sine = std::sin(chi), cosine = std::cos(chi);
    const double y = throat_ / mass_ * cosine * cosine / (sine * (1.0 + sine));  // (R - rho)/M
    if (!(y > 0.0)) return 0.0;
    double x = std::max(std::sqrt(2.0 * y), M_2_PI * y);  // f <= x^2/2 and f <= (pi/2) x
    for (int i = 0; i < kMostSteps; ++i) {
        const double next = x - (growth(x) - y) / std::atan(x);
        const bool done = std::fabs(next - x) <= 1e-9 * x;  // Newton's step squares what is off
        x = next;
        if (done) break;
    }
    return x;
}

double DnegWormhole::radius_from_chi(double chi) const {
    const double l = half_length_ + M_PI_2 * mass_ * x_of_chi(chi);
    return chi > M_PI_2 ? -l : l;
}

double DnegWormhole::bending_density(double chi) const {
    if (chi <= 0.0 || chi >= M_PI) return 1.0;
    const double x = x_of_chi(chi);
    return x > 0.0 ? std::fabs(std::cos(chi)) / (M_2_PI * std::atan(x)) : M_PI_2 * std::sqrt(mass_ / throat_);
}

double DnegWormhole::tube_beyond(double l) const {
    return (half_length_ - std::clamp(l, -half_length_, half_length_)) / throat_;
}

}  // namespace nullscope
