// The reference against 50-digit arithmetic, on the rays where double arithmetic has the least to spare: next to the critical
// ray, on the photon sphere and one unit in the last place beside it, next to the horizon, far away, radial and transverse.
// The doubles that the reference is given are taken as exact numbers.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "proof/settings.h"
#include "proof/taylor_orbit.h"
#include "reference/reference.h"
#include "support/costly.h"

namespace {

using namespace nullscope;
using namespace nullscope::proof;
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Orbit50 = TaylorOrbit<Real>;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// An answer may be off by this many roundings of the answer and of each input, an input's counted as often as the answer
// multiplies it (the condition number). A closed form is a chain of some ten operations of up to a few roundings each.
constexpr double kFiftyDigitsRoundings = 16;
// The reduced form is given q and zeta0 as exact doubles: angle, delay and turning point owe nothing to a condition number.
constexpr double kRoundingsOfReduced = 100;
constexpr double kCritical = 0.3849001794597505;

struct Case {
    std::string name;
    RayQuery query;
};
Case reduced(std::string name, double q, double zeta0, int s) {
    Case c{fmt::format("{}: q = {:.17g}, zeta0 = {:.17g}, s = {}", name, q, zeta0, s), {}};
    c.query.orbit = ReducedRay{q, zeta0, s};
    return c;
}
Case local(std::string name, double r, double n_r, double n_t, LocalFrame frame = LocalFrame::kStatic) {
    Case c{fmt::format("{}: r = {:.17g}, n = ({:.17g}, {:.17g})", name, r, n_r, n_t), {}};
    c.query.frame = frame;
    c.query.r = r;
    c.query.n = {n_r, 0, n_t};
    return c;
}

// The orbit of a case with its inputs changed by these relative amounts: q and zeta0, or r - 1 and the view direction's tangent.
Orbit50 exact_orbit(const Case& c, const Real& first, const Real& second, bool with_delay) {
    if (c.query.orbit) {
        const Real q = Real(c.query.orbit->q) * (1 + first), zeta0 = Real(c.query.orbit->zeta0) * (1 + second);
        return {zeta0, c.query.orbit->s * sqrt(q * q - zeta0 * zeta0 * (1 - zeta0)), q, with_delay};
    }
    const Real r = 1 + (Real(c.query.r) - 1) * (1 + first);
    const Real across = Real(c.query.n.z) * (1 + second), outward = c.query.n.x;
    const Real norm = sqrt(outward * outward + across * across);
    if (c.query.frame == LocalFrame::kRain) {  // E = 1 + w n_r, L = r n_t, dr along the ray as w + n_r
        const Real w = sqrt(1 / r);
        return {1 / r, -(w * norm + outward) / (r * across), (norm + w * outward) / (r * across), with_delay};
    }
    const Real lapse = sqrt((r - 1) / r);
    const Real q = lapse * norm / (r * across);
    return {1 / r, -q * outward / norm, q, with_delay};
}

// Changes the inputs by 1e-25: the derivative is good to as many digits.
struct Bundle {
    // orbit(first, second): with its inputs changed by these relative amounts.
    template <class Exact>
    explicit Bundle(const Exact& orbit) : here(orbit(0, 0)), first(orbit(kStep, 0)), second(orbit(0, kStep)) {}
    double condition(const std::function<Real(const Orbit50&)>& output, const Real& other = 0) const {
        const Real y = output(here), changed = abs(output(first) - y) + abs(output(second) - y);
        return std::max(1.0, static_cast<double>((changed / kStep + abs(other)) / abs(y)));
    }
    inline static const Real kStep{"1e-25"};
    Orbit50 here, first, second;
};

// Largest error over bound of each kind of ray, printed at the end.
using FiftyDigitsWorst = std::map<std::string, double>;

void judge(const Case& c, const std::string& what, double found, const Real& exact, double condition,
           FiftyDigitsWorst& worst) {
    const double error = static_cast<double>(abs(found - exact) / abs(exact)) / kEpsilon;
    CAPTURE(c.name);
    CAPTURE(what);
    CAPTURE(found);
    CAPTURE(condition);
    CHECK(error <= kFiftyDigitsRoundings * condition);
    if (c.query.orbit && what != "zeta") CHECK(error <= kRoundingsOfReduced);
    double& most = worst[c.name.substr(0, c.name.find(':'))];
    most = std::max(most, error / (kFiftyDigitsRoundings * condition));
    if (std::getenv("NULLSCOPE_PRINT_ERRORS"))
        fmt::print("{} {}: {:.3g} roundings, condition {:.3g}\n", c.name, what, error, condition);
}

void check(const Case& c, FiftyDigitsWorst& worst) {
    const auto record = reference::trace_ray({}, c.query);
    REQUIRE_MESSAGE(record, c.name);
    const bool escapes = record->fate == Fate::kEscaped;
    const Bundle bundle([&](const Real& first, const Real& second) { return exact_orbit(c, first, second, escapes); });
    CAPTURE(c.name);
    REQUIRE(bundle.here.ended());
    CHECK((record->fate == Fate::kCaptured) == bundle.here.captured());
    if (escapes == bundle.here.captured()) return;
    const auto angle = [](const Orbit50& o) { return o.angle(); };
    judge(c, "angle", record->angle, bundle.here.angle(), bundle.condition(angle), worst);
    if (escapes) {
        const auto delay = [](const Orbit50& o) { return o.delay(); };
        judge(c, "delay", record->delay, bundle.here.delay(), bundle.condition(delay), worst);
    }
    if (bundle.here.turn() && !std::isnan(record->turn)) {
        const auto turn = [](const Orbit50& o) { return o.turn() ? *o.turn() : Real(0); };
        judge(c, "turn", record->turn, *bundle.here.turn(), bundle.condition(turn), worst);
    }
    for (const double part : {0.1, 0.5, 0.9}) {
        RayQuery query = c.query;
        query.at_angle = part * record->angle;
        const Real phi = *query.at_angle;
        const auto zeta = [&](const Orbit50& o) { return o.zeta_at(phi); };
        judge(c, "zeta", reference::trace_ray({}, query)->at, bundle.here.zeta_at(phi),
              bundle.condition(zeta, phi * bundle.here.slope_at(phi)), worst);
    }
}

void check_all(const std::vector<Case>& cases) {
    FiftyDigitsWorst worst;
    for (const Case& c : cases) check(c, worst);
    for (const auto& [kind, ratio] : worst) fmt::print("{}: largest error {:.2f} of its bound\n", kind, ratio);
}

TEST_CASE("fifty digits: rays next to the critical one" * test::costly()) {
    std::vector<Case> cases;
    const int step = times_longer() > 1 ? 1 : 2;
    for (const double zeta0 : {1e-9, 0.1, 0.6, 0.9})
        for (int k = 1; k <= 14; k += step)
            for (const int side : {-1, 1})
                for (const int s : {-1, 1}) {
                    const double q = kCritical * (1 + side * std::pow(10.0, -k));
                    if (q * q <= zeta0 * zeta0 * (1 - zeta0)) continue;  // no such ray
                    cases.push_back(reduced(side < 0 ? "below critical" : "above critical", q, zeta0, s));
                }
    check_all(cases);
}

TEST_CASE("fifty digits: camera on the photon sphere and one unit in the last place beside it") {
    std::vector<Case> cases;
    for (const double r : {1.5, std::nextafter(1.5, 0.0), std::nextafter(1.5, 2.0)}) {
        for (int k = 1; k <= 15; k += times_longer() > 1 ? 1 : 2)
            for (const int side : {-1, 1}) cases.push_back(local("photon sphere", r, side * std::pow(10.0, -k), 1));
        if (r != 1.5) cases.push_back(local("photon sphere, transverse", r, 0, 1));
    }
    check_all(cases);
    // The circular orbit itself ends nowhere.
    const auto circular = reference::trace_ray({}, local("", 1.5, 0, 1).query);
    REQUIRE(circular);
    CHECK(circular->fate == Fate::kNoSky);
}

TEST_CASE("fifty digits: next to the horizon") {
    std::vector<Case> cases;
    for (int k = 1; k <= 15; k += times_longer() > 1 ? 1 : 2) {
        const double depth = std::pow(10.0, -k);
        for (const double q : {0.2, 0.38, 0.39, 5.0})
            for (const int s : {-1, 1})
                if (q * q > depth) cases.push_back(reduced("horizon", q, 1 - depth, s));
        for (const double alpha : {1e-6, 0.5, 1.5, 3.0})  // 1e-6: escapes for the larger depths
            cases.push_back(local("horizon, static frame", 1 + depth, std::cos(alpha), std::sin(alpha)));
    }
    check_all(cases);
}

TEST_CASE("fifty digits: raindrop frame, outside, at and inside the horizon") {
    std::vector<Case> cases;
    for (const double r : {0.05, 0.5, 1 - 1e-3, 1 - 1e-9, 1 - 1e-15, 1 + 1e-15, 1 + 1e-9, 1.001, 1.2, 1.5, 4.0, 1e6})
        for (const double alpha : {1e-3, 0.1, 1.0, 1.5, 1.7, 2.4}) {
            if (r <= 1 && std::cos(alpha) < -0.9 * std::sqrt(r)) continue;  // falls, or light of no positive energy
            cases.push_back(local(r <= 1 ? "raindrop inside" : "raindrop outside", r, std::cos(alpha), std::sin(alpha),
                                  LocalFrame::kRain));
        }
    check_all(cases);
}

TEST_CASE("fifty digits: from far away" * test::costly()) {
    std::vector<Case> cases;
    for (const double zeta0 : {1e-9, 1e-6, 1e-3})
        for (const double q : {1e-3, 0.2, 0.38, 0.39, 1.0, 1e3, 1e9})
            for (const int s : {-1, 1})
                if (q > zeta0) cases.push_back(reduced("far", q, zeta0, s));
    for (const double r : {1e3, 1e6, 1e9})
        for (const double b : {1e-3, 1.0, 2.5, 2.6, 2.7, 10.0, 0.3 * r})
            cases.push_back(local("far, static frame", r, -std::sqrt(1 - (b / r) * (b / r)), b / r));
    check_all(cases);
}

TEST_CASE("fifty digits: transverse and nearly radial") {
    std::vector<Case> cases;
    for (const double r : {1.0001, 1.2, 1.49, 1.51, 3.0, 100.0, 1e9}) {
        cases.push_back(local("transverse", r, 0, 1));
        for (const double across : {1e-3, 1e-8, 1e-50})
            for (const int side : {-1, 1}) cases.push_back(local("nearly radial", r, side, across));
    }
    check_all(cases);
}

// In metrics without a closed form; angles, with Q/M and the view direction as exact numbers.
TEST_CASE("fifty digits: charges, camera next to the photon sphere" * test::costly()) {
    for (const double charge : {0.5, 0.99, 1.001, 1.06, std::sqrt(1.125), 1.1}) {
        Scene scene;
        scene.spacetime = {"reissner-nordstrom", {{"charge", charge}}};
        const double sphere = 0.25 * (3 + std::sqrt(std::max(9 - 8 * charge * charge, 0.0)));
        FiftyDigitsWorst worst;
        for (const double off : {0.1, 1e-2, 1e-4})
            for (const double tilt : {0.0, 1e-5, 1e-3, 2.35e-3, 0.02, 0.5})
                for (const int side : {-1, 1}) {
                    const Case c = local(fmt::format("Q/M = {:.4g}", charge), sphere * (1 + off), side * tilt, 1);
                    const auto orbit = [&](const Real& of_r, const Real& of_tilt) {
                        const Real kappa = Real(charge) * charge / 4, zeta = 1 / (Real(c.query.r) * (1 + of_r)),
                                   n_r = Real(c.query.n.x) * (1 + of_tilt), norm = sqrt(1 + n_r * n_r),
                                   q = zeta * norm * sqrt(1 - zeta + kappa * zeta * zeta);
                        return Orbit50(zeta, -q * n_r / norm, q, false, kappa);
                    };
                    const Bundle bundle(orbit);
                    const auto record = reference::trace_ray(scene, c.query);
                    REQUIRE(record);
                    const auto angle = [](const Orbit50& o) { return o.angle(); };
                    if (bundle.here.ended())
                        judge(c, "angle", record->angle, bundle.here.angle(), bundle.condition(angle), worst);
                }
        for (const auto& [kind, ratio] : worst) fmt::print("{}: largest error {:.2f} of its bound\n", kind, ratio);
    }
}

TEST_CASE("fifty digits: exactly radial") {
    for (const double r : {1 + 1e-15, 1.2, 1.5, 3.0, 1e9}) {
        const auto out = reference::trace_ray({}, local("", r, 1, 0).query);
        const auto in = reference::trace_ray({}, local("", r, -1, 0).query);
        REQUIRE(out);
        REQUIRE(in);
        CHECK(out->fate == Fate::kEscaped);
        CHECK(in->fate == Fate::kCaptured);
        CHECK(out->angle == 0);
        CHECK(in->angle == 0);
        CHECK(out->delay == 0);
        CHECK(length(out->sky - Vec3{1, 0, 0}) < kEpsilon);
        const Real g = sqrt(Real(r) / (Real(r) - 1));
        CHECK(abs(out->g / g - 1) <= 4 * kEpsilon);
    }
}

}  // namespace
