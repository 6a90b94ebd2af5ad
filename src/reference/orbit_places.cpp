#include "reference/orbit_places.h"

#include <algorithm>
#include <cmath>

#include "reference/chebyshev.h"

namespace nullscope::reference {
namespace {

constexpr double kStretch = 0.125;           // rad
constexpr std::size_t kMostStretches = 256;  // of rays that wind without end
constexpr unsigned kAskedBefore = 6;         // a sum: of fewer looks it would cost more than it spares
constexpr double kLeftOver = 1e-12;          // of the place: the last terms

}  // namespace

double OrbitPlaces::operator()(double angle) {
    const double stretches = angle / kStretch;
    if (!(stretches >= 0 && stretches < kMostStretches)) return orbit_.zeta_at(angle);
    const auto i = static_cast<std::size_t>(stretches);
    if (i >= stretches_.size()) stretches_.resize(i + 1);
    Stretch& stretch = stretches_[i];
    const double from = kStretch * static_cast<double>(i);
    if (stretch.kind == Stretch::Kind::kAsked && ++stretch.asked > kAskedBefore) sum(stretch, from);
    if (stretch.kind != Stretch::Kind::kSummed) return orbit_.zeta_at(angle);
    return chebyshev_sum(stretch.terms, 2 * (angle - from) / kStretch - 1);
}

void OrbitPlaces::sum(Stretch& stretch, double from) const {
    stretch.kind = Stretch::Kind::kNoSum;
    if (!(from + kStretch < orbit_.angle())) return;
    std::array<double, kTerms> values{};
    double least = INFINITY, most = 0;
    for (std::size_t k = 0; k < kTerms; ++k) {
        values[k] = orbit_.zeta_at(from + 0.5 * kStretch * (1 + chebyshev_places<kTerms>()[k]));
        least = std::min(least, std::abs(values[k])), most = std::max(most, std::abs(values[k]));
    }
    stretch.terms = chebyshev_terms(values);
    const double left = std::abs(stretch.terms[kTerms - 1]) + std::abs(stretch.terms[kTerms - 2]);
    if (left <= kLeftOver * (by_length_ ? most : least)) stretch.kind = Stretch::Kind::kSummed;
}

}  // namespace nullscope::reference
