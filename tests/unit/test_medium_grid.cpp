// Grids of matter: what is read and what is refused, and matter between nodes for the reference.
#include <doctest/doctest.h>

#include <cmath>

#include "base/atomic_file.h"
#include "plan/medium.h"
#include "reference/medium_grid.h"
#include "scene/medium_grid.h"
#include "spacetime/registry.h"
#include "support/medium_files.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

const GridNode kNode = {2, 3, 4, 5, 6, 0.1, 0.2, 0.3};

GridNode even(double, double, double) { return kNode; }

std::string changed(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("medium grid: files that are none are refused with their line or node") {
    struct Bad {
        std::string bytes;
        int line;
        const char *what, *allowed;
    };
    const std::string good = grid_bytes({}, even);
    GridNode odd = kNode;
    const auto with = [&](std::size_t n, double value) {
        odd = kNode, odd[n] = value;
        return grid_bytes({}, [&](double r, double, double) { return r > 9 ? odd : kNode; });
    };
    const Bad kBad[] = {
        {"", 1, "\"nullscope-medium\" is missing", "nullscope-medium 1"},
        {std::string(1000, 'x'), 1, "\"nullscope-medium\" is missing", "nullscope-medium 1"},
        {changed(good, "medium 1", "medium 2"), 1, "another version", "nullscope-medium 1"},
        {changed(good, "kerr-schild", "cartesian"), 2, "other coordinates", "boyer-lindquist"},
        {changed(good, "spin 0", "spin 1.5"), 3, "spin = 1.5 is out of range", "[-1, 1]"},
        {changed(good, "spin 0", "charge 0"), 3, "\"spin\" is expected", "spin A"},
        {changed(good, "r 1.1", "r 0"), 4, "first r = 0", "[0.001"},
        {changed(good, "1.1 10 5", "1.1 1 5"), 4, "last r = 1", "[1.1011, 1000000]"},
        {changed(good, "1.1 10 5", "1.1 10 4096"), 4, "nodes of r = 4096", "[2, 1024]"},
        {changed(good, "1.1 10 5", "1.1 10 4.5"), 4, "nodes of r = 4.5 is not whole", "[2, 1024]"},
        {changed(good, "1.1 10 5", "1.1 10"), 4, "\"r\" is expected", "r FIRST LAST COUNT"},
        {changed(good, "theta 0.05", "theta nan"), 5, "first theta = nan", "[0, 3.1]"},
        {changed(good, "phi 0 3", "phi 0 257"), 6, "nodes of phi = 257", "[1, 256]"},
        {changed(good, "data", "date"), 7, "\"data\" is expected", "data"},
        {changed(good, "data", "source " + std::string(2000, 'x') + "\ndata"), 7, "\"source\" is too long", "1100"},
        {changed(good, "data", "source a\nconverter b\ndata"), 8, "\"data\" is expected", "data"},
        {changed(changed(changed(good, "10 5\n", "10 1024\n"), " 4\nphi", " 2048\nphi"), "phi 0 3", "phi 0 256"), 7,
         "536870912 nodes", "at most 16777216"},
        {good.substr(0, good.size() - 1), 7, "1919 bytes follow", "1920 of 60 nodes"},
        {good + "x", 7, "1921 bytes follow", "1920 of 60 nodes"},
        {with(0, -1), 7, "density of node (4, 0, 0) is -1", "[0, 1e+30]"},
        {with(1, NAN), 7, "temperature of node (4, 0, 0) is nan", "[0, 100000000000000]"},
        {with(3, INFINITY), 7, "field of node (4, 0, 0) is inf", "[-1000000000, 1000000000]"},
        {with(7, 1e4), 7, "velocity of node (4, 0, 0) is 10000", "[-1000, 1000]"},
    };
    for (const Bad& bad : kBad) {
        const auto grid = MediumGrid::parse(bad.bytes, "flow.grid");
        CAPTURE(bad.what);
        REQUIRE_FALSE(grid);
        const std::string message = grid.error().message();
        CAPTURE(message);
        CHECK(grid.error().kind == ErrorKind::kBadInput);
        CHECK(grid.error().line == bad.line);
        CHECK(message.starts_with("flow.grid"));
        CHECK(message.find(bad.what) != std::string::npos);
        CHECK(message.find(bad.allowed) != std::string::npos);
    }
    const auto grid = MediumGrid::parse(good, "flow.grid");
    REQUIRE(grid);
    CHECK(grid->farthest() == doctest::Approx(10));
    CHECK(grid->node(4, 3, 2)[4] == doctest::Approx(std::log2(3)));
    CHECK(grid->node(0, 0, 0)[1] == doctest::Approx(0.1 * grid->fall(1.1)));
}

TEST_CASE("medium grid: between nodes matter is linear, all round without a seam, and as at the ends beyond them") {
    GridForm form;
    form.rings = 9, form.polar = 5, form.around = 8, form.first = 0.3;
    const auto node = [](double r, double theta, double phi) {
        return GridNode{std::exp(2 + std::log(r) - theta),
                        1e9 * r,
                        std::cos(phi),
                        0,
                        0,
                        0.1 * std::log(r) / std::sqrt(1 - 1 / r),
                        0.2 * theta,
                        0};
    };
    const auto grid = MediumGrid::parse(grid_bytes(form, node), "flow.grid");
    REQUIRE(grid);
    for (const double phi : {0.3, 2.0, -1.0, 6.4, 0.3 - 1e-9}) {
        const auto at = reference::grid_matter(*grid, 4, 1, 2.5, 1.1, phi);
        CHECK(at.density == doctest::Approx(4 * std::exp(2 + std::log(2.5) - 1.1)));
        CHECK(at.temperature_K == doctest::Approx(2.5e9));
        CHECK(at.velocity.x == doctest::Approx(0.1 * std::log(2.5) / std::sqrt(0.6)));
        CHECK(at.velocity.y == doctest::Approx(0.22));
        const double turns = (phi - 0.3) / (M_PI / 4), low = std::floor(turns), part = turns - low,
                     left = std::cos(0.3 + low * M_PI / 4), right = std::cos(0.3 + (low + 1) * M_PI / 4),
                     field = left + part * (right - left);
        CHECK(at.field_G == doctest::Approx(2 * std::abs(field)));
        CHECK(at.field_way.x == doctest::Approx(field > 0 ? 1 : -1));
    }
    CHECK(reference::grid_matter(*grid, 1, 1, 20, 1.1, 0).temperature_K == doctest::Approx(1e10));
    CHECK(reference::grid_matter(*grid, 1, 1, 1.01, 0.01, 0).velocity.y == doctest::Approx(0.01));
}

TEST_CASE("medium grid: Kerr and Schild's azimuth is Boyer and Lindquist's and the integral of a/Delta") {
    GridForm form;
    form.spin = 0.9, form.around = 64, form.nearest = 0.8;
    const auto node = [](double, double, double phi) {
        return GridNode{1, 1, std::cos(phi), std::sin(phi), 0, 0, 0, 0};
    };
    const auto grid = MediumGrid::parse(grid_bytes(form, node), "flow.grid");
    REQUIRE(grid);
    const double a = 0.45, horizon = 0.5 + std::sqrt(0.25 - a * a);
    for (const double r : {0.8, 1.0, 3.0}) {
        double sum = 0;  // of -a/Delta from r outward, u = 1/r
        constexpr int kSteps = 200000;
        for (int i = 0; i < kSteps; ++i) {
            const double u = (i + 0.5) / (kSteps * r);
            sum -= a / (1 - u + a * a * u * u) / (kSteps * r);
        }
        const auto at = reference::grid_matter(*grid, 1, horizon, r, 1.5, 0.7);
        CHECK(std::remainder(std::atan2(at.field_way.y, at.field_way.x) - (0.7 + sum), 2 * M_PI) ==
              doctest::Approx(0).epsilon(2e-3));
    }
}

TEST_CASE("medium grid: a file of another hole, or one that ends before the matter, is refused") {
    const TemporaryFolder folder("medium-faults");
    int number = 0;
    std::string note;
    const auto fault_of = [&](const char* metric, double spin, double outer, const GridForm& form, double charge = 0) {
        Scene scene;
        scene.spacetime = {metric, {}};
        if (spin > 0) scene.spacetime.parameters["spin"] = spin;
        if (charge > 0) scene.spacetime.parameters["charge"] = charge;
        scene.object.mass_suns = 1e6;
        MediumSpec& medium = scene.medium.emplace();
        medium.kind = MediumKind::kGrid, medium.outer = outer;
        medium.grid.file = folder.path / std::to_string(++number);
        REQUIRE(write_text_atomically(medium.grid.file, grid_bytes(form, even)));
        const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        REQUIRE(spacetime);
        const auto faults = medium_faults(**spacetime, scene);
        note = medium_note(**spacetime, scene);
        return faults.empty() ? std::string() : faults.front().key + ": " + faults.front().what;
    };
    GridForm still, turning, inside;
    turning.spin = 0.9, turning.nearest = 0.8, inside.nearest = 0.5;
    CHECK(fault_of("schwarzschild", 0, 10, still) == "");
    CHECK(fault_of("kerr", 0.9, 10, turning) == "");
    CHECK(note.empty());
    CHECK(fault_of("minkowski", 0, 10, turning) == "");
    CHECK(note.find("about a hole of spin 0.9; the scene's space is flat") != std::string::npos);
    CHECK(fault_of("kerr-newman", 0.9, 10, turning, 0.3) == "");
    CHECK(note.find("of spin 0.9 without charge; the scene's hole has one") != std::string::npos);
    CHECK(fault_of("reissner-nordstrom", 0, 10, still, 0.5) == "");
    CHECK(note.find("of spin 0 without charge") != std::string::npos);
    CHECK(fault_of("minkowski", 0, 10, inside) == "");
    CHECK(fault_of("kerr", 0.9, 10, still).starts_with("medium.file: its matter is about a hole of spin 0,"));
    CHECK(fault_of("schwarzschild", 0, 10.1, still).starts_with("medium.outer: 10.1 is beyond the last node"));
    CHECK(fault_of("schwarzschild", 0, 10, inside).starts_with("medium.file: its first node, r = 0.5,"));
}
