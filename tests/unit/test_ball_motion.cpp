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

constexpr double kRate = 1e-5;   // c: there it rests at once
constexpr double kPlace = 5e-6;  // r_s: the host stops 1e-6 of it short of a horizon or a star

TEST_CASE("ball motion: free fall, past the hole, into it and out of its past, is the reference's") {
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
                                     {"kerr", {{"spin", 0.9}}, {6, 0, 1}, {0.1, 0.05, 0.25}},
                                     {"kerr", {{"spin", -0.9}}, {5, 1, 2}, {0, 0, 0}},
                                     {"kerr", {{"spin", 0.998}}, {0, 0, 6}, {0, 0, 0}},
                                     {"kerr", {{"spin", 0.7}}, {0, 0, 5}, {0.1, 0.2, 0.1}},
                                     {"kerr", {{"spin", 0.7}}, {5, 0, 0.5}, {0.1, 0.2, 0}},
                                     {"kerr-newman", {{"spin", 0.6}, {"charge", 0.6}}, {6, 0, 1}, {-0.1, 0.25, 0.2}},
                                     {"minkowski", {}, {3, 1, 1}, {-0.8, 0, 0}}};
    for (const Case& c : cases) {
        BallSpec ball;
        ball.motion = BallMotion::kGeodesic, ball.position = c.position, ball.velocity = c.velocity;
        const auto spacetime = *make_spacetime(c.metric, c.parameters);
        const auto metric = std::move(*reference::make_metric({c.metric, c.parameters}));
        const auto exact = reference::ball_way(*metric, ball);
        const auto motion = ball_motion(*spacetime, ball);
        REQUIRE(motion);
        double worst = 0, when = 0, fastest = 0, faster = 0;
        for (const double sense : {1.0, -1.0})
            for (double t = 0.1; t < 90; t += 0.37) {
                constexpr double kApart = 1e-4;
                const BallPlace there = (*motion)(sense * t);
                const double off = length(there.place - exact(sense * t));
                const Vec3 rate = (exact(sense * t + kApart) - exact(sense * t - kApart)) / (2 * kApart);
                if (!(off <= worst)) worst = off, when = sense * t;
                if (!(length(there.velocity - rate) <= fastest))
                    fastest = length(there.velocity - rate), faster = sense * t;
            }
        fmt::print("free fall in {}: off by at most {:.1e} r_s, at t = {:.1f}; velocity by {:.1e} c at t = {:.1f}\n",
                   c.metric, worst, when, fastest, faster);
        CHECK(worst < kPlace);
        if (spacetime->rotates()) CHECK(fastest < kRate);
    }
}

// A camera at 1e9 r_s sees a ball as it was then.
TEST_CASE(
    "ball motion: long ago, in orbit, escaped, fallen in, is the reference's; circles and straight ways are closed "
    "forms") {
    constexpr double kShare = 1e-11;  // of the time, in r_s: the host's error in a period is that of 1e-11 a step
    const auto spacetime = *make_spacetime("schwarzschild", {});
    const auto metric = std::move(*reference::make_metric({"schwarzschild", {}}));
    for (const Vec3 velocity :
         {Vec3{0.05, 0.1, 0.3}, Vec3{0, 0.2, 0.35}, Vec3{0.3, 0, 0.1}, Vec3{-0.1, 0, 0.1}, Vec3{0, 0, 0}}) {
        BallSpec ball;
        ball.motion = BallMotion::kGeodesic, ball.position = {8, 0, 1}, ball.velocity = velocity;
        const auto exact = reference::ball_way(*metric, ball);
        const auto motion = ball_motion(*spacetime, ball);
        REQUIRE(motion);
        for (const double t : {-1.2e4, 3e4, -1e6, 1e7, -1e9, 1e9}) {
            const double off = length((*motion)(t).place - exact(t));
            CAPTURE(velocity.x);
            CAPTURE(velocity.z);
            CAPTURE(t);
            CHECK(off < kPlace + kShare * std::fabs(t));
        }
    }
    BallSpec circling;  // dphi/dt = sqrt(1/(2 r^3)); one at rest there measures the speed r dphi/dt / sqrt(1 - 1/r)
    circling.motion = BallMotion::kGeodesic, circling.position = {8, 0, 0},
    circling.velocity = {0, 0, 1 / std::sqrt(14.0)};
    const auto exact = reference::ball_way(*metric, circling);
    const auto motion = ball_motion(*spacetime, circling);
    REQUIRE(motion);
    for (const double t : {1e3, -1e5, 1e8}) {
        const double phi = t * std::sqrt(1.0 / (2.0 * 8 * 8 * 8));
        const Vec3 place{8 * std::cos(phi), 8 * std::sin(phi), 0};
        CAPTURE(t);
        CHECK(length(exact(t) - place) < kShare * std::fabs(t));
        CHECK(length((*motion)(t).place - place) < kShare * std::fabs(t));
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
