#include "spectrum/disc_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nullscope {
namespace {

constexpr double kClose = 1e-12;  // of ln rho: rays are not exacter
constexpr int kMostTries = 200;   // of rays for one node

struct Node {
    double log_rho, slope;
};

// Where the half line (cos_chi, sin_chi) meets the ring of radius r: the secant's rule within a bracket. guess: of ln rho.
Node node_at(const DistantLight& light, double r, double cos_chi, double sin_chi, double guess) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double inside = -kInfinity, outside = kInfinity;  // ln rho of rays that cross within r, or not at all, and beyond
    double last = NAN, last_off = NAN, slope = 1.0, x = guess;
    for (int tried = 0; tried < kMostTries; ++tried) {
        const double rho = std::exp(x);
        const auto met = light.crossing(rho * cos_chi, rho * sin_chi);
        const double off = met ? met->zeta * r - 1.0 : NAN;
        if (met) slope = met->slope;
        (met && off <= 0.0 ? outside : inside) = x;
        double next = std::isnan(last_off) ? x + std::clamp(off, -0.5, 0.5)  // far out zeta is as 1/rho
                                           : x - off * (x - last) / (off - last_off);
        if (met) last = x, last_off = off;
        if (std::fabs(next - x) <= kClose || off == 0.0) return {next, slope};
        if (!(next > inside && next < outside)) {
            constexpr double kStride = 0.5;
            next = inside == -kInfinity   ? outside - kStride
                   : outside == kInfinity ? inside + kStride
                                          : 0.5 * (inside + outside);
        }
        if (outside - inside <= kClose) break;
        x = next;
    }
    return {x, slope};
}

// A coefficient of T_m of the polynomial that has the values f_k at the n nodes cos(pi (k + 1/2)/n): the weight of f_k in it.
double node_weight(int m, int k, int n) { return (m == 0 ? 1.0 : 2.0) / n * std::cos(M_PI * m * (k + 0.5) / n); }

// From values in rows of `angles` to coefficients in rows of `columns`. The trigonometric polynomial through n equal angles, n even, is a
// sum of the values times sin(n t/2)/(n tan(t/2)), t the distance to each.
std::vector<double> coefficients_of(const std::vector<double>& values, const DiscImage::Size& size) {
    const auto at = [](int row, int width, int column) {
        return static_cast<std::size_t>(static_cast<long long>(row) * width + column);
    };
    std::vector<double> kernel(2 * static_cast<std::size_t>(size.columns), 1.0);  // twice round, from minus one turn
    for (int d = 1; d < size.columns; ++d) {
        const double half = M_PI * d / size.columns,
                     value = std::sin(size.angles * half) / (size.angles * std::tan(half));
        kernel[at(0, 0, d)] = kernel[at(1, size.columns, d)] = value;
    }
    const int ratio = size.columns / size.angles;
    std::vector<double> rows(values.size(), 0.0), all(at(size.radii, size.columns, 0), 0.0);
    for (int m = 0; m < size.radii; ++m)
        for (int k = 0; k < size.radii; ++k)
            for (int n = 0; n < size.angles; ++n)
                rows[at(m, size.angles, n)] += node_weight(m, k, size.radii) * values[at(k, size.angles, n)];
    for (int m = 0; m < size.radii; ++m)
        for (int n = 0; n < size.angles; ++n) {
            const double value = rows[at(m, size.angles, n)];
            const double* of = &kernel[at(1, size.columns, -n * ratio)];
            double* row = &all[at(m, size.columns, 0)];
            for (int j = 0; j < size.columns; ++j) row[j] += value * of[j];
        }
    return all;
}

}  // namespace

DiscImage::DiscImage(const DistantLight& light, double inner, double outer, Size size)
    : light_(&light),
      low_(std::log(inner - light.horizon())),
      high_(std::log(outer - light.horizon())),
      squash_(std::sqrt(light.cosine())),
      size_(size) {
    for (int j = 0; j < size.columns; ++j) {
        const double chi = 2.0 * M_PI * j / size.columns;
        cosine_.push_back(std::cos(chi)), sine_.push_back(squash_ * std::sin(chi));
    }
    const std::size_t angles = static_cast<std::size_t>(size.angles);
    std::vector<double> rho(angles * static_cast<std::size_t>(size.radii)), slope(rho.size());
    for (std::size_t n = 0; n < angles; ++n) {
        const double chi = 2.0 * M_PI * static_cast<double>(n) / size.angles, co = std::cos(chi),
                     si = squash_ * std::sin(chi);
        // From the outermost inward; each guess continues the last two.
        double guess = 0.5 * std::log(outer * outer / (co * co + std::sin(chi) * std::sin(chi) / light.cosine()));
        double last = NAN, last_y = NAN;
        for (int k = 0; k < size.radii; ++k) {
            const double y = 0.5 * (low_ + high_) + 0.5 * (high_ - low_) * std::cos(M_PI * (k + 0.5) / size.radii);
            const Node node = node_at(light, light.horizon() + std::exp(y), co, si, guess);
            const std::size_t at = static_cast<std::size_t>(k) * angles + n;
            rho[at] = node.log_rho, slope[at] = node.slope;
            const double next_y = 0.5 * (low_ + high_) + 0.5 * (high_ - low_) * std::cos(M_PI * (k + 1.5) / size.radii);
            const double rate = std::isnan(last) ? 1.0 : (node.log_rho - last) / (y - last_y);
            guess = node.log_rho + rate * (next_y - y);
            last = node.log_rho, last_y = y;
        }
    }
    rho_ = coefficients_of(rho, size), slope_ = coefficients_of(slope, size);
}

std::vector<DiscImage::Point> DiscImage::ring(double r) const {
    const double height = r - light_->horizon(),
                 x = std::clamp((2.0 * std::log(height) - low_ - high_) / (high_ - low_), -1.0, 1.0);
    const std::size_t columns = static_cast<std::size_t>(size_.columns);
    std::vector<double> rho(columns, 0.0), rise(columns, 0.0), slope(columns, 0.0);
    double t = 1.0, t_next = x, u = 0.0, u_next = 1.0;  // T_m, T_{m+1}; U_{m-1}, U_m; dT_m/dx = m U_{m-1}
    for (int m = 0; m < size_.radii; ++m) {
        const double* of_rho = &rho_[static_cast<std::size_t>(m) * columns];
        const double* of_slope = &slope_[static_cast<std::size_t>(m) * columns];
        const double rate = m * u;
        for (std::size_t j = 0; j < columns; ++j)
            rho[j] += t * of_rho[j], rise[j] += rate * of_rho[j], slope[j] += t * of_slope[j];
        const double t_after = 2.0 * x * t_next - t, u_after = 2.0 * x * u_next - u;
        t = t_next, t_next = t_after, u = u_next, u_next = u_after;
    }
    std::vector<Point> points(columns);
    const double by_r = 2.0 / ((high_ - low_) * height);  // dx/dr
    for (std::size_t j = 0; j < columns; ++j) {
        const double far = std::exp(rho[j]);
        points[j] = {far * cosine_[j], far * sine_[j], squash_ * far * far * rise[j] * by_r, slope[j]};
    }
    return points;
}

}  // namespace nullscope
