#include "fit/problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nullscope::fit {
namespace {

// The scale that makes chi^2 least.
double best_flux(const Observed& data, const Prediction& prediction) {
    double with_data = 0, with_itself = 0;
    for (std::size_t i = 0; i < prediction.size(); ++i) {
        const double weighted = prediction[i] / (data.sigma[i] * data.sigma[i]);
        with_data += weighted * data.value[i], with_itself += weighted * prediction[i];
    }
    return with_itself > 0 ? with_data / with_itself : 1;
}

void scale(Prediction& slope, double factor, const Observed& data) {
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] *= factor / data.sigma[i];
}

// By one parameter.
Result<Prediction> difference(const Problem& problem, const std::vector<double>& shares, std::size_t k, double half,
                              const Comparison& here) {
    // Both places are within the range: next to its end they are not on both sides alike.
    const double from = std::clamp(shares[k] - half, 0.0, 1.0 - 2 * half);
    std::vector<double> values;
    for (std::size_t i = 0; i < shares.size(); ++i) values.push_back(problem.free[i].at(shares[i]));
    const auto at = [&](double share) {
        values[k] = problem.free[k].at(share);
        return compare(problem, values);
    };
    auto low = at(from), high = at(from + 2 * half);
    if (!low && !high) return low.error();
    const double width = low && high ? 2 * half : low ? shares[k] - from : from + 2 * half - shares[k];
    Prediction slope = high ? high->prediction : here.prediction;
    const Prediction& less = low ? low->prediction : here.prediction;
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] -= less[i];
    scale(slope, 1 / width, problem.data);
    return slope;
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

Steps steps_for(const std::vector<double>& lengths) {
    Steps steps;
    for (const double length : lengths)
        steps.half.push_back(std::clamp(0.5 * kStepChange / length, kShortestStep, kLongestStep));
    return steps;
}

std::vector<double> Slopes::lengths() const {
    std::vector<double> lengths;
    for (const Prediction& column : columns)
        lengths.push_back(std::sqrt(std::inner_product(column.begin(), column.end(), column.begin(), 0.0)));
    return lengths;
}

Result<Slopes> slopes_at(const Problem& problem, const std::vector<double>& shares, const Steps& steps,
                         const Comparison& here) {
    std::vector<double> values;
    for (std::size_t i = 0; i < shares.size(); ++i) values.push_back(problem.free[i].at(shares[i]));
    auto exact = problem.free_flux ? failed("the flux is free") : problem.model.derivatives(values);
    if (exact) {
        for (std::size_t k = 0; k < exact->size(); ++k)
            scale((*exact)[k], problem.free[k].high - problem.free[k].low, problem.data);
        return Slopes{std::move(*exact)};
    }
    Slopes slopes;
    const Error& none = exact.error();
    slopes.why_differences = none.key.empty() ? none.what : none.key + ": " + none.what;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        TRY(slope, difference(problem, shares, k, steps.half[k], here));
        slopes.columns.push_back(std::move(*slope));
        slopes.predictions += 2;
    }
    return slopes;
}

}  // namespace nullscope::fit
