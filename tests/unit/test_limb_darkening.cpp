// The reference's law of limb darkening against Chandrasekhar's printed table, and the cosine that it is asked for.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/disc_light.h"
#include "reference/metric.h"

using namespace nullscope;

namespace {

struct LimbDarkeningFixture {
    std::unique_ptr<reference::Metric> metric = std::move(*reference::make_metric({"schwarzschild", {}}));
    DiscSpec plain, darkened;
    LightSpec at_rest;  // matter sees directions as observers at rest do
    LimbDarkeningFixture() {
        plain.emission = DiscEmission::kThermal;
        darkened = plain;
        darkened.effects.limb_darkening = true;
        at_rest.doppler = false;
    }
};

// I/F, by light that leaves matter at rest in the radial plane.
struct Law : LimbDarkeningFixture {
    const reference::DiscLight with{*metric, darkened, at_rest}, without{*metric, plain, at_rest};
    double law(double cosine) const {
        const reference::PhotonAtDisc photon{8.0, 0.0, std::sqrt((1 - cosine) * (1 + cosine))};
        return with.colour(photon, 1).y / without.colour(photon, 1).y;
    }
};

}  // namespace

// Radiative Transfer (1960), table XXIV: I(mu)/F at mu = 0, 0.05, ..., 1.
TEST_CASE_FIXTURE(Law, "limb darkening: the reference's law is Chandrasekhar's table, and keeps the flux") {
    constexpr std::array kTable = {0.41441, 0.47490, 0.52397, 0.57001, 0.61439, 0.65770, 0.70029,
                                   0.74234, 0.78398, 0.82530, 0.86637, 0.90722, 0.94789, 0.98842,
                                   1.02882, 1.06911, 1.10931, 1.14943, 1.18947, 1.22945, 1.26938};
    constexpr double kPrinted = 1.1e-5;     // five digits, by a method with some units of the fifth
    constexpr double kPrintedAtRim = 1e-4;  // mu = 0.05, where the law bends most: 8.5e-5, four digits
    double worst = 0;
    for (std::size_t i = 0; i < kTable.size(); ++i) {
        const double off = std::abs(law(0.05 * static_cast<double>(i)) - kTable[i]);
        CAPTURE(i);
        CHECK(off < (i == 1 ? kPrintedAtRim : kPrinted));
        if (i != 1) worst = std::max(worst, off);
    }
    fmt::print("limb darkening: 20 entries of the table within {:.1e}, the second within {:.1e}\n", worst,
               std::abs(law(0.05) - kTable[1]));
    constexpr int kSteps = 20000;  // middles: some 1e-9
    constexpr double kFlux = 1e-6;
    double flux = 0;
    for (int i = 0; i < kSteps; ++i) flux += 2 * law((i + 0.5) / kSteps) * (i + 0.5) / kSteps / kSteps;
    fmt::print("limb darkening: twice the mean of mu I/F is 1 {:+.1e}\n", flux - 1);
    CHECK(std::abs(flux - 1) < kFlux);
}

// Matter on a circle at v, light along the normal in its own frame: to who is at rest there it comes tilted by the aberration of v,
// with cosine 1/gamma. And the other way round.
TEST_CASE_FIXTURE(LimbDarkeningFixture,
                  "limb darkening: the cosine in the matter's frame has its motion's aberration") {
    constexpr double kRounding = 1e-9;
    const double r = 8.0, lapse = std::sqrt(1 - 1 / r), v = std::sqrt(0.5 / (r - 1)), gamma = 1 / std::sqrt(1 - v * v);
    const reference::DiscLight moving(*metric, darkened, {}), rest(*metric, darkened, at_rest);
    const reference::PhotonAtDisc tilted{r, v * r / lapse, 0.0}, upward{r, 0.0, 0.0};
    CHECK(moving.cosine(tilted) == doctest::Approx(1.0).epsilon(kRounding));
    CHECK(rest.cosine(tilted) == doctest::Approx(1 / gamma).epsilon(kRounding));
    CHECK(moving.cosine(upward) == doctest::Approx(1 / gamma).epsilon(kRounding));
    CHECK(rest.cosine(upward) == doctest::Approx(1.0).epsilon(kRounding));
    // Gravity changes frequencies, not directions; straight light has the sine L/r to who is at rest.
    LightSpec part;
    part.gravity = false;
    CHECK(reference::DiscLight(*metric, darkened, part).cosine(tilted) == moving.cosine(tilted));
    part = {};
    part.lensing = false;
    CHECK(reference::DiscLight(*metric, darkened, part).cosine({r, v * r, 0.0}) ==
          doctest::Approx(1.0).epsilon(kRounding));
    CHECK(moving.cosine({r, 0.0, 1.0}) == 0.0);
    CHECK(moving.cosine({r, 0.0, 1.0 + 1e-15}) == 0.0);  // rounded: no NaN
}
