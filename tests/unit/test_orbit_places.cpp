// Places between places of an orbit, for looks at bodies: the orbit's own, and fewer of them asked.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "reference/orbit.h"
#include "reference/orbit_places.h"
#include "scene/scene.h"
#include "support/costly.h"

using namespace nullscope;

namespace {

constexpr double kPlaceError = 1e-11;  // orbit_places.h: of the place; in a wormhole of the largest l around

class CountedOrbit final : public reference::Orbit {
public:
    explicit CountedOrbit(const reference::Orbit& orbit) : Orbit(orbit.zeta_at(0)), orbit_(orbit) {
        fate_ = orbit.fate(), angle_ = orbit.angle();
    }
    double delay() const override { return orbit_.delay(); }
    mutable int asked = 0;

private:
    double place_at(double angle) const override { return ++asked, orbit_.zeta_at(angle); }
    const reference::Orbit& orbit_;
};

}  // namespace

TEST_CASE(
    "orbit places: those of the orbit to 1e-11, whatever the metric, and a third as many asked where looks crowd" *
    test::costly()) {
    struct Case {
        SpacetimeSpec spacetime;
        std::vector<double> places;  // r, l
    };
    std::vector<Case> cases = {{{"schwarzschild", {}}, {1.7, 6, 40, 1e5}},
                               {{"reissner-nordstrom", {{"charge", 0.8}}}, {2.5, 20}},
                               {{"minkowski", {}}, {10}},
                               {{"ellis", {{"throat", 1.0}}}, {4, -2}},
                               {{"dneg-wormhole", {{"length", 0.01}, {"lensing_width", 0.05}}}, {4, 0.3}},
                               {{"formula", {}}, {8}}};
    cases.back().spacetime.parameters.formulas = {{"A", "1 - r^2/(r^3 + 0.1225)"}};  // Hayward's
    for (const Case& c : cases) {
        const auto metric = std::move(*reference::make_metric(c.spacetime));
        const bool by_length = metric->orbits()->by_proper_length();
        double worst = 0;
        long long asked = 0, looks = 0;
        for (const double r : c.places)
            for (double alpha = 0.03; alpha < 3.1; alpha += 0.071) {
                const auto orbit = metric->orbits()->from_static({r, std::cos(alpha), std::sin(alpha)});
                const CountedOrbit counted(*orbit);
                reference::OrbitPlaces places(counted, by_length);
                const double end = std::min(orbit->angle(), 12.0);
                for (const int closer : {1, 20}) {
                    const double step = 0.01 / closer;
                    for (double angle = 0; angle < end; angle += step) {
                        const double exact = orbit->zeta_at(angle), found = places(angle);
                        double scale = std::abs(exact);
                        if (by_length)
                            for (const double by : {-0.125, 0.125})
                                if (angle + by > 0 && angle + by < end)
                                    scale = std::max(scale, std::abs(orbit->zeta_at(angle + by)));
                        worst = std::max(worst, std::abs(found - exact) / scale);
                        ++looks;
                    }
                }
                asked += counted.asked;
            }
        fmt::print("orbit places, {}: off by {:.1e} at most, {} of {} asked\n", c.spacetime.metric, worst, asked,
                   looks);
        CHECK(worst < kPlaceError);
        CHECK(3 * asked < looks);
    }
}
