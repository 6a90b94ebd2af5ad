// The reference against 50-digit vectors of other metrics than Schwarzschild: every row, cameras inside the horizon included.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/reference.h"
#include "support/folders.h"
#include "vector_condition.h"
#include "vector_file.h"

namespace {

using namespace nullscope;

constexpr double kMetricVectorsTolerance =
    1e-11;  // times the condition number: what the project promises for the reference

using Trace = VectorTrace;
using Output = VectorOutput;

// A column of a row against what is traced from (q, zeta0); worst keeps the largest error over the condition number.
void check_column(const VectorRow& row, const Trace& trace, double q, double zeta0, double room, const char* column,
                  const Output& output, std::optional<double> at, double& worst) {
    CAPTURE(std::string(column));
    const double expected = number(row, column), found = output(*trace(q, zeta0, at));
    CAPTURE(expected);
    CAPTURE(found);
    if (std::isnan(expected)) {
        CHECK(std::isnan(found));
        return;
    }
    const double kappa = condition_number(trace, q, zeta0, room, output, at);
    CAPTURE(kappa);
    const double error = std::abs(found - expected) / (std::abs(expected) * kappa);
    worst = std::max(worst, error);
    CHECK(error <= kMetricVectorsTolerance);
}

TEST_CASE("the reference meets every row of the extremal Reissner-Nordstrom vectors") {
    double worst = 0;
    int rows = 0, inside = 0;
    Scene scene;
    scene.spacetime = {"reissner-nordstrom", {{"charge", 1.0}}};
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/rn_extremal.csv")) {
        const double q = number(row, "q"), zeta0 = number(row, "zeta0"), v = zeta0 * (1 - 0.5 * zeta0);
        const int s = static_cast<int>(number(row, "s")), status = static_cast<int>(number(row, "status"));
        const Trace trace = [&](double q_, double zeta_, std::optional<double> at) {
            RayQuery query;
            query.orbit = ReducedRay{q_, zeta_, s};
            query.at_angle = at;
            return reference::trace_ray(scene, query);
        };
        CAPTURE(row.at("id"));
        CAPTURE(row.at("group"));
        const auto record = trace(q, zeta0, {});
        REQUIRE(record);
        CHECK(record->fate == (status == 0 ? Fate::kEscaped : status == 1 ? Fate::kCaptured : Fate::kNoSky));
        ++rows;
        inside += zeta0 >= 2;
        const double room = std::min(std::abs(q / 0.5 - 1), std::abs((q - v) * (q + v) / (q * q)));
        const auto check = [&](const char* column, const Output& output, std::optional<double> at) {
            check_column(row, trace, q, zeta0, room, column, output, at, worst);
        };
        check("phi", [](const RayRecord& r) { return r.angle; }, {});
        check("T", [](const RayRecord& r) { return r.delay; }, {});
        check("zeta_turn", [](const RayRecord& r) { return r.turn; }, {});
        check(
            "zeta_a", [](const RayRecord& r) { return r.at; }, number(row, "phi_a"));
        check(
            "zeta_b", [](const RayRecord& r) { return r.at; }, number(row, "phi_b"));
        if (!std::isnan(
                number(row, "g_static")))  // g = 1/(1 - zeta0/2): a few roundings, as often as that multiplies them
            CHECK(std::abs(record->g / number(row, "g_static") - 1) * std::min(1.0, std::abs(1 - 0.5 * zeta0)) < 2e-15);
    }
    fmt::print(
        "rn_extremal.csv: {} rows ({} with the camera on or inside the horizon), largest error over condition number "
        "{:.2g}\n",
        rows, inside, worst);
    CHECK(rows == 126);
}

TEST_CASE("the reference meets every row of the Ellis vectors") {
    double worst = 0;
    int rows = 0;
    Scene scene;
    scene.spacetime = {"ellis", {}};
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/ellis.csv")) {
        const double h = number(row, "h"), l0 = number(row, "l0");
        const int s = static_cast<int>(number(row, "s"));
        const Trace trace = [&](double q_, double l_, std::optional<double> at) {
            RayQuery query;
            query.orbit = ReducedRay{q_, l_, -s};
            query.at_angle = at;
            return reference::trace_ray(scene, query);
        };
        CAPTURE(row.at("id"));
        CAPTURE(row.at("group"));
        const auto record = trace(1 / h, l0, {});
        REQUIRE(record);
        CHECK(record->fate == (number(row, "end") > 0 ? Fate::kEscaped : Fate::kOtherSide));
        ++rows;
        const double room = std::min(std::abs(h - 1), std::abs(1 - h * h / (l0 * l0 + 1)));
        const auto check = [&](const char* column, const Output& output, std::optional<double> at) {
            check_column(row, trace, 1 / h, l0, room, column, output, at, worst);
        };
        check("phi", [](const RayRecord& r) { return r.angle; }, {});
        check("T", [](const RayRecord& r) { return r.delay; }, {});
        check("l_turn", [](const RayRecord& r) { return r.turn; }, {});
        check(
            "l_a", [](const RayRecord& r) { return r.at; }, number(row, "phi_a"));
    }
    fmt::print("ellis.csv: {} rows, largest error over condition number {:.2g}\n", rows, worst);
    CHECK(rows == 135);
}

TEST_CASE("the reference meets every row of the vectors of charges without horizon") {
    double worst = 0;
    int rows = 0;
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/rn_naked.csv")) {
        Scene scene;
        scene.spacetime = {"reissner-nordstrom", {{"charge", number(row, "charge")}}};
        const double q = number(row, "q"), zeta0 = number(row, "zeta0"), charge = number(row, "charge");
        const int s = static_cast<int>(number(row, "s"));
        const Trace trace = [&](double q_, double zeta_, std::optional<double> at) {
            RayQuery query;
            query.orbit = ReducedRay{q_, zeta_, s};
            query.at_angle = at;
            return reference::trace_ray(scene, query);
        };
        CAPTURE(charge);
        CAPTURE(q);
        const auto record = trace(q, zeta0, {});
        REQUIRE(record);
        CHECK(record->fate == Fate::kEscaped);
        ++rows;
        const auto check = [&](const char* column, const Output& output) {
            check_column(row, trace, q, zeta0, 1e-2, column, output, {}, worst);
        };
        check("phi", [](const RayRecord& r) { return r.angle; });
        check("T", [](const RayRecord& r) { return r.delay; });
        check("zeta_turn", [](const RayRecord& r) { return r.turn; });
        // The place at a swept angle, by its own definition: what a camera there still has to sweep.
        for (const double part : {0.1, 0.4, 0.6, 0.9, 0.999}) {
            const double at = part * record->angle, zeta = trace(q, zeta0, at)->at;
            RayQuery query;
            int toward = 0;
            for (const int way : {1, -1}) {  // in front of the turn or behind it: the one that sweeps the rest
                query.orbit = ReducedRay{q, zeta, way};
                const auto rest = reference::trace_ray(scene, query);
                if (rest && std::abs(rest->angle / ((1 - part) * record->angle) - 1) < 1e-9) toward = way;
            }
            CAPTURE(part);
            CHECK(toward != 0);
        }
    }
    fmt::print("rn_naked.csv: {} rows, largest error over condition number {:.2g}\n", rows, worst);
    CHECK(rows > 50);
}

// q = 1/h and the impact parameter h itself differ by a rounding: their rows differ by that times the condition number.
TEST_CASE("the reference meets every row of the vectors of James, von Tunzelmann, Franklin and Thorne's wormhole") {
    double worst = 0;
    int rows = 0;
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/dneg.csv")) {
        Scene scene;
        scene.spacetime = {"dneg-wormhole",
                           {{"length", number(row, "length")}, {"lensing_width", number(row, "width")}}};
        const double h = number(row, "h"), l0 = number(row, "l0");
        const int s = static_cast<int>(number(row, "s"));
        const Trace trace = [&](double q_, double l_, std::optional<double> at) {
            RayQuery query;
            query.orbit = ReducedRay{q_, l_, -s};
            query.at_angle = at;
            return reference::trace_ray(scene, query);
        };
        CAPTURE(row.at("id"));
        const auto record = trace(1 / h, l0, {});
        REQUIRE(record);
        CHECK(record->fate == (number(row, "end") > 0 ? Fate::kEscaped : Fate::kOtherSide));
        ++rows;
        const auto check = [&](const char* column, const Output& output) {
            check_column(row, trace, 1 / h, l0, std::abs(h - 1), column, output, {}, worst);
        };
        check("phi", [](const RayRecord& r) { return r.angle; });
        check("T", [](const RayRecord& r) { return r.delay; });
        check("l_turn", [](const RayRecord& r) { return r.turn; });
        // The place at a swept angle, by its own definition: what a camera there still has to sweep.
        for (const double part : {0.1, 0.5, 0.9, 0.999}) {
            const double at = part * record->angle, l = trace(1 / h, l0, at)->at;
            CAPTURE(part);
            CAPTURE(l);
            const double forward =
                std::isfinite(record->turn) ? (l < 0 ? -1 : 1) * (at < record->angle / 2 ? 0 : 1) : s;
            if (forward == 0) continue;  // before or after the turn: not told by l alone
            RayQuery query;
            query.orbit = ReducedRay{1 / h, l, static_cast<int>(l >= 0 ? -forward : forward)};
            const auto rest = reference::trace_ray(scene, query);
            REQUIRE(rest);
            const double bound = 1e-10 + 1e-13 * record->angle / std::abs(h - 1);
            CHECK(std::abs(rest->angle / ((1 - part) * record->angle) - 1) < bound);
        }
    }
    fmt::print("dneg.csv: {} rows, largest error over condition number {:.2g}\n", rows, worst);
    CHECK(rows == 71);
}

TEST_CASE("the reference knows the bending of the Ellis wormhole: alpha = 2 K(1/h^2) - pi") {
    Scene scene;
    scene.spacetime = {"ellis", {}};
    constexpr double kFar = 1e9;  // the camera's own distance takes h/l of the angle
    for (const auto& [h, alpha] : {std::pair{1.1, 1.5022554199624496}, {2.0, 0.22990805603539885}}) {
        RayQuery query;
        query.orbit = ReducedRay{1 / h, kFar, 1};
        const double found = reference::trace_ray(scene, query)->angle + std::asin(h / kFar) - M_PI;
        fmt::print("Ellis, h = {}: alpha = {:.16g}, exact {:.16g}\n", h, found, alpha);
        CHECK(std::abs(found - alpha) < 1e-14);
    }
}

// From afar the ray that grazes the surface sweeps half of pi + its bending: where that bending reaches pi, at a closest approach of
// 3.52061796315193 M, the point behind the star comes into view.
TEST_CASE("a star: all of its surface is seen below 3.52062 M, and not above") {
    constexpr double kWhole = 0.5 * 3.52061796315193, kFar = 1e9, kGraze = 1e-15;
    const auto farthest = [&](double radius) {
        Scene scene;
        scene.spacetime = {"neutron-star", {{"radius", radius}}};
        RayQuery query;  // just inside of the grazing ray: q^2 = V(surface)
        query.orbit = ReducedRay{std::sqrt(1 - 1 / radius) / radius * (1 + kGraze), 1 / kFar, 1};
        const auto record = reference::trace_ray(scene, query);
        REQUIRE(record);
        CHECK(record->fate == Fate::kHit);
        return record->angle;
    };
    fmt::print(
        "star: farthest place seen, rad from the nearest one: {:.12f} at 3.5206 M, {:.12f} at 3.520617963 M, {:.12f} "
        "at 3.5207 M\n",
        farthest(0.5 * 3.5206), farthest(kWhole), farthest(0.5 * 3.5207));
    CHECK(farthest(0.5 * 3.5206) > M_PI);
    CHECK(farthest(0.5 * 3.5207) < M_PI);
    CHECK(std::abs(farthest(kWhole) - M_PI) < 1e-6);  // sqrt(kGraze), and the camera's own b/r
}

}  // namespace
