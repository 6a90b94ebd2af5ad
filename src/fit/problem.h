// Data, the model that is to predict them and what is free in it; the prediction and its derivatives next to the data.
#pragma once
#include <string_view>
#include <vector>

#include "base/result.h"
#include "fit/free_parameters.h"
#include "fit/model.h"

namespace nullscope::fit {

// What a residual of many standard deviations counts: its square; beyond 3 of them its magnitude; or less.
enum class Loss { kSquare, kHuber, kCauchy };
inline constexpr std::string_view kLossNames[] = {"none", "huber", "cauchy"};  // as Loss
inline constexpr double kLossBegins = 3.0;                                     // standard deviations

struct Problem {
    const Observed& data;
    Model& model;
    const std::vector<FreeParameter>& free;
    bool free_flux = false;  // the prediction's scale is what fits best: a linear number, solved for each prediction
    Loss loss = Loss::kHuber;
    double settled = 0.05;  // a change of chi^2 that is none
};

// A model's prediction next to the data.
struct Comparison {
    Prediction prediction;  // scaled
    double flux = 1;        // that scale
    double chi2 = 0;
};
// Errors: the model's; a prediction that is not finite.
Result<Comparison> compare(const Problem& problem, const std::vector<double>& values);

// Of derivatives by differences between two places: half of their distance, in parts of the parameter's range. A picture of few rays has a grain
// that changes with every parameter, so that short steps are noisy; long ones are not straight. The first steps are for any place; later ones
// change the prediction by kStepChange standard deviations of all data together, kStepChange/2 of the parameter's if it alone were free.
struct Steps {
    std::vector<double> half;
};
inline constexpr double kFirstStep = 1.0 / 100, kShortestStep = 1.0 / 2000, kLongestStep = 1.0 / 30, kStepChange = 20;
Steps first_steps(std::size_t parameters);

// Derivatives of the prediction by each parameter's share of its range, in standard deviations of the data: a column each.
struct Slopes {
    std::vector<Prediction> columns;
    int predictions = 0;            // that they took
    std::string why_differences{};  // that they are, in a short phrase; empty: they are exact
    std::vector<double> lengths() const;
};
Steps steps_for(const std::vector<double>& lengths);  // of slopes

// Exact where the model has derivatives, else differences. here: compare() at these shares of the ranges. What cannot be predicted on one side is
// left out. Errors: it cannot be on either side. Cost: differences take 2 free.size() predictions.
Result<Slopes> slopes_at(const Problem& problem, const std::vector<double>& shares, const Steps& steps,
                         const Comparison& here);

}  // namespace nullscope::fit
