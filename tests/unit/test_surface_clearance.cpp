// Bounds of formulas over boxes, and what is empty about a solid by them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/vec.h"
#include "expr/interval.h"
#include "scene/named_surface.h"
#include "table/surface_clearance.h"

namespace {

using namespace nullscope;
using expr::Interval;

expr::Formula formula(const std::string& text) {
    auto parsed = expr::Formula::parse(text, {"x", "y", "z", "t"});
    REQUIRE_MESSAGE(parsed, text);
    return *parsed;
}

// Every operation and function, at arguments of either sign.
const std::array kFormulas = {
    "x + y - z * t",
    "x / y",
    "x / (y^2 + 1)",
    "x^3 - y^4 + z^-2",
    "abs(x)^0.7 + x^y",
    "-x",
    "sin(3 * x) + cos(y)",
    "tan(x) + atan(y)",
    "atan(y, x)",
    "sqrt(x) + abs(y)",
    "exp(x) * log(y)",
    "min(x, y) + max(y, z)",
    "clamp(x, y, z)",
    "mix(x, y, z)",
    "step(x, y)",
    "smoothstep(x, y, z)",
    "floor(3 * x)",
    "mod(x, 0.7) + mod(y, -0.3)",
    "mod(x, y)",
    "length(x, y) - length(x, y, z)",
    "noise(x, y, z) * 2 - 1",
    "(length(x, y) - 2)^2 + z^2 - (0.5 + 0.1 * sin(8 * atan(y, x) - 0.7 * t))^2",
};

TEST_CASE("interval: the bounds over a box contain the value everywhere in it") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> of(-1, 1);
    int tight = 0, boxes = 0;
    for (const char* text : kFormulas) {
        const expr::Formula f = formula(text);
        for (int box = 0; box < 400; ++box) {
            const double size = std::exp2(-3.0 * (box % 5));
            std::array<Interval, 4> sides{};
            for (Interval& side : sides) {
                const double middle = 3 * of(random);
                side = {middle - size, middle + size};
            }
            const Interval bounds = expr::range(f, sides);
            REQUIRE(bounds.low <= bounds.high);
            double low = 1e300, high = -1e300;
            for (int place = 0; place < 40; ++place) {
                std::array<double, 4> at{};
                for (std::size_t i = 0; i < 4; ++i) {
                    const double part = place == 0 ? -1 : place == 1 ? 1 : of(random);
                    at[i] = std::clamp(0.5 * (sides[i].low + sides[i].high) + part * size, sides[i].low, sides[i].high);
                }
                const double value = f.value(at);
                low = std::min(low, value), high = std::max(high, value);
                INFO(text);
                REQUIRE(value >= bounds.low);
                REQUIRE(value <= bounds.high);
            }
            if (size < 1e-3) ++boxes, tight += bounds.high - bounds.low <= 20 * (high - low) + 1e-9;
        }
    }
    fmt::print("interval: {} of {} small boxes have bounds within 20 times what is there\n", tight, boxes);
    CHECK(tight > 0.8 * boxes);  // the others: at a pole, at atan's cut, noise
}

// As shaders/object/clearance.glsl.
double clearance(const SurfaceClearances& grids, const SolidFormula& solid, const Vec3& at) {
    const double cell = 2 * solid.bound / kClearanceCells;
    int n = grids.first_cell(solid), stride = 1;
    double rim = 1;
    for (const double x : {at.x, at.y, at.z}) {
        const double in_cells = (x + solid.bound) / cell, of_cell = std::floor(in_cells);
        n += stride * static_cast<int>(of_cell), stride *= kClearanceCells;
        rim = std::min({rim, in_cells - of_cell, 1 - (in_cells - of_cell)});
    }
    const double cells = static_cast<double>(grids.cells()[static_cast<std::size_t>(n)]);
    return cells < 1 ? 0 : (cells - 1 + rim) * cell;
}

TEST_CASE("surface clearance: nothing of the solid is nearer, at any time, and most of the cube is empty") {
    std::vector<SolidFormula> solids = {
        {"(length(x, y) - 6)^2 + z^2 - (1 + 0.3 * sin(8 * atan(y, x) - 0.7 * t))^2", 8},
        {"length(x - 3 * cos(0.2 * t), y - 3 * sin(0.2 * t), z) - 1", 5},
        {"length(x - t, y, z) - 1", 5},  // it may be anywhere along x
    };
    for (const NamedSurface& named : kNamedSurfaces) {
        SurfaceSpec surface;
        surface.kind = named.kind, surface.size = 4, surface.bound = 6;
        solids.push_back({surface_shape(surface), surface.bound});
    }
    SurfaceClearances grids;
    CHECK(grids.update({solids.begin(), solids.end()}));
    CHECK_FALSE(grids.update({solids.begin(), solids.end()}));
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> of(-1, 1);
    for (const SolidFormula& solid : solids) {
        const expr::Formula f = formula(solid.formula);
        const double cell = 2 * solid.bound / kClearanceCells;
        int empty = 0, inside = 0;
        constexpr int kPlaces = 20000;
        for (int i = 0; i < kPlaces; ++i) {
            const Vec3 at = solid.bound * Vec3{of(random), of(random), of(random)};
            const double clear = clearance(grids, solid, at);
            empty += clear > cell;
            Vec3 way{of(random), of(random), of(random)};
            way = at + (i % 3 == 0 ? 0.0 : clear / std::max(length(way), 1e-9) * 0.999999) * way;
            const double values[] = {way.x, way.y, way.z, 100 * of(random)};
            const bool solid_there = length(way) <= solid.bound && f.value(values) < 0;
            inside += solid_there;
            REQUIRE_FALSE((solid_there && clear > 0));
        }
        fmt::print("surface clearance: {:.2f} of the cube is empty, {:.3f} inside: {}\n", double(empty) / kPlaces,
                   double(inside) / kPlaces, solid.formula.substr(0, 50));
        CHECK(inside > 0);
        CHECK(empty > (solid.formula.starts_with("abs(sin") ? 0.0 : 0.3) * kPlaces);  // the gyroid is everywhere
    }
}

TEST_CASE("surface clearance: grids come and go with their solids, and no more than there is memory for") {
    SurfaceClearances grids;
    CHECK(grids.rows() == 0);
    CHECK(grids.first_cell({"x", 1}) == -1);
    std::set<SolidFormula> many;
    for (int i = 0; i < kMostClearances + 3; ++i) many.insert({"length(x, y, z) - 1", 2.0 + i});
    CHECK(grids.update(many));
    CHECK(grids.rows() * kClearanceWidth == kMostClearances * kClearanceCells * kClearanceCells * kClearanceCells);
    CHECK(grids.first_cell(*many.begin()) >= 0);
    CHECK(grids.first_cell(*many.rbegin()) == -1);
    CHECK(grids.update({}));
    CHECK(grids.rows() == 0);
}

}  // namespace
