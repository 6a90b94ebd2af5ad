// The reference against 50-digit vectors: every row of tests/vectors/schwarzschild.csv.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <doctest/doctest.h>

#include "reference/reference.h"
#include "support/folders.h"
#include "vector_condition.h"
#include "vector_file.h"

namespace {

using namespace nullscope;

// Allowed relative error in units of the condition number. Double arithmetic leaves about 1e-15 after a chain of ten
// elliptic operations; 1e-11 is what the project promises for the reference.
constexpr double kReferenceVectorsTolerance = 1e-11;
// What is reached (1.6e-15 over these rows and 3000 others), with a margin of 6 for other compilers and mathematical
// libraries.
constexpr double kReached = 1e-14;
// The same for angle, delay and turning point without any condition number (reached: 5e-15).
constexpr double kReachedExactly = 3e-14;
constexpr double kCritical = 0.3849001794597505;

Result<RayRecord> trace(double q, double zeta0, int s, std::optional<double> at) {
    RayQuery query;
    query.orbit = ReducedRay{q, zeta0, s};
    query.at_angle = at;
    return reference::trace_ray(Scene{}, query);
}

void check(const VectorRow& row, const std::string& column, const VectorOutput& output, std::optional<double> at = {}) {
    const double q = number(row, "q"), zeta0 = number(row, "zeta0");
    const int s = static_cast<int>(number(row, "s"));
    const auto record = trace(q, zeta0, s, at);
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
    const double room = std::min(std::abs(q / kCritical - 1), std::abs(1 - zeta0 * zeta0 * (1 - zeta0) / (q * q)));
    const auto at_side = [s](double q_, double zeta_, std::optional<double> at_) { return trace(q_, zeta_, s, at_); };
    const double kappa = condition_number(at_side, q, zeta0, room, output, at);
    CAPTURE(kappa);
    const double error = std::abs(found - expected) / (std::abs(expected) * kappa);
    // The inputs are exact doubles: unless a given swept angle is subtracted from the whole, nothing may be lost.
    if (!at) CHECK(error * kappa <= kReachedExactly);
    static_assert(kReached < kReferenceVectorsTolerance);
    CHECK(error <= kReached);
    if (std::getenv("NULLSCOPE_PRINT_ERRORS")) {
        std::printf("%s %s %s %.3g %.3g\n", row.at("group").c_str(), column.c_str(), row.at("id").c_str(), error,
                    kappa);
    }
}

TEST_CASE("the reference meets every row of the Schwarzschild vectors") {
    const auto rows = load_vectors(test::data_folder() / "vectors/schwarzschild.csv");
    REQUIRE(rows.size() > 100);
    for (const VectorRow& row : rows) {
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
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/schwarzschild.csv")) {
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
