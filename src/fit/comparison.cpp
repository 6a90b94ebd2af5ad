// What of solver.h needs no solver.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/solver.h"

namespace nullscope::fit {
namespace {

constexpr double kEnd = 1e-4;  // of a range: what is nearer to an end is at it

// The scale that makes chi^2 least.
double best_flux(const Observed& data, const Prediction& prediction) {
    double with_data = 0, with_itself = 0;
    for (std::size_t i = 0; i < prediction.size(); ++i) {
        const double weighted = prediction[i] / (data.sigma[i] * data.sigma[i]);
        with_data += weighted * data.value[i], with_itself += weighted * prediction[i];
    }
    return with_itself > 0 ? with_data / with_itself : 1;
}

}  // namespace

Result<Comparison> compare(const Problem& problem, const std::vector<double>& values) {
    TRY(prediction, problem.model.predict(values));
    const Observed& data = problem.data;
    Comparison compared{std::move(*prediction)};
    if (problem.free_flux) compared.flux = best_flux(data, compared.prediction);
    for (std::size_t i = 0; i < compared.prediction.size(); ++i) {
        compared.prediction[i] *= compared.flux;
        const double off = (compared.prediction[i] - data.value[i]) / data.sigma[i];
        compared.chi2 += off * off;
    }
    if (!std::isfinite(compared.chi2)) return failed("the model predicts a number that is not finite");
    return compared;
}

Steps first_steps(std::size_t parameters) { return {std::vector<double>(parameters, kFirstStep)}; }

Steps steps_at(const Solution& solution) {
    Steps steps;
    for (const double slope : solution.slope)
        steps.half.push_back(std::clamp(0.5 * kStepChange / slope, kShortestStep, kLongestStep));
    return steps;
}

bool Solution::at_end(const std::vector<FreeParameter>& free, std::size_t i) const {
    const double share = free[i].share(values[i]);
    return share < kEnd || share > 1 - kEnd;
}

}  // namespace nullscope::fit
