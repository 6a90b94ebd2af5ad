// Formulas: values, precedence, limits, and a value for every input.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "expr/formula.h"
#include "scene/named_surface.h"

using namespace nullscope;
using namespace std::string_literals;
using expr::Formula;

namespace {

const std::vector<std::string> kNames = {"x", "y", "z"};

double value(const std::string& text, double x = 0, double y = 0, double z = 0) {
    const auto formula = Formula::parse(text, kNames);
    REQUIRE_MESSAGE(formula, text);
    const double values[] = {x, y, z};
    return formula->value(values);
}

std::string fault(const std::string& text) {
    const auto formula = Formula::parse(text, kNames);
    REQUIRE_FALSE_MESSAGE(formula, text);
    return formula.error().message();
}

std::string repeated(const std::string& what, int n) {
    std::string text;
    for (int i = 0; i < n; ++i) text += what;
    return text;
}

}  // namespace

TEST_CASE("formulas: numbers, precedence, association") {
    CHECK(value("1 + 2 * 3") == 7);
    CHECK(value("(1 + 2) * 3") == 9);
    CHECK(value("8 - 4 - 2") == 2);
    CHECK(value("16 / 4 / 2") == 2);
    CHECK(value("2^3^2") == doctest::Approx(512));  // an exponent that is computed goes by logarithms
    CHECK(value("-3^2") == -9);
    CHECK(value("(-3)^2") == 9);
    CHECK(value("2^-2") == 0.25);
    CHECK(value("- - 2") == 2);
    CHECK(value("2 * -3") == -6);
    CHECK(value("1.5e2 + .5") == 150.5);
    CHECK(value("x * y - z", 2, 3, 4) == 2);
    CHECK(value("pi") == M_PI);
}

TEST_CASE("formulas: functions") {
    CHECK(value("sin(x)", 0.5) == std::sin(0.5));
    CHECK(value("atan(y, x)", -1, 0) == M_PI);
    CHECK(value("atan(1)") == std::atan(1.0));
    CHECK(value("length(x, y)", 3, 4) == 5);
    CHECK(value("length(x, y, z)", 2, 3, 6) == 7);
    CHECK(value("clamp(x, 0, 1)", 3) == 1);
    CHECK(value("mix(2, 4, 0.25)") == 2.5);
    CHECK(value("step(0.5, x)", 0.5) == 1);
    CHECK(value("step(0.5, x)", 0.4999) == 0);
    CHECK(value("smoothstep(0, 2, 1)") == 0.5);
    CHECK(value("smoothstep(2, 0, 2)") == 0);
    CHECK(value("mod(-1, 3)") == 2);
    CHECK(value("floor(-0.5)") == -1);
    CHECK(value("min(1, 2) + max(1, 2)") == 3);
    CHECK(value("2^0.5") == doctest::Approx(std::sqrt(2.0)));
    CHECK(value("noise(x)", 7) != value("noise(x)", 8));
}

TEST_CASE("formulas: what is not understood says where and what is near") {
    CHECK(fault("").find("column 1") == 0);
    CHECK(fault("x +").find("the formula ends") != std::string::npos);
    CHECK(fault("x y").find("column 3: an operator or the end is missing") == 0);
    CHECK(fault("sinn(x)").find("nearest: sin") != std::string::npos);
    CHECK(fault("w").find("column 1: \"w\" is not known") == 0);
    CHECK(fault("atan(x, y, z)").find("atan does not take 3 arguments") != std::string::npos);
    CHECK(fault("min(1, 2, 3, 4)").find("more than 3 arguments") != std::string::npos);
    CHECK(fault("(x").find("a ) is missing") != std::string::npos);
    CHECK(fault("1e400").find("not a number up to 1e30") != std::string::npos);
    CHECK(fault("system(x)").find("no function \"system\"") != std::string::npos);
    CHECK(fault("x = 1").find("column 3") == 0);
    CHECK(fault("t").find("not known") != std::string::npos);
}

TEST_CASE("formulas: limits of length, size and depth, on either side") {
    CHECK(Formula::parse(std::string(expr::kLongest - 1, ' ') + "x", kNames));
    CHECK(fault(std::string(expr::kLongest, ' ') + "x").find("longer than 1000 bytes") != std::string::npos);
    const int sum = static_cast<int>(expr::kMostNodes) / 2 - 1;  // x+x+...: two nodes a term after the first
    CHECK(Formula::parse("x"s + repeated("+x", sum), kNames));
    CHECK(fault("x"s + repeated("+x", sum + 1)).find("more than 256 operands") != std::string::npos);
    CHECK(Formula::parse(repeated("-", expr::kDeepest - 1) + "x", kNames));
    CHECK(fault(repeated("-", expr::kDeepest) + "x").find("nested more than 32 deep") != std::string::npos);
    for (const char* opening : {"(", "-(", "sin(", "2^("})
        CHECK(fault(repeated(opening, 200)).find("deep") != std::string::npos);
    CHECK(fault(repeated("2^", 300) + "2").find("deep") != std::string::npos);
}

TEST_CASE("formulas: a finite value for every input") {
    const std::vector<std::string> texts = {"1/x",
                                            "x/y",
                                            "x^y",
                                            "x^-3",
                                            "sqrt(x)",
                                            "log(x)",
                                            "exp(x)",
                                            "exp(exp(x))",
                                            "tan(x)",
                                            "x*x*x*x",
                                            "mod(x, y)",
                                            "length(x, y, z)",
                                            "smoothstep(x, x, y)",
                                            "noise(x, y, z)",
                                            "sin(x)",
                                            "atan(0, 0)",
                                            "mix(x, y, z)",
                                            "x^16^2",
                                            "floor(x)/floor(y)",
                                            "log(x)^log(y)",
                                            "clamp(x, y, z)"};
    const double odd[] = {0, -0.0, 1, -1, 1e-300, -1e-300, 1e30, -1e30, 0.5, 1e15, -7.25};
    for (const std::string& text : texts)
        for (const double x : odd)
            for (const double y : odd)
                for (const double z : odd) {
                    const double v = value(text, x, y, z);
                    CHECK_MESSAGE((std::isfinite(v) && std::abs(v) <= expr::kLargest), text);
                }
}

TEST_CASE("formulas: noise stays in [0, 1], varies, and is smooth") {
    std::mt19937 random(7);
    double low = 1, high = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto at = [&] { return 200.0 * (static_cast<double>(random()) / 4294967296.0) - 100; };
        const double x = at(), y = at(), z = at(), n = expr::noise(x, y, z);
        CHECK((n >= 0 && n <= 1));
        CHECK(std::abs(expr::noise(x + 1e-6, y, z) - n) < 4e-6);
        low = std::min(low, n), high = std::max(high, n);
    }
    CHECK(low < 0.1);
    CHECK(high > 0.9);
}

TEST_CASE("formulas: their GLSL is one statement a node, of known functions only") {
    const auto formula = Formula::parse("sin(x)^2 + mod(y, -3) / 1e-40 - z^-2", kNames);
    REQUIRE(formula);
    const std::string text = formula->glsl("value");
    CHECK(std::count(text.begin(), text.end(), '\n') == static_cast<int>(formula->nodes().size()) + 1);
    CHECK(text.find("expression_whole_power(") != std::string::npos);
    CHECK(text.find("expression_divide(1.0, expression_whole_power(") != std::string::npos);
    CHECK(text.find("1e-40") == std::string::npos);  // no float
    CHECK(text.find("asin") == std::string::npos);
}

TEST_CASE("every named surface is a formula that can be read, at any size, and solid somewhere") {
    for (std::size_t i = 0; i < kNamedSurfaces.size(); ++i) {
        const NamedSurface& named = kNamedSurfaces[i];
        CAPTURE(std::string(named.key));
        CHECK(static_cast<std::size_t>(named.kind) == i);
        for (const double size : {1e-3, 6.0, 1234.5678901234567}) {
            SurfaceSpec surface;
            surface.kind = named.kind;
            surface.size = size;
            const auto shape = expr::Formula::parse(surface_shape(surface), {"x", "y", "z", "t"});
            REQUIRE_MESSAGE(static_cast<bool>(shape), surface_shape(surface));
            if (named.kind == SurfaceKind::kFormula) continue;
            int inside = 0, outside = 0;
            for (int x = -20; x <= 20; ++x)
                for (int y = -20; y <= 20; ++y)
                    for (int z = -20; z <= 20; ++z) {
                        const double place[] = {0.07 * size * x, 0.07 * size * y, 0.07 * size * z, 0};
                        (shape->value(place) < 0 ? inside : outside)++;
                    }
            CHECK(inside > 200);
            CHECK(outside > 200);
        }
    }
}
