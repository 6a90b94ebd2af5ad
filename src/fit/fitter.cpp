#include "fit/fitter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope::fit {
namespace {

constexpr std::size_t kMostRefined = 6;
constexpr double kNotWorse = 25;  // of chi^2 of coarser data: answers that all data may prefer

// With all data: answers that are nearly as good as the best with fewer are refined, of the others chi^2 alone is new.
Status refine_answers(const Problem& problem, Fitted& fitted) {
    const double least = fitted.answers.front().solution.chi2;
    std::size_t refined = 0;
    for (Answer& answer : fitted.answers) {
        if (refined < kMostRefined && answer.solution.chi2 <= least + kNotWorse) {
            TRY(solution, solve(problem, answer.solution.values, first_steps(problem.free.size())));
            fitted.predictions += solution->predictions, ++refined;
            answer.solution = std::move(*solution);
        } else {
            TRY(compared, compare(problem, answer.solution.values));
            ++fitted.predictions;
            answer.solution.chi2 = compared->chi2;
        }
    }
    fitted.answers = distinct(problem, std::move(fitted.answers));
    return Done{};
}

// N standard deviations to either side chi^2 is larger by N^2 at least, by more where parameters are correlated. Where it is not on either, its derivative was
// a picture's grain, whose own chi^2 does not grow: the data do not determine the parameter, of which the range is all that is known.
constexpr double kFarSigmas = 4, kLeastRise = 0.25;  // of N^2
void doubt_grain(const Problem& problem, Fitted& fitted, Solution& solution) {
    for (std::size_t i = 0; i < solution.sigma.size(); ++i) {
        const double low = solution.values[i] - problem.free[i].low, high = problem.free[i].high - solution.values[i],
                     sigma = solution.sigma[i];
        bool looked = false, rises = false;
        for (const double step : {-std::min(kFarSigmas * sigma, low), std::min(kFarSigmas * sigma, high)}) {
            if (std::fabs(step) < sigma) continue;  // there is no room
            std::vector<double> values = solution.values;
            values[i] += step;
            const auto there = compare(problem, values);
            ++fitted.predictions, looked = true;
            rises = rises || !there || there->chi2 - solution.chi2 > kLeastRise * (step / sigma) * (step / sigma);
        }
        if (looked && !rises) solution.sigma[i] = problem.free[i].high - problem.free[i].low;
    }
}

// In standard deviations; without these infinite.
double most_moved(const Solution& from, const Solution& to) {
    if (to.sigma.empty()) return HUGE_VAL;
    double most = 0;
    for (std::size_t i = 0; i < to.sigma.size(); ++i)
        most = std::max(most, std::fabs(to.values[i] - from.values[i]) / to.sigma[i]);
    return most;
}

}  // namespace

Result<Fitted> run_fit(const Problem& problem, const Problem* coarse, const SearchOptions& options,
                       const std::function<bool()>& finer) {
    TRY(searched, search(coarse != nullptr ? *coarse : problem, options));
    Fitted fitted;
    fitted.answers = std::move(searched->answers), fitted.predictions = searched->predictions;
    for (const Answer& answer : fitted.answers) fitted.starts += answer.starts;
    const Advance advance = options.progress("fit of all data", 2);
    TRY(refined, refine_answers(problem, fitted));
    Solution best = fitted.answers.front().solution;
    advance(1);
    if (finer) finer();
    do {
        TRY(again, solve(problem, best.values, steps_at(best)));
        fitted.predictions += again->predictions;
        fitted.moved = most_moved(best, *again);
        best = std::move(*again);
    } while (fitted.moved > kStays && finer && finer());
    doubt_grain(problem, fitted, best);
    advance(1);
    fitted.best = std::move(best);
    fitted.goodness =
        goodness_of(fitted.best.chi2, problem.data.value.size(), problem.free.size() + (problem.free_flux ? 1 : 0));
    return fitted;
}

}  // namespace nullscope::fit
