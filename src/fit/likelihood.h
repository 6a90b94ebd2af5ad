// The logarithm of the likelihood of data, and its derivatives: for samplers and other people's minimizers.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "fit/subject.h"

namespace nullscope::fit {

class Likelihood {
public:
    struct At {
        double log = 0;               // natural logarithm
        std::vector<double> slope{};  // by each parameter, in the unit of scene files
    };
    // Derivatives are those of fits: exact where the model has them, else differences whose steps suit the place `around` (empty: the middle of the
    // ranges). Cost: 1 + 2 free.size() predictions. Errors: `around` cannot be predicted.
    static Result<Likelihood> make(Subject subject, std::vector<FreeParameter> free, bool free_flux,
                                   const std::vector<double>& around);

    // Of normal errors, with its constant: -chi^2/2 - sum of ln(sigma sqrt(2 pi)); with a free flux the largest of any flux. -infinity (with
    // slopes of 0) outside of the ranges and where no such scene can be. Errors: it cannot be drawn. Cost: one prediction; with slopes 2 free.size()
    // more, or the model's derivatives.
    Result<At> at(const std::vector<double>& values, bool with_slope);
    Result<Prediction> predict(const std::vector<double>& values);  // scaled by the flux
    // Derivatives of the prediction by each parameter, in the units of data and scene files. values: within the ranges.
    Result<std::vector<Prediction>> derivatives(const std::vector<double>& values);

    const Observed& data() const { return subject_.data; }
    const std::vector<FreeParameter>& free() const { return free_; }

private:
    Likelihood(Subject subject, std::vector<FreeParameter> free, bool free_flux);
    Problem problem() const;
    std::vector<double> shares_of(const std::vector<double>& values) const;
    Subject subject_;
    std::vector<FreeParameter> free_;
    bool free_flux_;
    Steps steps_;
    double constant_ = 0;  // of the logarithm
};

}  // namespace nullscope::fit
