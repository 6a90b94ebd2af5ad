#include "table/deflection_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "shadercore/core64.h"
#include "table/gauss.h"

namespace nullscope {
namespace {

constexpr double kPi = M_PI;

// asinh(a/d) - asinh(b/d) for a > 0, a >= b, given d^2 >= 0: no overflow, no cancellation.
double asinh_difference(double a, double b, double d2) {
    const double sa = std::sqrt(a * a + d2), sb = std::sqrt(b * b + d2);
    if (b >= 0.0 || d2 > 1.0) return std::log1p((a - b) * (1.0 + (a + b) / (sa + sb)) / (b + sb));
    return std::log((a + sa) * (sb - b) / std::max(d2, 1e-300));
}

// First four Taylor coefficients of G(c) = h(chi)/sin(chi), chi = acos(c), by Chebyshev interpolation on |c| <= 1/4.
std::array<double, 4> series_about_photon_sphere(const SphericalMetric& spacetime) {
    constexpr int n = 24;
    constexpr double kRadius = 0.25;
    std::array<double, n> chebyshev{};
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double angle = kPi * (i + 0.5) / n;
            const double chi = std::acos(kRadius * std::cos(angle));
            chebyshev[j] +=
                (j == 0 ? 1.0 : 2.0) / n * spacetime.chi()->bending_density(chi) / std::sin(chi) * std::cos(j * angle);
        }
    }
    std::array<double, 4> a{};
    std::array<double, n + 1> previous{1.0}, current{0.0, 1.0};  // power coefficients of T_0, T_1
    for (int j = 0; j < n; ++j) {
        for (int p = 0; p < 4; ++p) a[p] += chebyshev[j] * previous[p];
        std::array<double, n + 1> next{};
        for (int p = 0; p < n; ++p) next[p + 1] = 2.0 * current[p];
        for (int p = 0; p <= n; ++p) next[p] -= previous[p];
        previous = current;
        current = next;
    }
    for (int p = 1; p < 4; ++p) a[p] /= std::pow(kRadius, p);
    return a;
}

// J0..J3 of deflection_table.h, c in [-1, 1]; factored so that they keep their digits for d^2 -> infinity (radial rays).
std::array<double, 4> through_integrals(double d2, double c) {
    constexpr double kFar =
        16.0;  // above it the 12-point rule is exact to rounding, below it J2 loses at most two digits
    const double root1 = std::sqrt(1.0 + d2), root = std::sqrt(c * c + d2);
    const double j0 = asinh_difference(1.0, c, d2);
    const double j1 = (1.0 - c) * (1.0 + c) / (root1 + root);
    const double j2 = d2 > kFar ? gauss(c, 1.0, [d2](double x) { return x * x / std::sqrt(d2 + x * x); })
                                : 0.5 * (root1 - c * root - d2 * j0);
    const double j3 = j1 / 3.0 * (1.0 + c * c + (c * c + d2 * (1.0 + c * c)) / (root1 * root + d2));
    return {j0, j1, j2, j3};
}

// h(pi - chi) = h(chi), as wormholes have it: one sheet of turning rays serves both sides.
bool same_on_both_sides(const SphericalMetric& spacetime) {
    constexpr int kSamples = 32;
    constexpr double kSame = 1e-14;  // a few roundings of pi - chi
    for (int i = 1; i < kSamples; ++i) {
        const double chi = 0.5 * kPi * i / kSamples, h = spacetime.chi()->bending_density(chi);
        if (!(std::fabs(spacetime.chi()->bending_density(kPi - chi) - h) <= kSame * h)) return false;
    }
    return true;
}

// Over a sheet's cell; the cells of a graded one are half as wide.
template <class Sheet, class F>
double cell_integral(const Sheet& sheet, int j, F&& f) {
    const double low = kPi * sheet.node_y(j - 1), high = kPi * sheet.node_y(j);
    return sheet.graded_y ? gauss_rule(kShortNode, kShortWeight, low, high, f) : gauss(low, high, f);
}

}  // namespace

DeflectionTable::DeflectionTable(const SphericalMetric& spacetime, int size) : size_(size) {
    const bool graded = spacetime.chi()->logarithm_at_sky();
    if (graded) size_ = size *= 2;
    const auto a = series_about_photon_sphere(spacetime);
    series_ = {a[0], a[1], a[2], a[3]};
    for (Sheet* sheet : {&outer_, &inner_, &through_}) {
        sheet->size = size;
        sheet->graded_x = graded && sheet != &through_;
        sheet->graded_y = graded;
        sheet->values.assign(static_cast<std::size_t>(size + 1) * (size + 1), 0.0);
    }
    const DensityFit density(spacetime);
    build_turning(density, false, series_, outer_);
    if (same_on_both_sides(spacetime))
        inner_.values = outer_.values;
    else
        build_turning(density, true, series_, inner_);
    build_through(density, through_);
}

std::size_t DeflectionTable::bytes() const { return 3 * outer_.values.size() * sizeof(double); }

// R is summed up cell by cell along alpha with a Gauss rule each: every node costs one cell.
void DeflectionTable::build_turning(const DensityFit& density, bool inner, const Series& series, Sheet& sheet) {
    tbb::parallel_for(0, size_ + 1, [&](int i) {
        const double m = core64::turning_one_minus_k_from_x(sheet.node_x(i));
        const double k = 1.0 - m, kp2 = m * (2.0 - m);
        const auto integrand = [&](double alpha) {
            const double sin_alpha = std::sin(alpha), t = k * std::cos(alpha);
            const double sin_chi = k * sin_alpha;
            const double c = std::sqrt(kp2 + t * t);
            const double chi = std::atan2(sin_chi, c);
            const double h = density(inner ? kPi - chi : chi);
            return (h - sin_chi * (series.a0 + series.a2 * c * c)) / c;
        };
        double sum = 0.0;
        double* row = sheet.values.data() + static_cast<std::size_t>(i) * (size_ + 1);
        for (int j = 1; j <= size_; ++j) {
            sum += cell_integral(sheet, j, integrand);
            row[j] = sum;
        }
    });
}

void DeflectionTable::build_through(const DensityFit& density, Sheet& sheet) {
    tbb::parallel_for(0, size_ + 1, [&](int i) {
        // R k is stored; at x = 1 (k = infinity) its limit, the integral of h - sin(chi) (a0 + ... + a3 c^3).
        const double x = static_cast<double>(i) / size_;
        const bool radial = i == size_;
        const double k1 = radial ? 0.0 : core64::through_k_minus_one_from_x(x);
        const double k = 1.0 + k1, d2 = k1 * (2.0 + k1);
        const auto integrand = [&](double chi) {
            const double s = std::sin(chi), c = std::cos(chi);
            const double rest = density(chi) - s * (series_.a0 + c * (series_.a1 + c * (series_.a2 + c * series_.a3)));
            return radial ? rest : rest * k / std::sqrt(d2 + c * c);
        };
        double sum = 0.0;
        double* row = sheet.values.data() + static_cast<std::size_t>(i) * (size_ + 1);
        for (int j = 1; j <= size_; ++j) {
            sum += cell_integral(sheet, j, integrand);
            row[j] = sum;
        }
    });
}

double DeflectionTable::Sheet::node_x(int i) const {
    const double s = static_cast<double>(i) / size;
    return graded_x ? s * s * s : s;
}

// v^3 (10 - 15 v + 6 v^2): 10 v^3 at both ends, 15/8 as wide in the middle.
double DeflectionTable::Sheet::node_y(int j) const {
    const double v = static_cast<double>(j) / size;
    return graded_y ? v * v * v * (10.0 - v * (15.0 - 6.0 * v)) : v;
}

namespace {
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

double DeflectionTable::Sheet::at(double x, double y) const {
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

double DeflectionTable::turning(const Sheet& sheet, double k, double one_minus_k2, double angle) const {
    const double t = k * std::cos(angle);
    const double log_term = asinh_difference(k, t, one_minus_k2);
    const double c = std::sqrt(one_minus_k2 + t * t);
    const double f_difference = k - t * c + one_minus_k2 * log_term;  // F(k) - F(t); sqrt(k'^2 + k^2) = 1
    const double x = core64::turning_x_from_one_minus_k(one_minus_k2 / (1.0 + k));
    return series_.a0 * log_term + 0.5 * series_.a2 * f_difference + sheet.at(x, core64::table_y_from_angle(angle));
}

double DeflectionTable::turning_to_sky(double k, double one_minus_k2, double alpha) const {
    return turning(outer_, k, one_minus_k2, alpha);
}

double DeflectionTable::turning_to_horizon(double k, double one_minus_k2, double beta) const {
    return turning(inner_, k, one_minus_k2, beta);
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
