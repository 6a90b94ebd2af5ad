#include "reference/carrying_place.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {
namespace {
constexpr double kLeastSine = 1e-9;  // on the axis there is no azimuth
}

CarryingPlace::CarryingPlace(const CarryingMetric& metric, const Vec3& x)
    : metric_(metric), x_(x), a_(metric.a()), r_(metric.radius(x)), cosine_(std::clamp(x.z / r_, -1.0, 1.0)) {
    const std::complex<double> flat(x.x, x.y);
    sine_ = std::max(std::abs(flat) / std::hypot(r_, a_), kLeastSine);
    out_ = std::abs(flat) > 0 ? flat / std::complex(r_, a_) / sine_ : std::complex(1.0, 0.0);
    // F (r^2 + a^2 cos^2(theta)) = 2 m(r) r
    delta_ = r_ * r_ + a_ * a_ - metric.at(x).f * (r_ * r_ + a_ * a_ * cosine_ * cosine_);
}

FourVector CarryingPlace::ingoing(double v, double r, double theta, double phi) const {
    const std::complex<double> at(r_, a_), flat = (r * sine_ + at * std::complex(cosine_ * theta, sine_ * phi)) * out_;
    return {v - r, flat.real(), flat.imag(), r * cosine_ - r_ * sine_ * theta};
}

FourVector CarryingPlace::outer(double t, double r, double theta, double phi) const {
    return ingoing(t + (r_ * r_ + a_ * a_) / delta_ * r, r, theta, phi + a_ / delta_ * r);
}

FourVector sum_of(double a, const FourVector& u, double b, const FourVector& v) {
    FourVector w{};
    for (std::size_t m = 0; m < 4; ++m) w[m] = a * u[m] + b * v[m];
    return w;
}

FourVector moved(const CarryingPlace& at, const FourVector& b, const FourVector& u, const FourVector& e) {
    return sum_of(1, b, at.product(u, b) / (1 - at.product(u, e)), sum_of(1, u, 1, e));
}

double volume_of(const FourVector& p, const FourVector& u, const FourVector& k, const FourVector& f) {
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t l) {
        return u[i] * (k[j] * f[l] - k[l] * f[j]) - u[j] * (k[i] * f[l] - k[l] * f[i]) +
               u[l] * (k[i] * f[j] - k[j] * f[i]);
    };
    return p[0] * minor(1, 2, 3) - p[1] * minor(0, 2, 3) + p[2] * minor(0, 1, 3) - p[3] * minor(0, 1, 2);
}

}  // namespace nullscope::reference
