// The reference against 50-digit vectors of a rotating hole, a/M = 0.9: every row. The file's unit of length is M, ours 2 M.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/kerr_ray.h"
#include "reference/reference.h"
#include "support/folders.h"
#include "vector_file.h"

namespace {

using namespace nullscope;
using reference::KerrRay;
using reference::KerrStart;

constexpr double kSpin = 0.9;
constexpr double kKerrVectorsTolerance =
    1e-10;  // times the condition number: what the project promises for the reference
// Of the inputs, for the condition number: halfway between rounding and the nearest critical ray.
constexpr double kNudge = 1e-10;
constexpr int kCrossings = 2;

struct Column {
    const char* name;
    bool angle;  // compared modulo a turn
    double (*value)(const KerrRay&);
};
const Column kColumns[] = {
    {"th_inf", false, [](const KerrRay& ray) { return std::atan2(std::hypot(ray.sky.x, ray.sky.y), ray.sky.z); }},
    {"dphi_inf", true, [](const KerrRay& ray) { return ray.phi_inf; }},
    {"r_1", false, [](const KerrRay& ray) { return ray.crossings.empty() ? kNotANumber : 2 * ray.crossings[0].r; }},
    {"dphi_1", true, [](const KerrRay& ray) { return ray.crossings.empty() ? kNotANumber : ray.crossings[0].phi; }},
    {"r_2", false, [](const KerrRay& ray) { return ray.crossings.size() < 2 ? kNotANumber : 2 * ray.crossings[1].r; }},
    {"dphi_2", true, [](const KerrRay& ray) { return ray.crossings.size() < 2 ? kNotANumber : ray.crossings[1].phi; }},
};

KerrStart start_of(const VectorRow& row) {
    Vec3 n{number(row, "n_r"), number(row, "n_th"), number(row, "n_ph")};
    return {0.5 * number(row, "r0"), number(row, "theta0"), 0.0, normalized(n)};
}

double apart(const Column& column, double a, double b) {
    return std::abs(column.angle ? std::remainder(a - b, 2 * M_PI) : a - b);
}

// How much a relative change of r, theta and of the view direction comes back multiplied by, relative to max(1, |value|).
double condition_number(const KerrStart& start, const Column& column, double here) {
    double sum = 0;
    for (int input = 0; input < 4; ++input) {
        double worst = 0;
        for (const double h : {kNudge, -kNudge}) {
            KerrStart moved = start;
            if (input == 0) moved.r *= 1 + h;
            if (input == 1) moved.theta *= 1 + h;
            if (input == 2) moved.direction = normalized(moved.direction + h * Vec3{0, 1, 0});
            if (input == 3) moved.direction = normalized(moved.direction + h * Vec3{0, 0, 1});
            const double change =
                apart(column, column.value(reference::trace_kerr(kSpin, moved, kCrossings)), here) / kNudge;
            if (std::isfinite(change)) worst = std::max(worst, change);
        }
        sum += worst;
    }
    return std::max(1.0, sum / std::max(1.0, std::abs(here)));
}

struct Worst {
    double error = 0;
    int rows = 0, fates = 0;
};

// bias: added to every view direction, to see the check fail.
Worst compare(double bias) {
    Worst worst;
    for (const VectorRow& row : load_vectors(test::data_folder() / "vectors/kerr_a0.9.csv")) {
        KerrStart start = start_of(row);
        start.direction = normalized(start.direction + bias * Vec3{0, 1, 0});
        const KerrRay ray = reference::trace_kerr(kSpin, start, kCrossings);
        ++worst.rows;
        worst.fates += (ray.fate == Fate::kCaptured) != (number(row, "status") == 1);
        if (bias == 0) {
            CAPTURE(row.at("id"));
            CHECK(std::abs(number(row, "g") * ray.energy - 1) < 1e-13);
            CHECK(std::abs(number(row, "lambda") - 2 * ray.l_z) < 1e-13 * std::max(1.0, std::abs(ray.l_z)));
        }
        for (const Column& column : kColumns) {
            const bool at_end = &column < &kColumns[2];
            if (at_end && ray.fate == Fate::kCaptured) continue;  // the file gives theta at the horizon there
            const double expected = number(row, column.name), found = column.value(ray);
            if (bias == 0) {
                CAPTURE(row.at("id"));
                CAPTURE(std::string(column.name));
                CHECK(std::isnan(expected) == std::isnan(found));
            }
            if (std::isnan(expected) || std::isnan(found)) continue;
            const double error = apart(column, expected, found) / std::max(1.0, std::abs(expected));
            if (error <= kKerrVectorsTolerance) {
                worst.error = std::max(worst.error, error);
                continue;
            }
            worst.error = std::max(worst.error, error / condition_number(start, column, found));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("the reference meets every row of the Kerr vectors") {
    const Worst worst = compare(0);
    fmt::print("kerr_a0.9.csv: {} rows, largest error over condition number {:.2g}\n", worst.rows, worst.error);
    CHECK(worst.rows == 172);
    CHECK(worst.fates == 0);
    CHECK(worst.error <= kKerrVectorsTolerance);
}

TEST_CASE("a view direction off by 1e-8 is found by the Kerr vectors") {
    CHECK(compare(1e-8).error > kKerrVectorsTolerance);
}

TEST_CASE("without spin the integrated rays are Schwarzschild's") {
    Scene scene;
    for (const Vec3 n :
         {Vec3{-0.95, 0.2, 0.24}, Vec3{-0.2, -0.5, 0.8}, Vec3{0.3, 0.1, -0.9}, Vec3{-0.999, 0.01, 0.02}}) {
        RayQuery query;
        query.r = 7, query.theta = 1.1, query.phi = 0.4, query.n = normalized(n);
        const auto exact = reference::trace_ray(scene, query, 1);
        const KerrRay ray = reference::trace_kerr(0, {query.r, query.theta, query.phi, query.n}, 1);
        REQUIRE(exact);
        REQUIRE(exact->fate == ray.fate);
        CHECK(std::abs(exact->g * ray.energy - 1) < 1e-14);
        if (ray.fate == Fate::kEscaped) CHECK(length(exact->sky - ray.sky) < 1e-11);
        REQUIRE(exact->crossings.size() == ray.crossings.size());
        if (!ray.crossings.empty())
            CHECK(std::abs(exact->crossings[0].r - ray.crossings[0].r) < 1e-11 * ray.crossings[0].r);
    }
}
