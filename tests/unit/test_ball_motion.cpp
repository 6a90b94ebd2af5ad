// Balls in free fall: the host's way against the reference's.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "observer/ball_motion.h"
#include "reference/bodies.h"
#include "spacetime/registry.h"

namespace {

using namespace nullscope;

TEST_CASE("ball motion: free fall, past the hole, into it and out of its past, is the reference's") {
    constexpr double kPlace = 5e-6;  // r_s: the host stops 1e-6 of it short of a horizon or a star
    struct Case {
        const char* metric;
        std::map<std::string, double> parameters;
        Vec3 position, velocity;
    };
    const std::vector<Case> cases = {{"schwarzschild", {}, {6, 0, 1}, {0.1, 0.05, 0.25}},
                                     {"schwarzschild", {}, {6, 0, 1}, {-0.3, 0.02, 0.1}},
                                     {"schwarzschild", {}, {0, -9, 2}, {-0.4, 0.1, 0.5}},
                                     {"schwarzschild", {}, {0, 0, 4}, {0, 0, 0}},
                                     {"reissner-nordstrom", {{"charge", 0.8}}, {6, 0, 1}, {-0.1, 0.05, 0.2}},
                                     {"neutron-star", {{"radius", 2.5}}, {6, 0, 1}, {-0.3, 0, 0.1}},
                                     {"minkowski", {}, {3, 1, 1}, {-0.8, 0, 0}}};
    for (const Case& c : cases) {
        BallSpec ball;
        ball.motion = BallMotion::kGeodesic, ball.position = c.position, ball.velocity = c.velocity;
        const auto spacetime = *make_spacetime(c.metric, c.parameters);
        const auto metric = std::move(*reference::make_metric({c.metric, c.parameters}));
        const auto exact = reference::ball_way(*metric, ball);
        const auto motion = ball_motion(*spacetime, ball);
        REQUIRE(motion);
        double worst = 0, when = 0;
        for (const double sense : {1.0, -1.0})
            for (double t = 0; t < 90; t += 0.37) {
                const double off = length((*motion)(sense * t).place - exact(sense * t));
                if (!(off <= worst)) worst = off, when = sense * t;
            }
        fmt::print("free fall in {}: off by at most {:.1e} r_s, at t = {:.1f}\n", c.metric, worst, when);
        CHECK(worst < kPlace);
    }
}

// From rest at r0: r = r0 (1 + cos eta)/2 and, with s = sqrt(r0 - 1), t = s (eta + r0 (eta + sin eta)/2) + ln((s + tan(eta/2))/(s - tan(eta/2)))
// (Misner, Thorne and Wheeler 25.37, 2 M = 1).
TEST_CASE("ball motion: a fall from rest is the closed form's, in whatever order it is asked") {
    constexpr double kFallError = 1e-12;  // r_s
    BallSpec ball;
    ball.motion = BallMotion::kGeodesic, ball.position = {0, 0, 4}, ball.velocity = {0, 0, 0};
    const auto metric = std::move(*reference::make_metric({"schwarzschild", {}}));
    const auto fall = reference::ball_way(*metric, ball), backward = reference::ball_way(*metric, ball);
    const double r0 = 4, s = std::sqrt(r0 - 1), last = 2 * std::acos(std::sqrt(1.0001 / r0));
    double worst = 0;
    for (double eta = last; eta > 0; eta -= 0.0037) {
        const double r = 0.5 * r0 * (1 + std::cos(eta)), sloping = std::tan(0.5 * eta),
                     t = s * (eta + 0.5 * r0 * (eta + std::sin(eta))) + std::log((s + sloping) / (s - sloping));
        for (const double sense : {1.0, -1.0}) worst = std::max(worst, std::abs(length(fall(sense * t)) - r));
    }
    fmt::print("a fall from rest: off by {:.1e} r_s at most\n", worst);
    CHECK(worst < kFallError);
    for (double t = 0; t < 15; t += 0.0137) CHECK(length(fall(t) - backward(t)) == 0);
}

}  // namespace
