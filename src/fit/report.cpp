#include "fit/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/text.h"

namespace nullscope::fit {
namespace {

constexpr double kNotDetermined = 0.5;  // of a range: a standard deviation of that says nothing

bool is_determined(const Solution& best, const std::vector<FreeParameter>& free, std::size_t i) {
    return !best.sigma.empty() && best.sigma[i] < kNotDetermined * (free[i].high - free[i].low);
}

// Digits behind the point for two of the standard deviation.
int decimals_of(double sigma) {
    constexpr int kMost = 12;
    return std::clamp(static_cast<int>(std::ceil(1 - std::log10(sigma))), 0, kMost);
}

std::string row_of(const Reported& reported, std::size_t i) {
    const Solution& best = reported.fitted.best;
    const FreeParameter& one = reported.free[i];
    const double value = best.values[i];
    std::string row;
    if (reported.fitted.goodness.is_bad()) {
        row = fmt::format("{:<24} {:.6g}", one.key, value);
    } else if (is_determined(best, reported.free, i)) {
        const double sigma = best.sigma[i];
        const int decimals = decimals_of(sigma);
        row = fmt::format("{:<24} {:<12.{}f} {:.{}f} to {:.{}f} (+- {:.2g})", one.key, value, decimals, value - sigma,
                          decimals, value + sigma, decimals, sigma);
    } else {
        row = fmt::format("{:<24} {:<12.6g} the data do not determine it", one.key, value);
    }
    if (best.at_end(reported.free, i)) row += fmt::format("; at the end of its range, {:g}:{:g}", one.low, one.high);
    return row;
}

std::string correlation_table(const Reported& reported) {
    const std::size_t n = reported.free.size();
    const Solution& best = reported.fitted.best;
    if (n < 2 || best.correlation.empty() || reported.fitted.goodness.is_bad()) return "";
    std::string table = "correlations\n";
    for (std::size_t i = 0; i < n; ++i) {
        table += fmt::format("{:<24}", reported.free[i].key);
        for (std::size_t j = 0; j <= i; ++j) table += fmt::format(" {:6.2f}", best.correlation[i * n + j]);
        table += '\n';
    }
    return table;
}

std::string answer_words(const Reported& reported) {
    const auto& answers = reported.fitted.answers;
    const int starts = reported.fitted.starts;
    std::string words = counted(starts, "start");
    words += answers.size() > 1 ? fmt::format(", {} to the best answer\n", answers.front().starts)
             : starts > 1       ? ", all to this answer\n"
                                : "\n";
    for (std::size_t k = 1; k < answers.size(); ++k) {
        words += fmt::format("  {} to one whose chi^2 is larger by {:.4g}:", answers[k].starts,
                             answers[k].solution.chi2 - answers.front().solution.chi2);
        for (std::size_t i = 0; i < reported.free.size(); ++i)
            words += fmt::format(" {} {:.4g}", reported.free[i].key, answers[k].solution.values[i]);
        words += '\n';
    }
    return words;
}

std::string goodness_words(const Goodness& goodness) {
    return fmt::format("chi^2 {:.6g} of {}, {:.4g} of each; probability {:.2g}\n", goodness.chi2,
                       counted(goodness.degrees, "degree of freedom", "degrees of freedom"), goodness.per_degree(),
                       goodness.probability);
}

std::string derivative_words(const Solution& best) {
    if (best.why_differences.empty()) return "derivatives by each parameter: exact\n";
    return fmt::format("derivatives by each parameter: differences ({})\n", without_controls(best.why_differences));
}

}  // namespace

std::string bad_words(const Goodness& goodness) {
    if (!goodness.is_bad()) return "";
    return fmt::format("this scene does not describe the data: chi^2/dof {:.3g}", goodness.per_degree());
}

std::string fit_table(const Reported& reported) {
    std::string table = fmt::format("{}, {}, {}{}\n", reported.data, counted(std::ssize(reported.free), "parameter"),
                                    counted(reported.fitted.predictions, "prediction"),
                                    reported.samples ? fmt::format(", {0} x {0} rays a pixel", *reported.samples) : "");
    for (std::size_t i = 0; i < reported.free.size(); ++i) table += row_of(reported, i) + '\n';
    if (reported.free_flux) table += fmt::format("{:<24} {:.6g}\n", "flux", reported.fitted.best.flux);
    table += goodness_words(reported.fitted.goodness) + correlation_table(reported) + answer_words(reported) +
             derivative_words(reported.fitted.best);
    if (!reported.fitted.best.converged)
        table += "the solver has not settled: other starts or narrower ranges may help\n";
    return table;
}

cli::Json fit_json(const Reported& reported) {
    const Solution& best = reported.fitted.best;
    const Goodness& goodness = reported.fitted.goodness;
    const std::size_t n = reported.free.size();
    cli::Json json{{"data", reported.data}, {"describes_the_data", !goodness.is_bad()}};
    for (std::size_t i = 0; i < n; ++i) {
        const FreeParameter& one = reported.free[i];
        const bool known = !goodness.is_bad() && is_determined(best, reported.free, i);
        json["parameters"].push_back({{"key", one.key},
                                      {"best", best.values[i]},
                                      {"sigma", known ? cli::Json(best.sigma[i]) : cli::Json(nullptr)},
                                      {"low", one.low},
                                      {"high", one.high},
                                      {"at_end", best.at_end(reported.free, i)},
                                      {"derivative", best.why_differences.empty() ? "exact" : "differences"}});
    }
    json["samples"] = reported.samples ? cli::Json(*reported.samples) : cli::Json(nullptr);
    json["why_differences"] = best.why_differences.empty() ? cli::Json(nullptr) : cli::Json(best.why_differences);
    json["flux"] = best.flux;
    json["chi2"] = goodness.chi2, json["degrees_of_freedom"] = goodness.degrees;
    json["probability"] = goodness.probability, json["converged"] = best.converged;
    json["predictions"] = reported.fitted.predictions;
    json["covariance"] = nullptr;
    if (!best.sigma.empty() && !goodness.is_bad()) {
        json["covariance"] = cli::Json::array();
        for (std::size_t i = 0; i < n; ++i) {
            cli::Json row = cli::Json::array();
            for (std::size_t j = 0; j < n; ++j)
                row.push_back(best.correlation[i * n + j] * best.sigma[i] * best.sigma[j]);
            json["covariance"].push_back(row);
        }
    }
    for (const Answer& answer : reported.fitted.answers)
        json["answers"].push_back(
            {{"values", answer.solution.values}, {"chi2", answer.solution.chi2}, {"starts", answer.starts}});
    return json;
}

}  // namespace nullscope::fit
