// Formulas in other arithmetic than double: series that give derivatives and expansions exactly.
#include <doctest/doctest.h>

#include <cmath>

#include "expr/smooth.h"

namespace {

using namespace nullscope::expr;

constexpr double kSmoothRounding = 4e-15;  // some roundings of terms about 1

SmoothFormula smooth(const std::string& text) {
    const auto formula = SmoothFormula::parse(text, "r");
    REQUIRE_MESSAGE(formula, text);
    return *formula;
}
using Jet = Series<double, 6>;
Jet at(const std::string& text, double r) { return smooth(text).value<double>(Jet::variable(r)); }
Jet far(const std::string& text) { return smooth(text).value<double>(Jet(1.0) / Jet::variable(0.0)); }

// Of the powers from `from` on.
bool same(const Jet& series, int from, const std::vector<double>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (!(std::fabs(series.of_power(from + static_cast<int>(i)) - wanted[i]) < kSmoothRounding)) return false;
    return true;
}

TEST_CASE("series: Taylor's coefficients of every smooth function are those of the textbooks") {
    CHECK(same(at("exp(r)", 0), 0, {1, 1, 1 / 2., 1 / 6., 1 / 24., 1 / 120.}));
    CHECK(same(at("log(r)", 1), 0, {0, 1, -1 / 2., 1 / 3., -1 / 4., 1 / 5.}));
    CHECK(same(at("sin(r)", 0), 0, {0, 1, 0, -1 / 6., 0, 1 / 120.}));
    CHECK(same(at("cos(r)", 0), 0, {1, 0, -1 / 2., 0, 1 / 24., 0}));
    CHECK(same(at("tan(r)", 0), 0, {0, 1, 0, 1 / 3., 0, 2 / 15.}));
    CHECK(same(at("atan(r)", 0), 0, {0, 1, 0, -1 / 3., 0, 1 / 5.}));
    CHECK(same(at("sqrt(r)", 1), 0, {1, 1 / 2., -1 / 8., 1 / 16., -5 / 128., 7 / 256.}));
    CHECK(same(at("1/r", 1), 0, {1, -1, 1, -1, 1, -1}));
    CHECK(same(at("r^-2", 1), 0, {1, -2, 3, -4, 5, -6}));
    CHECK(same(at("r^(3/2)", 1), 0, {1, 3 / 2., 3 / 8., -1 / 16., 3 / 128., -3 / 256.}));
    CHECK(same(at("length(3, r)", 4), 0, {5, 4 / 5., 9 / 250.}));
    CHECK(same(at("mix(r, 2, r)", 1), 0, {2, 1, -1}));
    CHECK_FALSE(same(at("exp(r)", 0), 0, {1, 1, 1 / 2., 1 / 6., 1 / 25.}));  // it can fail
}

TEST_CASE("series: expansions about infinity, from below the power 0 on, and none where there is none") {
    CHECK(same(far("1 - 1/r - 0.01*r^2/3"), -2, {-0.01 / 3, 0, 1, -1}));
    CHECK(same(far("1 - r^2/(r^2 + 0.09)^(3/2)"), 0, {1, -1, 0, 0.135, 0}));
    CHECK(same(far("1 - r^2/(r^3 + 0.5)"), 0, {1, -1, 0, 0, 0.5}));
    CHECK(same(far("sqrt(r^2 + 1) - r"), 0, {0, 0.5, 0}));  // the first term cancels, and leaves fewer
    CHECK(std::isnan(far("sqrt(r^2 + 1) - r").of_power(4)));
    for (const char* none : {"log(r)", "sqrt(r)", "exp(r)", "sin(r)", "atan(r)"}) {
        CAPTURE(none);
        CHECK(std::isnan(far(none).of_power(0)));
    }
}

TEST_CASE("smooth formulas: one that is too long for the values' place on the stack is as one that is not") {
    std::string many = "r";
    for (int i = 2; i <= 20; ++i) many += " + r / " + std::to_string(i) + " - r / " + std::to_string(i);
    for (const double r : {0.25, 3.0}) CHECK(smooth(many).value<double>(r) == doctest::Approx(r).epsilon(1e-14));
    CHECK(same(at(many, 2), 0, {2, 1, 0}));
}

TEST_CASE("smooth formulas: the values of long double and double, and what is refused") {
    for (const char* text : {"1 - 1/r", "(r^2 + 2*r)^1.5 / exp(-r)", "sin(r)^2 + cos(r)^2", "r^16 / r^-3"}) {
        const auto formula = smooth(text);
        const auto plain = *Formula::parse(text, {"r"});
        const double r = 1.7, wanted = plain.value(std::span(&r, 1));
        CHECK(formula.value<double>(r) == doctest::Approx(wanted).epsilon(1e-14));
        CHECK(static_cast<double>(formula.value<long double>(1.7L)) == doctest::Approx(wanted).epsilon(1e-14));
    }
    for (const char* text : {"abs(r)", "max(1, r)", "min(1, r)", "clamp(r, 0, 1)", "step(1, r)", "smoothstep(0, 1, r)",
                             "floor(r)", "mod(r, 1)", "noise(r)", "atan(r, 1)", "1 - 1/", "q"})
        CHECK_FALSE(SmoothFormula::parse(text, "r"));
}

}  // namespace
