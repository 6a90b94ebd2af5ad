#include "spacetime/ray_potential.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope {
namespace {

constexpr double kPieceLeft = 1e-15;  // of the largest term, in the last two of a piece
constexpr int kRiseTerms = Expansion::kTerms + 4;

using RiseSeries = expr::Series<double, kRiseTerms>;

// Of V by r about a place, without its value there.
RiseSeries rise_about(const MetricFormulas& f, double r) {
    const RiseSeries at = RiseSeries::variable(r), across = f.areal_radius(at), v = f.lapse2(at) / (across * across);
    return v - RiseSeries(v.of_power(0));
}

}  // namespace

RayPotential::RayPotential(MetricFormulas formulas, double end)
    : formulas_(std::move(formulas)), end_(end), nearest_(kNearest * std::max(end, 1.0)) {
    first_octave_ = std::ilogb(nearest_);
    const int octaves = std::ilogb(kFarthest) + 1 - first_octave_;
    for (std::size_t which = 0; which < 2; ++which) {
        for (int i = 0; i < octaves * kParts; ++i) {
            const double octave = std::ldexp(1.0, first_octave_ + i / kParts), part = i % kParts;
            pieces_[which].push_back(
                piece_of(octave * (1.0 + part / kParts), octave * (1.0 + (part + 1.0) / kParts), which));
        }
        const double near = by_formula(end_ + nearest_, which), off = by_formula(end_ + 2.0 * nearest_, which);
        at_nearest_[which] = near;
        power_[which] = std::log2(off / near);
        if (!std::isfinite(power_[which])) power_[which] = 0.0;
    }
}

double RayPotential::v_by_formula(double r) const {
    const double across = formulas_.areal_radius(r);
    return formulas_.lapse2(r) / (across * across);
}

double RayPotential::density_by_formula(double r) const {
    const double across = formulas_.areal_radius(r);
    return (formulas_.tilted() ? std::sqrt(formulas_.lapse2(r) * formulas_.stretch2(r)) : 1.0) / (across * across);
}

// A sum of Chebyshev's polynomials.
RayPotential::Piece RayPotential::piece_of(double low, double high, std::size_t which) const {
    Piece piece;
    double largest = 0.0;
    for (int i = 0; i < kTerms; ++i) {
        const double angle = M_PI * (i + 0.5) / kTerms;
        const double value = by_formula(end_ + 0.5 * (low + high) + 0.5 * (high - low) * std::cos(angle), which);
        if (!std::isfinite(value)) return piece;
        for (int j = 0; j < kTerms; ++j)
            piece.c[static_cast<std::size_t>(j)] += (j == 0 ? 1.0 : 2.0) / kTerms * value * std::cos(j * angle);
    }
    for (const double c : piece.c) largest = std::max(largest, std::fabs(c));
    piece.good = std::fabs(piece.c[kTerms - 1]) + std::fabs(piece.c[kTerms - 2]) <= kPieceLeft * largest;
    return piece;
}

double RayPotential::value(double x, std::size_t which) const {
    if (x < nearest_) return at_nearest_[which] * std::pow(x / nearest_, power_[which]);
    const int octave = std::ilogb(x);
    const double place = (std::ldexp(x, -octave) - 1.0) * kParts;
    const auto part = static_cast<std::size_t>(place);
    const std::size_t i = static_cast<std::size_t>(octave - first_octave_) * kParts + part;
    if (i >= pieces_[which].size() || !pieces_[which][i].good) return by_formula(end_ + x, which);
    const Piece& piece = pieces_[which][i];
    const double t = 2.0 * (place - static_cast<double>(part)) - 1.0;
    double next = 0.0, after = 0.0;  // Clenshaw's recurrence
    for (std::size_t k = kTerms - 1; k > 0; --k) {
        const double sum = piece.c[k] + 2.0 * t * next - after;
        after = next;
        next = sum;
    }
    return piece.c[0] + t * next - after;
}

void RayPotential::expand_about(double x, double v) {
    constexpr double kLevel = 1e-6, kWidest = 0.3;  // of V'/V over r; of r, or of the scale of a regular centre
    const double r = end_ + x, scale = r > 0.0 ? r : 1.0;
    RiseSeries rise = rise_about(formulas_, r);
    const bool level = std::fabs(rise.of_power(1)) * scale < kLevel * v && rise.of_power(2) < 0.0;
    if (level && rise.power == 0) rise.c[1] = 0.0;
    ridge_ = {x, v, level ? -rise.of_power(2) : 0.0};
    about_ = Expansion(rise, level ? 2 : 1, kWidest * scale);
}

}  // namespace nullscope
