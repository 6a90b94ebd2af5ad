#include "fit/search.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace nullscope::fit {
namespace {

constexpr double kOtherPlace = 0.15;  // of a range: starts are farther from each other in some parameter
constexpr double kSameAnswer = 0.01, kSameSigmas = 3,
                 kSameMost = 0.1;  // of a range; of a standard deviation, up to so much of a range

struct Place {
    std::vector<double> shares;
    double chi2 = 0;
};

std::vector<double> values_at(const std::vector<FreeParameter>& free, const std::vector<double>& shares) {
    std::vector<double> values;
    for (std::size_t i = 0; i < free.size(); ++i) values.push_back(free[i].at(shares[i]));
    return values;
}

// Multiples of irrational numbers, powers of the root of x^(d + 1) = x + 1, less their whole parts: they fill a cube of d dimensions evenly
// from the first on (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
std::vector<Place> even_places(const std::vector<FreeParameter>& free, int count) {
    const double dimensions = static_cast<double>(std::ranges::count(free, true, &FreeParameter::is_searched));
    double root = 2;
    for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1 / (dimensions + 1));
    std::vector<Place> places(static_cast<std::size_t>(count));
    for (std::size_t n = 0; n < places.size(); ++n) {
        double part = 1;
        for (const FreeParameter& one : free) {
            if (one.is_searched) part /= root;
            const double at = 0.5 + static_cast<double>(n) * part;
            places[n].shares.push_back(one.is_searched ? at - std::floor(at) : 0.5);
        }
    }
    return places;
}

std::vector<Place> random_places(const std::vector<FreeParameter>& free, int count, std::uint64_t seed) {
    std::mt19937_64 dice(seed);
    std::vector<Place> places(static_cast<std::size_t>(count));
    for (Place& place : places)
        for (const FreeParameter& one : free) {
            const double thrown = std::ldexp(static_cast<double>(dice() >> 11), -53);
            place.shares.push_back(one.is_searched ? thrown : 0.5);
        }
    return places;
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i]));
    return most;
}

// The best places that are not next to each other.
std::vector<Place> best_places(const Problem& problem, std::vector<Place> places, const SearchOptions& options,
                               std::optional<Error>& error) {
    const Advance advance = options.progress("places", std::ssize(places));
    std::vector<Place> good;
    for (Place& place : places) {
        auto compared = compare(problem, values_at(problem.free, place.shares));
        if (compared) place.chi2 = compared->chi2, good.push_back(std::move(place));
        if (!compared) error = compared.error();
        advance(1);
    }
    std::ranges::sort(good, {}, &Place::chi2);
    std::vector<Place> best;
    for (Place& place : good)
        if (std::ssize(best) < options.starts && std::ranges::none_of(best, [&](const Place& other) {
                return farthest(place.shares, other.shares) < kOtherPlace;
            }))
            best.push_back(std::move(place));
    return best;
}

bool is_same(const Problem& problem, const Solution& a, const Solution& b) {
    for (std::size_t i = 0; i < problem.free.size(); ++i) {
        const double range = problem.free[i].high - problem.free[i].low;
        double apart = kSameAnswer * range;
        for (const Solution* one : {&a, &b})
            if (!one->sigma.empty()) apart = std::max(apart, std::min(kSameSigmas * one->sigma[i], kSameMost * range));
        if (std::fabs(a.values[i] - b.values[i]) > apart) return false;
    }
    return true;
}

}  // namespace

std::vector<Answer> distinct(const Problem& problem, std::vector<Answer> answers) {
    std::ranges::stable_sort(answers, {}, [](const Answer& answer) { return answer.solution.chi2; });
    std::vector<Answer> others;
    for (Answer& answer : answers) {
        const auto same = std::ranges::find_if(
            others, [&](const Answer& other) { return is_same(problem, other.solution, answer.solution); });
        if (same != others.end()) same->starts += answer.starts;
        if (same == others.end()) others.push_back(std::move(answer));
    }
    return others;
}

Result<Searched> search(const Problem& problem, const SearchOptions& options) {
    std::optional<Error> error;
    const std::vector<Place> starts =
        options.seed ? random_places(problem.free, options.starts, *options.seed)
                     : best_places(problem, even_places(problem.free, options.places), options, error);
    const Steps steps = first_steps(problem.free.size());
    std::vector<Answer> answers;
    Searched searched{{}, options.seed ? 0 : options.places};
    const Advance advance = options.progress("starts", std::ssize(starts));
    for (const Place& start : starts) {
        auto solution = solve(problem, values_at(problem.free, start.shares), steps);
        if (solution) searched.predictions += solution->predictions, answers.push_back({std::move(*solution)});
        if (!solution) error = solution.error();
        advance(1);
    }
    if (answers.empty()) return error.value_or(failed("no start can be predicted"));
    searched.answers = distinct(problem, std::move(answers));
    return searched;
}

}  // namespace nullscope::fit
