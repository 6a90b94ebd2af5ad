// The polynomial by which the shader turns a disc's rings, against circular orbits of the metric.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "table/disc_rate.h"

namespace {

using namespace nullscope;

MetricParameters with_lapse(const std::string& a) {
    MetricParameters parameters;
    parameters.formulas["A"] = a;
    return parameters;
}

TEST_CASE("disc rate: the polynomial is that of circular orbits, whatever the metric") {
    struct RateCase {
        std::string metric;
        MetricParameters parameters;
        double widest, error;
    };
    const std::string core = "1 - r^2/(r^3 + 0.3^2)", kottler = "1 - 1/r - 0.0002*r^2/3";
    const RateCase cases[] = {{"schwarzschild", {}, 1000, 1e-14},
                              {"reissner-nordstrom", {{{"charge", 0.4}}}, 1000, 1e-8},
                              {"minkowski", {}, 1000, 1e-14},
                              {"formula", with_lapse(core), 1000, 3e-5},
                              {"formula", with_lapse(kottler), 10, 2e-7}};
    for (const RateCase& c : cases)
        for (const double wide : {1.5, std::sqrt(c.widest), c.widest}) {
            const auto spacetime = *make_spacetime(c.metric, c.parameters);
            const double inner = 1.6;
            const DiscRate rate = disc_rate(*spacetime, inner, wide * inner);
            double worst = 0, largest = 0;
            for (double r = inner; r <= wide * inner; r *= 1.013) {
                const auto orbit = circular_orbit(*spacetime, r);
                if (!orbit) continue;
                const double exact = orbit->omega * orbit->omega * r * r * r;
                worst = std::max(worst, std::fabs(rate(r) - exact)), largest = std::max(largest, exact);
            }
            fmt::print("{} out to {:.4g} times the inner radius: {:.1e} of {:.3g}\n", c.metric, wide, worst, largest);
            CHECK(worst <= c.error * std::max(largest, 1e-3));
        }
}

}  // namespace
