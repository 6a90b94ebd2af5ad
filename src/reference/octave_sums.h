// A smooth function of zeta > 0 as sums of Chebyshev's polynomials, four pieces an octave, and its divided differences: in the place of a
// formula that is asked for very often.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/chebyshev.h"

namespace nullscope::reference {

class OctaveSums {
public:
    using Long = long double;
    // Each sum holds an eighth of a piece beyond it on either side. Of a singularity at 0 sixteen terms leave 11^-16 there.
    static constexpr std::size_t kTerms = 16;
    static constexpr Long kBeyond = 1.25L;
    static constexpr Long kLeftOver = 1e-16L,
                          kNothing = 1e-19L;  // of the largest term: the last two; those that are left out

    // Clenshaw's sum of the first terms.
    template <class Real>
    static Real sum(const std::array<Real, kTerms>& terms, std::size_t count, Real x) {
        Real next = 0, after = 0;
        const Real twice = 2 * x;
        for (std::size_t k = count - 1; k > 0; --k) {
            const Real here = (terms[k] - after) + twice * next;
            after = next, next = here;
        }
        return (terms[0] - after) + x * next;
    }

    // Real: in which it is evaluated, of double terms that are rounded once.
    class Piece {
    public:
        template <class F>
        Piece(const F& f, Long from, Long to)
            : middle_((from + to) / 2),
              half_(kBeyond * (to - from) / 2),
              rounded_middle_(static_cast<double>(middle_)),
              per_half_(static_cast<double>(1 / half_)) {
            std::array<Long, kTerms> values{};
            for (std::size_t i = 0; i < kTerms; ++i)
                values[i] = f(middle_ + half_ * chebyshev_places<kTerms, Long>()[i]);
            terms_ = chebyshev_terms(values);
            Long most = 0;
            for (const Long term : terms_) most = std::max(most, std::abs(term));
            settles_ = std::abs(terms_[kTerms - 1]) + std::abs(terms_[kTerms - 2]) <= kLeftOver * most;
            while (count_ > 2 && std::abs(terms_[count_ - 1]) <= kNothing * most) --count_;
            std::ranges::transform(terms_, rounded_.begin(), [](Long term) { return static_cast<double>(term); });
        }
        bool settles() const { return settles_; }
        bool holds(Long zeta) const { return std::abs(zeta - middle_) <= half_; }
        Long operator()(Long zeta) const { return sum(terms_, count_, (zeta - middle_) / half_); }
        double operator()(double zeta) const { return sum(rounded_, count_, (zeta - rounded_middle_) * per_half_); }

    private:
        friend class OctaveDifferences;
        Long middle_, half_;
        double rounded_middle_, per_half_;
        bool settles_ = false;
        std::size_t count_ = kTerms;
        std::array<Long, kTerms> terms_;
        std::array<double, kTerms> rounded_;
    };

    OctaveSums() = default;
    // On [2^-octaves most, most]: 64 values of f an octave.
    template <class F>
    OctaveSums(const F& f, Long most, int octaves) : unit_(static_cast<double>(1 / most)), first_(place(kLast)) {
        for (int i = 0; i < octaves; ++i)
            for (const Long from : {0.875L, 0.75L, 0.625L, 0.5L})
                pieces_.emplace_back(f, std::ldexp(from * most, -i), std::ldexp((from + 0.125L) * most, -i));
    }
    // Whose sum is f next to zeta, within 1e-16 of the piece's largest value; null outside of all, and where f is not that smooth.
    const Piece* piece(double zeta) const {
        const double part = std::min(zeta * unit_, kLast);
        const std::size_t i = first_ - place(part);
        return part > 0 && zeta * unit_ < kOver && i < pieces_.size() && pieces_[i].settles() ? &pieces_[i] : nullptr;
    }

private:
    static constexpr double kLast = 1 - 1e-15, kOver = 1.001;  // of the last piece; what it holds
    // The number of a piece, growing with zeta: its octave and the first two digits of its part of it.
    static std::size_t place(double part) { return std::bit_cast<std::uint64_t>(part) >> 50; }
    double unit_ = 0;
    std::size_t first_ = 0;
    std::vector<Piece> pieces_;  // from the largest zeta on
};

// (f(zeta) - f(end))/(zeta - end) of one end and many zeta, however close they are: by Clenshaw's recurrence at the end,
// b_k = c_k + 2 y b_(k+1) - b_(k+2), its terms are b_1, 2 b_2, 2 b_3, ...
class OctaveDifferences {
public:
    OctaveDifferences(const OctaveSums::Piece& piece, long double end)
        : middle_(piece.rounded_middle_), per_half_(piece.per_half_), count_(piece.count_ - 1) {
        const long double y = (end - piece.middle_) / piece.half_;
        long double next = 0, after = 0;
        for (std::size_t k = count_; k > 0; --k) {
            const long double here = piece.terms_[k] + 2 * y * next - after;
            after = next, next = here;
            terms_[k - 1] = static_cast<double>((k == 1 ? 1 : 2) * here / piece.half_);
        }
    }
    bool holds(double zeta) const { return std::abs(zeta - middle_) * per_half_ <= 1; }
    double operator()(double zeta) const { return OctaveSums::sum(terms_, count_, (zeta - middle_) * per_half_); }

private:
    double middle_, per_half_;
    std::size_t count_;
    std::array<double, OctaveSums::kTerms> terms_{};
};

}  // namespace nullscope::reference
