// Along one step of a ray about a rotating hole: a polynomial for many looks, where the step itself would be integrated anew for each.
//
// Hermite's, of ninth degree: place, and the chart's time, with their slopes at both ends and at three places between, to which the step
// was integrated. Over a length h it is off by h^10/10! times the tenth derivative and the largest square of the places' product, 8.7e-6:
// along the steps that the tracer takes within 30 r_s by 4e-15 of the distance to the hole, which is rounding (test_matter_looks.cpp).
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace nullscope::reference {

template <std::size_t kNumbers>
class HermiteNinth {
public:
    using Numbers = std::array<double, kNumbers>;
    static constexpr std::size_t kPlaces = 5;
    // Lobatto's, of [0, 1].
    static constexpr std::array<double, kPlaces> kAt = {0, 0.17267316464601146, 0.5, 0.8273268353539885, 1};
    struct Known {
        Numbers value, slope;  // by the part of the step
    };
    explicit HermiteNinth(const std::array<Known, kPlaces>& known) {
        // Newton's divided differences, every place twice.
        for (std::size_t i = 0; i < kPlaces; ++i) terms_[2 * i] = terms_[2 * i + 1] = known[i].value;
        for (std::size_t order = 1; order < kTerms; ++order)
            for (std::size_t i = kTerms - 1; i >= order; --i) {
                const double apart = kAt[i / 2] - kAt[(i - order) / 2];
                for (std::size_t n = 0; n < kNumbers; ++n)
                    terms_[i][n] = apart == 0 ? known[i / 2].slope[n] : (terms_[i][n] - terms_[i - 1][n]) / apart;
            }
    }
    Known operator()(double part) const {
        Known at{terms_[kTerms - 1], {}};
        for (std::size_t i = kTerms - 1; i-- > 0;) {
            const double off = part - kAt[i / 2];
            for (std::size_t n = 0; n < kNumbers; ++n) {
                at.slope[n] = at.slope[n] * off + at.value[n];
                at.value[n] = at.value[n] * off + terms_[i][n];
            }
        }
        return at;
    }

private:
    static constexpr std::size_t kTerms = 2 * kPlaces;
    std::array<Numbers, kTerms> terms_{};
};

}  // namespace nullscope::reference
