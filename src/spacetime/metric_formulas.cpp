#include "spacetime/metric_formulas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope {
namespace {

constexpr double kNothingLeft = 4e-17;  // of the leading term: a fifth of a rounding
constexpr int kLastTerms = 4;           // all of them that small: even series have no odd terms
constexpr double kNarrowest = 1e-9;     // of the width that is tried first

}  // namespace

Result<MetricFormulas> MetricFormulas::parse(const std::map<std::string, std::string>& texts) {
    MetricFormulas made;
    for (const auto& [name, text] : texts) {
        const auto formula = expr::SmoothFormula::parse(text, "r");
        if (!formula) return bad_key(name, formula.error().what, "a smooth formula of r");
        if (name != "A") {
            (name == "B" ? made.b_ : made.r_) = *formula;
            continue;
        }
        TRY(a, expr::Formula::parse(text, {"r"}));
        made.a_ = *formula, made.a_text_ = std::move(*a);
    }
    return made;
}

expr::Interval MetricFormulas::lapse2_range(double low, double high) const {
    const std::array values = {expr::Interval{low, high}};
    return expr::range(a_text_, values);
}

Expansion::Expansion(const expr::Series<double, kTerms + 4>& series, int lead, double widest) : lead_(lead) {
    for (int k = 0; k < kTerms; ++k) c_[static_cast<std::size_t>(k)] = series.of_power(k);
    if (series.power < 0 &&
        !std::all_of(series.c.begin(), series.c.begin() - series.power, [](double c) { return c == 0.0; }))
        return;
    if (!std::all_of(c_.begin(), c_.end(), [](double c) { return std::isfinite(c); })) return;
    const double leading = std::fabs(term(lead));
    for (double x = widest; x > kNarrowest * widest; x *= 0.9) {
        bool good = true;
        for (int k = kTerms - kLastTerms; k < kTerms; ++k)
            good = good && std::fabs(term(k)) * std::pow(x, k - lead) <= kNothingLeft * leading;
        if (!good) continue;
        reach_ = x;
        return;
    }
}

double Expansion::over_lead(double x) const {
    double sum = 0.0;
    for (int k = kTerms - 1; k >= lead_; --k) sum = term(k) + x * sum;
    return sum;
}

double Expansion::over_lead_slope(double x) const {
    double sum = 0.0;
    for (int k = kTerms - 1; k > lead_; --k) sum = (k - lead_) * term(k) + x * sum;
    return sum;
}

double Expansion::over_lead_curvature(double x) const {
    double sum = 0.0;
    for (int k = kTerms - 1; k > lead_ + 1; --k) sum = (k - lead_) * (k - lead_ - 1) * term(k) + x * sum;
    return sum;
}

}  // namespace nullscope
