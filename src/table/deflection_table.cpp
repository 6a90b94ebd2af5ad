#include "table/deflection_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "numeric/gauss.h"
#include "shadercore/core64.h"
#include "table/chebyshev.h"

namespace nullscope {
namespace {

// asinh(a/d) - asinh(b/d) for a > 0, a >= b, given d^2 >= 0: no overflow, no cancellation.
double asinh_difference(double a, double b, double d2) {
    const double sa = std::sqrt(a * a + d2), sb = std::sqrt(b * b + d2);
    if (b >= 0.0 || d2 > 1.0) return std::log1p((a - b) * (1.0 + (a + b) / (sa + sb)) / (b + sb));
    return std::log((a + sa) * (sb - b) / std::max(d2, 1e-300));
}

// First four Taylor coefficients of G(c) = h(chi)/sin(chi), chi = acos(c), by Chebyshev interpolation on |c| <= 1/4.
DeflectionTable::Series series_about_photon_sphere(const SphericalMetric& spacetime) {
    constexpr double kRadius = 0.25;
    auto a = powers_through_chebyshev<24>([&](double t) {
        const double chi = std::acos(kRadius * t);
        return spacetime.chi()->bending_density(chi) / std::sin(chi);
    });
    for (std::size_t p = 1; p < 4; ++p) a[p] /= std::pow(kRadius, p);
    return {a[0], a[1], a[2], a[3]};
}

// J0..J3 of deflection_table.h, c in [-1, 1]; factored so that they keep their digits for d^2 -> infinity (radial rays).
std::array<double, 4> through_integrals(double d2, double c) {
    // Above it the 12-point rule is exact to rounding, below it J2 loses at most two digits.
    constexpr double kFar = 16.0;
    const double root1 = std::sqrt(1.0 + d2), root = std::sqrt(c * c + d2);
    const double j0 = asinh_difference(1.0, c, d2);
    const double j1 = (1.0 - c) * (1.0 + c) / (root1 + root);
    const double j2 = d2 > kFar ? gauss(c, 1.0, [d2](double x) { return x * x / std::sqrt(d2 + x * x); })
                                : 0.5 * (root1 - c * root - d2 * j0);
    const double j3 = j1 / 3.0 * (1.0 + c * c + (c * c + d2 * (1.0 + c * c)) / (root1 * root + d2));
    return {j0, j1, j2, j3};
}

// h(pi - chi) = h(chi), as wormholes have it: one branch of turning rays serves both sides.
bool same_on_both_sides(const SphericalMetric& spacetime) {
    constexpr int kSamples = 32;
    constexpr double kSame = 1e-14;  // a few roundings of pi - chi
    for (int i = 1; i < kSamples; ++i) {
        const double chi = 0.5 * M_PI * i / kSamples, h = spacetime.chi()->bending_density(chi);
        if (!(std::fabs(spacetime.chi()->bending_density(M_PI - chi) - h) <= kSame * h)) return false;
    }
    return true;
}

// Over a branch's cell; the cells of a graded one are half as wide.
template <class Branch, class F>
double cell_integral(const Branch& branch, int j, F&& f) {
    const double low = M_PI * branch.node_y(j - 1), high = M_PI * branch.node_y(j);
    return branch.graded_y ? gauss_rule(kShortNode, kShortWeight, low, high, f) : gauss(low, high, f);
}

double place_of_graded_y(double y) {
    const bool upper = y > 0.5;
    const double target = upper ? 1.0 - y : y;
    double v = std::min(std::cbrt(0.1 * target) * (1.0 + 0.25 * std::cbrt(target)), 0.5);
    for (int i = 0; i < 8 && v > 0.0; ++i) {
        const double off = v * v * v * (10.0 - v * (15.0 - 6.0 * v)) - target,
                     slope = 30.0 * v * v * (1.0 - v) * (1.0 - v);
        const double step = off / slope;
        v -= step;
        if (std::fabs(step) <= 1e-9 * v) break;
    }
    return upper ? 1.0 - v : v;
}

}  // namespace

DeflectionTable::DeflectionTable(const SphericalMetric& spacetime, int size) : size_(size) {
    const bool graded = spacetime.chi()->logarithm_at_sky();
    if (graded) size_ = size *= 2;
    series_ = series_about_photon_sphere(spacetime);
    const bool symmetric = same_on_both_sides(spacetime);
    if (symmetric) series_.a1 = series_.a3 = 0.0;
    for (Branch* branch : {&outer_, &inner_, &through_}) {
        branch->size = size;
        branch->graded_x = graded && branch != &through_;
        branch->graded_y = graded;
        branch->values.assign(static_cast<std::size_t>(size + 1) * (size + 1), 0.0);
    }
    const DensityFit density(spacetime);
    build_turning(density, false, outer_);
    if (symmetric)
        inner_.values = outer_.values;
    else
        build_turning(density, true, inner_);
    build_through(density, through_);
}

std::size_t DeflectionTable::bytes() const { return 3 * outer_.values.size() * sizeof(double); }

// R is summed up cell by cell along the angle with a Gauss rule each: every node costs one cell. integrand_of(x): of a
// row.
template <class Row>
void DeflectionTable::Branch::build(const Row& integrand_of) {
    tbb::parallel_for(0, size + 1, [&](int i) {
        const auto integrand = integrand_of(node_x(i));
        double sum = 0.0;
        double* row = values.data() + static_cast<std::size_t>(i) * (size + 1);
        for (int j = 1; j <= size; ++j) {
            sum += cell_integral(*this, j, integrand);
            row[j] = sum;
        }
    });
}

void DeflectionTable::build_turning(const DensityFit& density, bool inner, Branch& branch) {
    branch.build([&](double x) {
        const double m = core64::turning_one_minus_k_from_x(x);
        return [&, inner, k = 1.0 - m, kp2 = m * (2.0 - m)](double alpha) {
            const double sin_alpha = std::sin(alpha), t = k * std::cos(alpha);
            const double sin_chi = k * sin_alpha;
            const double c = std::sqrt(kp2 + t * t);
            const double chi = std::atan2(sin_chi, c);
            const double h = density(inner ? M_PI - chi : chi);
            return (h - sin_chi * (series_.a0 + series_.a2 * c * c)) / c;
        };
    });
}

// R k is stored; at x = 1 (k = infinity) its limit, the integral of h - sin(chi) (a0 + ... + a3 c^3).
void DeflectionTable::build_through(const DensityFit& density, Branch& branch) {
    branch.build([&](double x) {
        const bool radial = x == 1.0;
        const double k1 = radial ? 0.0 : core64::through_k_minus_one_from_x(x);
        return [&, radial, k = 1.0 + k1, d2 = k1 * (2.0 + k1)](double chi) {
            const double s = std::sin(chi), c = std::cos(chi);
            const double rest = density(chi) - s * (series_.a0 + c * (series_.a1 + c * (series_.a2 + c * series_.a3)));
            return radial ? rest : rest * k / std::sqrt(d2 + c * c);
        };
    });
}

double DeflectionTable::Branch::node_x(int i) const {
    const double s = static_cast<double>(i) / size;
    return graded_x ? s * s * s : s;
}

// v^3 (10 - 15 v + 6 v^2): 10 v^3 at both ends, 15/8 as wide in the middle.
double DeflectionTable::Branch::node_y(int j) const {
    const double v = static_cast<double>(j) / size;
    return graded_y ? v * v * v * (10.0 - v * (15.0 - 6.0 * v)) : v;
}

double DeflectionTable::Branch::at(double x, double y) const {
    if (graded_x) x = std::cbrt(std::max(x, 0.0));
    if (graded_y) y = place_of_graded_y(std::clamp(y, 0.0, 1.0));
    constexpr int kPoints = 6;
    const auto weights = [this](double position, int& first) {
        const double p = std::clamp(position, 0.0, 1.0) * size;
        first = std::clamp(static_cast<int>(p) - kPoints / 2 + 1, 0, size + 1 - kPoints);
        std::array<double, kPoints> w{};
        for (int a = 0; a < kPoints; ++a) {
            double product = 1.0;
            for (int b = 0; b < kPoints; ++b)
                if (b != a) product *= (p - first - b) / (a - b);
            w[a] = product;
        }
        return w;
    };
    int ix = 0, iy = 0;
    const auto wx = weights(x, ix);
    const auto wy = weights(y, iy);
    double sum = 0.0;
    for (int a = 0; a < kPoints; ++a) {
        const double* row = values.data() + static_cast<std::size_t>(ix + a) * (size + 1) + iy;
        double line = 0.0;
        for (int b = 0; b < kPoints; ++b) line += wy[b] * row[b];
        sum += wx[a] * line;
    }
    return sum;
}

double DeflectionTable::turning(const Branch& branch, double k, double one_minus_k2, double angle) const {
    const double t = k * std::cos(angle);
    const double log_term = asinh_difference(k, t, one_minus_k2);
    const double c = std::sqrt(one_minus_k2 + t * t);
    const double f_difference = k - t * c + one_minus_k2 * log_term;  // F(k) - F(t); sqrt(k'^2 + k^2) = 1
    const double x = core64::turning_x_from_one_minus_k(one_minus_k2 / (1.0 + k));
    return series_.a0 * log_term + 0.5 * series_.a2 * f_difference + branch.at(x, core64::table_y_from_angle(angle));
}

double DeflectionTable::through_from_infinity(double k, double k2_minus_one, double chi) const {
    const auto j = through_integrals(k2_minus_one, std::cos(chi));
    const double x = core64::through_x_from_k_minus_one(k2_minus_one / (1.0 + k));
    return series_.a0 * j[0] + series_.a1 * j[1] + series_.a2 * j[2] + series_.a3 * j[3] +
           through_.at(x, core64::table_y_from_angle(chi)) / k;
}

double DeflectionTable::through_remainder(double x, double y) const {
    const double last = 1.0 - 1e-6;  // k = 5e5: the radial limit is reached to 1e-12
    const double k1 = core64::through_k_minus_one_from_x(std::min(x, last));
    const double k = 1.0 + k1, d2 = std::max(k1 * (2.0 + k1), 1e-24);
    const auto j = through_integrals(d2, std::cos(core64::table_angle_from_y(y)));
    return through_.at(std::min(x, last), y) + k * (series_.a2 * j[2] + series_.a3 * j[3]);
}

}  // namespace nullscope
