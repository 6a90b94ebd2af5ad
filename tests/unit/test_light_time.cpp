// How long light takes, by the reference: exact values.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "reference/light_time.h"
#include "reference/light_times.h"
#include "reference/orbit.h"
#include "reference/smooth_segment.h"

using namespace nullscope;

namespace {

// From r to r, by way of the turning point, with impact parameter b.
double there_and_back(double b, double r) {
    auto made = reference::make_metric({"schwarzschild", {}});
    const auto metric = std::move(*made);
    auto traced = metric->orbits()->from_reduced({1 / b, 1 / r, 1});
    const auto orbit = std::move(*traced);
    reference::LightClock clock(*metric->orbits(), *orbit, 1 / b, r, false);
    return clock.delay(2 * orbit->turn_angle());
}

constexpr double kM = 0.5;  // the mass in r_s

}  // namespace

TEST_CASE("light time: from 1000 M through the periapsis to 1000 M") {
    for (const auto& [b, exact] : {std::pair{6.0, 2034.71014050567}, {10.0, 2026.465430162}, {100.0, 2004.192088803}}) {
        const double found = there_and_back(b * kM, 1000 * kM) / kM;
        fmt::print("light time, b = {} M: {:.11f} M, exact {} M\n", b, found, exact);
        CHECK(std::fabs(found / exact - 1) < 1e-12);  // as many digits as the exact ones are known to
    }
}

TEST_CASE("light time: what T and t say is one thing") {
    // T = v_cam - v_inf of a ray to the sky; t to a place far out, less that place's r_* and plus the camera's, must tend to it.
    auto made = reference::make_metric({"reissner-nordstrom", {{"charge", 0.8}}});
    const auto metric = std::move(*made);
    for (const double q : {0.11, 0.3, 0.4}) {
        const double r = 9.0;
        auto traced = metric->orbits()->from_reduced({q, 1 / r, 1});
        const auto orbit = std::move(*traced);
        REQUIRE(orbit->fate() == Fate::kEscaped);
        reference::LightClock clock(*metric->orbits(), *orbit, q, r, false);
        const double at = orbit->angle() * (1 - 1e-4), far = 1 / orbit->zeta_at(at);
        const double t = clock.delay(at) + r + reference::tortoise_excess(*metric->orbits(), r) - far -
                         reference::tortoise_excess(*metric->orbits(), far) +
                         1 / (2 * q * q * far);  // and what T gains from there on
        CHECK(std::fabs(t - orbit->delay()) < 1e-7 * orbit->delay());
    }
}

// The clock's sums against quadrature from the camera on, asked in no order: past the hole to the sky, and down to the horizon.
TEST_CASE("light time: of every place on a ray, to 1e-11 of itself") {
    auto made = reference::make_metric({"schwarzschild", {}});
    const auto metric = std::move(*made);
    for (const double q : {0.11, 0.38, 0.3849, 0.3850, 0.5, 3.0}) {
        CAPTURE(q);
        const double r = 12.0;
        auto traced = metric->orbits()->from_reduced({q, 1 / r, 1});
        const auto orbit = std::move(*traced);
        reference::LightClock clock(*metric->orbits(), *orbit, q, r, false);
        const auto rate = [&](double angle) {
            const double zeta = orbit->zeta_at(angle);
            return q / (zeta * zeta * (1 - zeta));
        };
        for (const double part : {0.9, 0.2, 0.97, 0.01, 0.5}) {
            CAPTURE(part);
            double sum = 0;
            for (int i = 0; i < 200; ++i)
                sum += reference::PanelGauss::integrate(rate, part * orbit->angle() * i / 200,
                                                        part * orbit->angle() * (i + 1) / 200);
            CHECK(std::fabs(clock.delay(part * orbit->angle()) / sum - 1) < 1e-11);
        }
    }
}

TEST_CASE("light time: past a mass, from 1e3 to 1e9 r_s away") {
    // By mpmath in 40 digits, by two substitutions: dr/(A sqrt(1 - b^2 A/r^2)) from the turning point, with r^2 = r0^2 + s^2 and r = r0 + x^2.
    struct Case {
        double impact, from, to, time;
    };
    constexpr Case kCases[] = {{3, 1e7, 1e7, 20000037.18404842500679},    {5, 1e7, 1e7, 20000033.09369273960004},
                               {1000, 1e7, 3e6, 13000019.39223369641915}, {2.6, 1e5, 1e7, 10100046.15970669979708},
                               {1e5, 1e9, 1e8, 1099999963.504436394234},  {5, 500, 500, 1013.23271508099915129}};
    constexpr double kRoundings = 4;  // of the time itself: 1.5e-8 r_s/c of 2e7
    auto made = reference::make_metric({"schwarzschild", {}});
    double worst = 0;
    for (const Case& c : kCases) {
        CAPTURE(c.impact);
        CAPTURE(c.from);
        const auto passage = reference::light_past(*(*made)->orbits(), c.from, c.to, c.impact);
        REQUIRE(passage);
        const double roundings = std::fabs(passage->time - c.time) / (c.time * std::numeric_limits<double>::epsilon());
        CHECK(roundings <= kRoundings);
        worst = std::max(worst, roundings);
    }
    fmt::print("light time past a mass: {:.2g} roundings at most\n", worst);
}

// What stars behind a flowing disc ask, of hundreds of thousands of rays.
TEST_CASE(
    "light time: between rays of a grid, to 1e-11 of itself, of nearly all places within half of the camera's radius") {
    for (const auto& [name, parameters, r0] : {std::tuple{"schwarzschild", std::map<std::string, double>{}, 30.0},
                                               {"schwarzschild", {}, 5.0},
                                               {"reissner-nordstrom", {{"charge", 0.8}}, 12.0},
                                               {"minkowski", {}, 20.0}}) {
        auto made = reference::make_metric({name, parameters});
        const auto metric = std::move(*made);
        const auto ray_at = [&, r = r0](double inward) {
            const reference::LocalRay local{r, -std::cos(inward), std::sin(inward)};
            return reference::LightTimes::Ray{metric->orbits()->from_static(local),
                                              metric->orbits()->lapse(r) / (r * local.n_t)};
        };
        const reference::LightTimes times(*metric->orbits(), ray_at, r0, false);
        double worst = 0, last = 0;
        int asked = 0, told = 0;
        std::vector<double> views;
        for (double inward = M_PI - 0.05; inward > 0; inward -= 0.0113) views.push_back(inward);
        for (double low = 0, high = M_PI; high - low > 1e-15 * high && high > 1e-3; last = high) {
            const double middle = 0.5 * (low + high);
            (ray_at(middle).orbit->fate() == Fate::kEscaped ? high : low) = middle;
        }
        for (double off = 0.3; off > 2e-7; off *= 0.8)
            views.push_back(last * (1 + off));  // up to the fourth image of a star
        for (const double inward : views) {
            const auto ray = ray_at(inward);
            reference::LightClock clock(*metric->orbits(), *ray.orbit, ray.q, r0, false);
            if (ray.orbit->fate() != Fate::kEscaped) {
                CHECK(!times(inward, 0.5 * ray.orbit->angle()));
                continue;
            }
            for (const double part : {0.2, 0.5, 0.8}) {
                const double angle = part * ray.orbit->angle(), exact = clock.delay(angle);
                if (!(ray.orbit->zeta_at(angle) > 2 / r0)) continue;
                ++asked;
                const auto time = times(inward, angle);
                if (!time) continue;
                ++told;
                worst = std::max(worst, std::fabs(*time - exact) / exact);
            }
        }
        fmt::print("light times about {}, r = {}: off by {:.1e}, {} of {}\n", name, r0, worst, told, asked);
        CHECK(worst < 1e-11);
        CHECK(told > 0.9 * asked);
    }
}
