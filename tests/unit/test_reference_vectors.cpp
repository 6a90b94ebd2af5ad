// The reference against 50-digit vectors: every row of the files of tests/vectors but Kerr's, cameras inside the horizon included.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>

#include "reference/reference.h"
#include "support/folders.h"
#include "vector_file.h"

namespace {

using namespace nullscope;

using RecordValue = double (*)(const RayRecord&);
double angle_of(const RayRecord& r) { return r.angle; }
double delay_of(const RayRecord& r) { return r.delay; }
double turn_of(const RayRecord& r) { return r.turn; }
double place_of(const RayRecord& r) { return r.at; }

// Largest relative error. In units of the condition number double arithmetic leaves about 1e-15 after a chain of ten elliptic
// operations; 1e-11 is what the project promises for the reference.
struct VectorBounds {
    double most = 1e-11;                                       // times the condition number
    double exactly = std::numeric_limits<double>::infinity();  // of what is not asked for at a swept angle, by itself
};
// What is reached about Schwarzschild's hole (1.6e-15 over these rows and 3000 others; by itself 5e-15), with a margin of 6 for other
// compilers and mathematical libraries. The inputs are exact doubles: unless a given swept angle is subtracted from the whole, nothing
// may be lost.
constexpr VectorBounds kReached{1e-14, 3e-14};

// A row of a file and the ray that it is of.
struct VectorRay {
    const VectorRow& row;
    Scene scene;
    double q, place;  // zeta0, or l0 about a throat
    int sense;        // +1: towards growing zeta
    RayRecord record{};

    Result<RayRecord> along(double q_, double place_, int sense_, std::optional<double> at = {}) const {
        RayQuery query;
        query.orbit = ReducedRay{q_, place_, sense_};
        query.at_angle = at;
        return reference::trace_ray(scene, query);
    }
    RayRecord at(double angle) const { return *along(q, place, sense, angle); }

    // Of an output y of the inputs x = (q, zeta0, and the swept angle `at` where one is asked for):
    //     kappa = max(1, sum_i |x_i dy/dx_i| / |y|),
    // the factor by which a relative change of the inputs comes back as a relative change of y. The derivatives are one-sided
    // differences of the traced function, the larger side counts; the step stays below `room`, how far, relatively, the critical ray
    // and the turning point are, where y is singular.
    double condition_number(double room, RecordValue output, std::optional<double> at) const {
        const auto here = along(q, place, sense, at);
        const double y = output(*here), step = std::max(1e-5 * std::min(1.0, room), 1e-15);
        double sum = 0;
        for (int input = 0; input < (at ? 3 : 2); ++input) {
            double worst = 0;
            for (const double h : {step, -step}) {
                const auto there = along(q * (input == 0 ? 1 + h : 1), place * (input == 1 ? 1 + h : 1), sense,
                                         at ? std::optional(*at * (input == 2 ? 1 + h : 1)) : at);
                if (!there || there->fate != here->fate) continue;
                const double change = std::abs(output(*there) - y) / (step * std::abs(y));
                if (std::isfinite(change)) worst = std::max(worst, change);
            }
            sum += worst;
        }
        return std::max(1.0, sum);
    }
};

// A file of vectors; of_throat: by h = 1/q and l0, else by q and zeta0.
class VectorFile {
public:
    VectorFile(const char* name, bool of_throat, std::function<SpacetimeSpec(const VectorRow&)> spacetime,
               VectorBounds bounds = {})
        : name_(name), of_throat_(of_throat), spacetime_(std::move(spacetime)), bounds_(bounds) {}

    // Checks the fate of every row and what `judge` does; how many rows there are.
    int each(const std::function<Fate(const VectorRay&)>& fate, const std::function<void(const VectorRay&)>& judge) {
        int rows = 0;
        for (const VectorRow& row : load_vectors(test::data_folder() / "vectors" / name_)) {
            VectorRay ray{row,
                          {},
                          of_throat_ ? 1 / number(row, "h") : number(row, "q"),
                          number(row, of_throat_ ? "l0" : "zeta0"),
                          static_cast<int>(number(row, "s"))};
            ray.scene.spacetime = spacetime_(row);
            if (of_throat_) ray.sense = -ray.sense;
            CAPTURE(rows);
            CAPTURE(ray.q);
            const auto record = ray.along(ray.q, ray.place, ray.sense);
            REQUIRE(record);
            ray.record = *record;
            CHECK(record->fate == fate(ray));
            judge(ray);
            ++rows;
        }
        fmt::print("{}: {} rows, largest error over condition number {:.2g}\n", name_, rows, worst_);
        return rows;
    }

    // A column of a row against what is traced, at the angle in another column where one is named; room: condition_number().
    void check(const VectorRay& ray, double room, const char* column, RecordValue output, const char* angle = nullptr) {
        const auto at = angle != nullptr ? std::optional(number(ray.row, angle)) : std::nullopt;
        const double expected = number(ray.row, column), found = output(*ray.along(ray.q, ray.place, ray.sense, at));
        CAPTURE(std::string(column));
        CAPTURE(expected);
        CAPTURE(found);
        if (std::isnan(expected)) {
            CHECK(std::isnan(found));
            return;
        }
        const double kappa = ray.condition_number(room, output, at),
                     off = std::abs(found - expected) / std::abs(expected);
        CAPTURE(kappa);
        worst_ = std::max(worst_, off / kappa);
        CHECK(off / kappa <= bounds_.most);
        if (!at) CHECK(off <= bounds_.exactly);
        if (std::getenv("NULLSCOPE_PRINT_ERRORS"))
            fmt::print("{} {} {:.3g} {:.3g}\n", name_, column, off / kappa, kappa);
    }
    void check_whole(const VectorRay& ray, double room) {
        check(ray, room, "phi", angle_of);
        check(ray, room, "T", delay_of);
        check(ray, room, of_throat_ ? "l_turn" : "zeta_turn", turn_of);
    }

private:
    const char* name_;
    bool of_throat_;
    std::function<SpacetimeSpec(const VectorRow&)> spacetime_;
    VectorBounds bounds_;
    double worst_ = 0;
};

Fate by_status(const VectorRay& ray) {
    const int status = static_cast<int>(number(ray.row, "status"));
    return status == 0 ? Fate::kEscaped : status == 1 ? Fate::kCaptured : Fate::kNoSky;
}
Fate by_end(const VectorRay& ray) { return number(ray.row, "end") > 0 ? Fate::kEscaped : Fate::kOtherSide; }

VectorFile schwarzschild_file() {
    return {"schwarzschild.csv", false, [](const VectorRow&) { return SpacetimeSpec{}; }, kReached};
}

TEST_CASE("the reference meets every row of the Schwarzschild vectors") {
    constexpr double kCritical = 0.3849001794597505;
    VectorFile file = schwarzschild_file();
    CHECK(file.each(by_status, [&](const VectorRay& ray) {
        const double q = ray.q, zeta0 = ray.place;
        const double room = std::min(std::abs(q / kCritical - 1), std::abs(1 - zeta0 * zeta0 * (1 - zeta0) / (q * q)));
        file.check_whole(ray, room);
        file.check(ray, room, "zeta_a", place_of, "phi_a");
        file.check(ray, room, "zeta_b", place_of, "phi_b");
    }) > 100);
}

TEST_CASE("the reference's frequency ratio is that of the vectors") {
    // One square root and one division of exact inputs: a few roundings, amplified by 1/(1 - zeta0) of the lapse.
    constexpr double kRoundings = 8 * 2.3e-16;
    schwarzschild_file().each(by_status, [&](const VectorRay& ray) {
        const double expected = number(ray.row, "g_static"), off = std::abs(ray.record.g / expected - 1);
        CHECK(std::isnan(expected) == std::isnan(ray.record.g));
        if (!std::isnan(expected)) CHECK(off <= kRoundings / std::min(1.0, 1 - ray.place));
    });
}

TEST_CASE("the reference meets every row of the extremal Reissner-Nordstrom vectors") {
    VectorFile file("rn_extremal.csv", false, [](const VectorRow&) {
        return SpacetimeSpec{"reissner-nordstrom", {{"charge", 1.0}}};
    });
    int inside = 0;
    CHECK(file.each(by_status, [&](const VectorRay& ray) {
        const double q = ray.q, v = ray.place * (1 - 0.5 * ray.place);
        inside += ray.place >= 2;
        const double room = std::min(std::abs(q / 0.5 - 1), std::abs((q - v) * (q + v) / (q * q)));
        file.check_whole(ray, room);
        file.check(ray, room, "zeta_a", place_of, "phi_a");
        file.check(ray, room, "zeta_b", place_of, "phi_b");
        const double g = number(ray.row, "g_static");
        if (!std::isnan(g))  // g = 1/(1 - zeta0/2): a few roundings, as often as that multiplies them
            CHECK(std::abs(ray.record.g / g - 1) * std::min(1.0, std::abs(1 - 0.5 * ray.place)) < 2e-15);
    }) == 126);
    fmt::print("{} of them with the camera on or inside the horizon\n", inside);
}

TEST_CASE("the reference meets every row of the Ellis vectors") {
    VectorFile file("ellis.csv", true, [](const VectorRow&) { return SpacetimeSpec{"ellis", {}}; });
    CHECK(file.each(by_end, [&](const VectorRay& ray) {
        const double h = number(ray.row, "h");
        const double room = std::min(std::abs(h - 1), std::abs(1 - h * h / (ray.place * ray.place + 1)));
        file.check_whole(ray, room);
        file.check(ray, room, "l_a", place_of, "phi_a");
    }) == 135);
}

TEST_CASE("the reference meets every row of the vectors of charges without horizon") {
    VectorFile file("rn_naked.csv", false, [](const VectorRow& row) {
        return SpacetimeSpec{"reissner-nordstrom", {{"charge", number(row, "charge")}}};
    });
    const auto escapes = [](const VectorRay&) { return Fate::kEscaped; };
    CHECK(file.each(escapes, [&](const VectorRay& ray) {
        file.check_whole(ray, 1e-2);
        // The place at a swept angle, by its own definition: what a camera there still has to sweep.
        for (const double part : {0.1, 0.4, 0.6, 0.9, 0.999}) {
            const double whole = ray.record.angle, zeta = ray.at(part * whole).at;
            int toward = 0;
            for (const int way : {1, -1}) {  // in front of the turn or behind it: the one that sweeps the rest
                const auto rest = ray.along(ray.q, zeta, way);
                if (rest && std::abs(rest->angle / ((1 - part) * whole) - 1) < 1e-9) toward = way;
            }
            CAPTURE(part);
            CHECK(toward != 0);
        }
    }) > 50);
}

// q = 1/h and the impact parameter h itself differ by a rounding: their rows differ by that times the condition number.
TEST_CASE("the reference meets every row of the vectors of James, von Tunzelmann, Franklin and Thorne's wormhole") {
    VectorFile file("dneg.csv", true, [](const VectorRow& row) {
        return SpacetimeSpec{"dneg-wormhole",
                             {{"length", number(row, "length")}, {"lensing_width", number(row, "width")}}};
    });
    CHECK(file.each(by_end, [&](const VectorRay& ray) {
        const double narrow = std::abs(number(ray.row, "h") - 1), whole = ray.record.angle;
        file.check_whole(ray, narrow);
        // The place at a swept angle, by its own definition: what a camera there still has to sweep.
        for (const double part : {0.1, 0.5, 0.9, 0.999}) {
            const double at = part * whole, l = ray.at(at).at;
            CAPTURE(part);
            CAPTURE(l);
            const double forward =
                std::isfinite(ray.record.turn) ? (l < 0 ? -1 : 1) * (at < whole / 2 ? 0 : 1) : -ray.sense;
            if (forward == 0) continue;  // before or after the turn: not told by l alone
            const auto rest = ray.along(ray.q, l, static_cast<int>(l >= 0 ? -forward : forward));
            REQUIRE(rest);
            CHECK(std::abs(rest->angle / ((1 - part) * whole) - 1) < 1e-10 + 1e-13 * whole / narrow);
        }
    }) == 71);
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
