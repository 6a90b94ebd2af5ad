// The embedded equatorial plane against closed forms.
#include <doctest/doctest.h>

#include <cmath>

#include "spacetime/registry.h"
#include "studio/embedding.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;

TEST_CASE("embedding: Flamm's paraboloid, a wormhole's catenoid, a plane") {
    const auto hole = make_spacetime("schwarzschild", {}), wormhole = make_spacetime("ellis", {}),
               flat = make_spacetime("minkowski", {}),
               charged = make_spacetime("reissner-nordstrom", {{"charge", 0.8}});
    REQUIRE(hole);
    REQUIRE(wormhole);
    REQUIRE(flat);
    REQUIRE(charged);
    const auto paraboloid = embedding(*(*hole)->spherical(), 16.0);
    REQUIRE(paraboloid.size() > 100);
    CHECK(paraboloid.front().r == 1.0);
    CHECK(paraboloid.back().r == doctest::Approx(16.0));
    for (const EmbeddedCircle& circle : paraboloid)
        CHECK(circle.z == doctest::Approx(2 * std::sqrt(circle.r - 1)).epsilon(1e-9));
    CHECK(height_at(paraboloid, 5.0).value_or(0.0) == doctest::Approx(4.0).epsilon(1e-4));
    CHECK_FALSE(height_at(paraboloid, 0.5));
    CHECK_FALSE(height_at(paraboloid, 17.0));

    const double throat = (*wormhole)->areal_radius(0.0);
    for (const EmbeddedCircle& circle : embedding(*(*wormhole)->spherical(), 8.0))
        CHECK(circle.z == doctest::Approx(throat * std::asinh(circle.r / throat)).epsilon(1e-3));

    for (const EmbeddedCircle& circle : embedding(*(*flat)->spherical(), 8.0)) CHECK(circle.z == 0.0);
    CHECK(embedding(*(*charged)->spherical(), 8.0).front().r == doctest::Approx(*(*charged)->horizon_radius()));
}

TEST_CASE("embedding: a naked charge has none inside of r = kappa, where B falls below 1") {
    const double kappa = 1.0;  // (Q/2M)^2
    const auto naked = make_spacetime("reissner-nordstrom", {{"charge", 2.0}});
    REQUIRE(naked);
    const auto surface = embedding(*(*naked)->spherical(), 9.0);
    CHECK(std::fabs(surface.front().r - kappa) < 0.05);
    CHECK(surface.front().z == 0.0);
    CHECK(surface.back().r == doctest::Approx(9.0));
}

}  // namespace
