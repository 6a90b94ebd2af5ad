#include "fit/likelihood.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope::fit {

Likelihood::Likelihood(Subject subject, std::vector<FreeParameter> free, bool free_flux)
    : subject_(std::move(subject)), free_(std::move(free)), free_flux_(free_flux), steps_(first_steps(free_.size())) {
    for (const double sigma : subject_.data.sigma) constant_ -= std::log(sigma * std::sqrt(2 * M_PI));
}

Problem Likelihood::problem() const { return {subject_.data, *subject_.model, free_, free_flux_, Loss::kSquare}; }

std::vector<double> Likelihood::shares_of(const std::vector<double>& values) const {
    std::vector<double> shares;
    for (std::size_t i = 0; i < free_.size(); ++i) shares.push_back(free_[i].share(values[i]));
    return shares;
}

Result<Likelihood> Likelihood::make(Subject subject, std::vector<FreeParameter> free, bool free_flux,
                                    const std::vector<double>& around) {
    Likelihood made(std::move(subject), std::move(free), free_flux);
    std::vector<double> place = around;
    if (place.empty())
        for (const FreeParameter& one : made.free_) place.push_back(one.at(0.5));
    TRY(here, compare(made.problem(), place));
    TRY(slopes, slopes_at(made.problem(), made.shares_of(place), made.steps_, *here));
    made.steps_ = steps_for(slopes->lengths());
    return made;
}

Result<Likelihood::At> Likelihood::at(const std::vector<double>& values, bool with_slope) {
    At found{-HUGE_VAL, std::vector<double>(with_slope ? free_.size() : 0)};
    const std::vector<double> shares = shares_of(values);
    if (!std::ranges::all_of(shares, [](double share) { return share >= 0 && share <= 1; })) return found;
    const Problem here_problem = problem();
    const auto here = compare(here_problem, values);
    if (!here && here.error().kind == ErrorKind::kBadInput) return found;
    if (!here) return here.error();
    found.log = constant_ - 0.5 * here->chi2;
    if (!with_slope) return found;
    TRY(slopes, slopes_at(here_problem, shares, steps_, *here));
    const Observed& data = subject_.data;
    for (std::size_t k = 0; k < free_.size(); ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < data.value.size(); ++i)
            sum += (data.value[i] - here->prediction[i]) / data.sigma[i] * slopes->columns[k][i];
        found.slope[k] = sum / (free_[k].high - free_[k].low);
    }
    return found;
}

Result<Prediction> Likelihood::predict(const std::vector<double>& values) {
    TRY(compared, compare(problem(), values));
    return std::move(compared->prediction);
}

Result<std::vector<Prediction>> Likelihood::derivatives(const std::vector<double>& values) {
    const Problem here_problem = problem();
    TRY(here, compare(here_problem, values));
    TRY(slopes, slopes_at(here_problem, shares_of(values), steps_, *here));
    for (std::size_t k = 0; k < free_.size(); ++k)
        for (std::size_t i = 0; i < here->prediction.size(); ++i)
            slopes->columns[k][i] *= subject_.data.sigma[i] / (free_[k].high - free_[k].low);
    return std::move(slopes->columns);
}

}  // namespace nullscope::fit
