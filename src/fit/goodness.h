// Whether a model describes data: chi^2 and how probable one as large is by chance.
#pragma once
#include <cstddef>

namespace nullscope::fit {

struct Goodness {
    double chi2 = 0;
    long long degrees = 0;   // of freedom: data less parameters; 0 or less: too few data
    double probability = 1;  // of a chi^2 as large or larger, by noise alone
    double per_degree() const { return degrees > 0 ? chi2 / static_cast<double>(degrees) : 0; }
    // Too improbable, and by more than what small faults of the model add to many data.
    bool is_bad() const { return probability < kImprobable && per_degree() > kMuch; }
    static constexpr double kImprobable = 1e-4, kMuch = 1.2;
};

// probability: the regularized incomplete gamma function Q(degrees/2, chi2/2) (by Boost).
Goodness goodness_of(double chi2, std::size_t data, std::size_t parameters);

}  // namespace nullscope::fit
