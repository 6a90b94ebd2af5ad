// The reference against 50-digit vectors: every row of tests/vectors/schwarzschild.csv.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include <doctest/doctest.h>

#include "base/text.h"
#include "reference/reference.h"

namespace {

using namespace nullscope;

// Allowed relative error in units of the condition number. Double arithmetic leaves about 1e-15 after a chain of ten
// elliptic operations; 1e-11 is what the project promises for its witness.
constexpr double kTolerance = 1e-11;
// What is reached (1.6e-15 over these rows and 3000 others), with a margin of 6 for other compilers and mathematical
// libraries.
constexpr double kReached = 1e-14;
// The same for angle, delay and turning point without any condition number (reached: 5e-15).
constexpr double kReachedExactly = 3e-14;
constexpr double kCritical = 0.3849001794597505;

using Row = std::map<std::string, std::string>;

std::vector<Row> read_rows(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::string> names;
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> cells = split(line, ',');
        if (names.empty()) {
            names = cells;
            continue;
        }
        Row row;
        for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = i < cells.size() ? trim(cells[i]) : "";
        rows.push_back(row);
    }
    return rows;
}

double number(const Row& row, const std::string& name) { return parse_number(row.at(name)).value_or(kNotANumber); }

Result<RayRecord> trace(double q, double zeta0, int s, std::optional<double> at) {
    RayQuery query;
    query.orbit = ReducedRay{q, zeta0, s};
    query.at_angle = at;
    return reference::trace_ray(Scene{}, query);
}

using Output = std::function<double(const RayRecord&)>;

// Condition number of an output y of the inputs x = (q, zeta0, and the swept angle where one is asked for):
//     kappa = max(1, sum_i |x_i dy/dx_i| / |y|),
// the factor by which a relative change of the inputs comes back as a relative change of y. The derivatives are
// one-sided differences of the traced function, the larger side counts; the step stays below the distance to the
// critical ray and to the turning point, where y is singular.
double condition(const Row& row, const Output& output, std::optional<double> at) {
    const double q = number(row, "q"), zeta0 = number(row, "zeta0");
    const int s = static_cast<int>(number(row, "s"));
    const auto here = trace(q, zeta0, s, at);
    const double y = output(*here);
    const double room = std::min(std::abs(q / kCritical - 1), std::abs(1 - zeta0 * zeta0 * (1 - zeta0) / (q * q)));
    const double step = std::max(1e-5 * std::min(1.0, room), 1e-15);
    double sum = 0;
    for (int input = 0; input < (at ? 3 : 2); ++input) {
        double worst = 0;
        for (const double h : {step, -step}) {
            const auto there = trace(q * (input == 0 ? 1 + h : 1), zeta0 * (input == 1 ? 1 + h : 1), s,
                                     at ? std::optional(*at * (input == 2 ? 1 + h : 1)) : at);
            if (!there || there->fate != here->fate) continue;
            const double change = std::abs(output(*there) - y) / (step * std::abs(y));
            if (std::isfinite(change)) worst = std::max(worst, change);
        }
        sum += worst;
    }
    return std::max(1.0, sum);
}

void check(const Row& row, const std::string& column, const Output& output, std::optional<double> at = {}) {
    const auto record = trace(number(row, "q"), number(row, "zeta0"), static_cast<int>(number(row, "s")), at);
    REQUIRE(record);
    const double expected = number(row, column), found = output(*record);
    CAPTURE(row.at("id"));
    CAPTURE(row.at("group"));
    CAPTURE(column);
    CAPTURE(expected);
    CAPTURE(found);
    if (std::isnan(expected)) {
        CHECK(std::isnan(found));
        return;
    }
    const double kappa = condition(row, output, at);
    CAPTURE(kappa);
    const double error = std::abs(found - expected) / (std::abs(expected) * kappa);
    // The inputs are exact doubles: unless a given swept angle is subtracted from the whole, nothing may be lost.
    if (!at) CHECK(error * kappa <= kReachedExactly);
    static_assert(kReached < kTolerance);
    CHECK(error <= kReached);
    if (std::getenv("NULLSCOPE_PRINT_ERRORS")) {
        std::printf("%s %s %s %.3g %.3g\n", row.at("group").c_str(), column.c_str(), row.at("id").c_str(), error,
                    kappa);
    }
}

TEST_CASE("the reference meets every row of the Schwarzschild vectors") {
    const auto rows = read_rows(std::string(NULLSCOPE_TEST_DATA) + "/vectors/schwarzschild.csv");
    REQUIRE(rows.size() > 100);
    for (const Row& row : rows) {
        const double q = number(row, "q"), zeta0 = number(row, "zeta0");
        const int s = static_cast<int>(number(row, "s")), status = static_cast<int>(number(row, "status"));
        const auto record = trace(q, zeta0, s, {});
        REQUIRE(record);
        CAPTURE(row.at("id"));
        CHECK(record->fate == (status == 0 ? Fate::kEscaped : status == 1 ? Fate::kCaptured : Fate::kNoSky));
        check(row, "phi", [](const RayRecord& r) { return r.angle; });
        check(row, "T", [](const RayRecord& r) { return r.delay; });
        check(row, "zeta_turn", [](const RayRecord& r) { return r.turn; });
        check(
            row, "zeta_a", [](const RayRecord& r) { return r.at; }, number(row, "phi_a"));
        check(
            row, "zeta_b", [](const RayRecord& r) { return r.at; }, number(row, "phi_b"));
    }
}

TEST_CASE("the reference's frequency ratio is that of the vectors") {
    // One square root and one division of exact inputs: a few roundings, amplified by 1/(1 - zeta0) of the lapse.
    constexpr double kRoundings = 8 * 2.3e-16;
    for (const Row& row : read_rows(std::string(NULLSCOPE_TEST_DATA) + "/vectors/schwarzschild.csv")) {
        const double expected = number(row, "g_static"), zeta0 = number(row, "zeta0");
        const auto record = trace(number(row, "q"), zeta0, static_cast<int>(number(row, "s")), {});
        REQUIRE(record);
        CAPTURE(row.at("id"));
        if (std::isnan(expected)) {
            CHECK(std::isnan(record->g));
        } else {
            CHECK(std::abs(record->g / expected - 1) <= kRoundings / std::min(1.0, 1 - zeta0));
        }
    }
}

}  // namespace
