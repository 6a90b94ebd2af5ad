// Units and the decimal sign of displayed numbers.
#include <doctest/doctest.h>

#include <limits>

#include "scene/ray.h"
#include "spacetime/registry.h"
#include "studio/number_words.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;

constexpr LengthUnit kUnits[] = {LengthUnit::kSchwarzschildRadius, LengthUnit::kMass, LengthUnit::kKilometre};

TEST_CASE("lengths and times: in r_s, M, or km and seconds") {
    const char* lengths[] = {"3 r_s", "6 M", "3.80703e+07 km"};
    const char* times[] = {"1.50000 r_s/c", "3.00000 M/c", "1.05824 min"};
    for (std::size_t i = 0; i < 3; ++i) {
        const NumberStyle style{kUnits[i]};
        CHECK(length_words(3.0, style) == lengths[i]);
        CHECK(time_words(1.5, style) == times[i]);
        CHECK(length_words(kNotANumber, style) == "none");
        CHECK(time_words(std::numeric_limits<double>::infinity(), style) == "none");
    }
    const NumberStyle of_sun{LengthUnit::kKilometre, 1.0};
    CHECK(length_words(1.0, of_sun) == "2.95325 km");  // 2 G M_sun/c^2
    CHECK(time_words(1.0, of_sun) == "9.85098e-06 s");
    CHECK(time_words(7200 / 9.85098e-6, of_sun) == "2.00000 h");
}

TEST_CASE("a decimal comma replaces the point everywhere") {
    NumberStyle style{LengthUnit::kSchwarzschildRadius, kMassOfSgrA_suns, true};
    CHECK(length_words(1.5, style) == "1,5 r_s");
    CHECK(time_words(1.5, style) == "1,50000 r_s/c");
    CHECK(number_words(1.25e-9, style) == "1,25e-09");
    CHECK(fixed_words(0.5, style, 3) == "0,500");
}

TEST_CASE("counts stand in groups of three") {
    CHECK(count_words(0) == "0");
    CHECK(count_words(999) == "999");
    CHECK(count_words(1000) == "1 000");
    CHECK(count_words(921600) == "921 600");
    CHECK(count_words(1234567) == "1 234 567");
}

TEST_CASE("a scene's mass comes before the panel's; wormholes have no unit") {
    const auto hole = make_spacetime("schwarzschild", {}), wormhole = make_spacetime("ellis", {});
    REQUIRE(hole);
    REQUIRE(wormhole);
    Scene scene;
    const NumberStyle wish{LengthUnit::kKilometre, 10.0};
    CHECK(style_in(scene, **hole, wish) == wish);
    scene.object.mass_suns = 4.0;
    CHECK(style_in(scene, **hole, wish).mass_suns == 4.0);
    CHECK(length_words(2.5, style_in(scene, **wormhole, wish)) == "2.5");
    CHECK(time_words(2.5, style_in(scene, **wormhole, wish)) == "2.50000");
}

}  // namespace
