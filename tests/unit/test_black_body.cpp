// Colours of black bodies against published figures.
#include <doctest/doctest.h>

#include <cmath>

#include "light/black_body.h"
#include "light/cie_1931.h"
#include "reference/seen_light.h"
#include "shaderlib/shader_source.h"
#include "table/disc_light.h"

namespace {

using namespace nullscope;

TEST_CASE("light: the colour-matching functions have the sums that CIE 15:2004 prints") {
    double x = 0, y = 0, z = 0;
    for (const ColourMatch& match : kCie1931) x += match.x, y += match.y, z += match.z;
    CHECK(x == doctest::Approx(21.371524).epsilon(1e-9));
    CHECK(y == doctest::Approx(21.371327).epsilon(1e-9));
    CHECK(z == doctest::Approx(21.371540).epsilon(1e-9));
}

TEST_CASE("light: chromaticity of black bodies: illuminant A, and the locus at 6504 K within 1e-3") {
    const auto chromaticity = [](double t) {
        const Vec3 c = black_body_xyz(t);
        const double sum = c.x + c.y + c.z;
        return Vec3{c.x / sum, c.y / sum, 0};
    };
    const Vec3 a = chromaticity(2855.5);  // 2848 K of 1931 with today's second radiation constant
    CHECK(std::fabs(a.x - 0.44757) < 1e-4);
    CHECK(std::fabs(a.y - 0.40745) < 1e-4);
    const double t = 6504;  // cubic fit of the locus by Kim and others (2002), good to 1e-4 here
    const double x = -3.0258469e9 / (t * t * t) + 2.1070379e6 / (t * t) + 0.2226347e3 / t + 0.24039;
    const double y = 3.0817580 * x * x * x - 5.87338670 * x * x + 3.75112997 * x - 0.37001483;
    const Vec3 d = chromaticity(t);
    CHECK(std::fabs(d.x - x) < 1e-3);
    CHECK(std::fabs(d.y - y) < 1e-3);
}

TEST_CASE("light: white is white, and a colour outside of the gamut keeps its luminance") {
    const Vec3 white = rec709_from_xyz({0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290});
    for (const double c : {white.x, white.y, white.z}) CHECK(std::fabs(c - 1) < 1e-3);
    const Vec3 xyz = black_body_xyz(1200);
    const Vec3 raw = rec709_from_xyz(xyz / xyz.y), in = into_gamut(raw);
    CHECK(raw.z < 0);
    CHECK(in.z == doctest::Approx(0));
    CHECK(0.2126390059 * in.x + 0.7151686788 * in.y + 0.0721923154 * in.z == doctest::Approx(1));
}

TEST_CASE(
    "light: the table's straight lines are within 2e-5 of the black body between its texels, and hue at gT is T's") {
    const TexelGrid row = black_body_row();
    const auto at = [&](double t, int channel) {
        const double x = (std::log2(t) - kColdest) * kBlackBodyCells / (kHottest - kColdest);
        const auto i = static_cast<std::size_t>(x);
        return row.texels[4 * i + static_cast<std::size_t>(channel)] +
               (x - static_cast<double>(i)) * (row.texels[4 * i + 4 + static_cast<std::size_t>(channel)] -
                                               row.texels[4 * i + static_cast<std::size_t>(channel)]);
    };
    for (double t = 1000; t < 400000; t *= 1.0137) {
        const Vec3 xyz = black_body_xyz(t), rgb = rec709_from_xyz(xyz / xyz.y);
        CAPTURE(t);
        CHECK(std::fabs(at(t, 0) - rgb.x) < 2e-5 * rgb.x + 2e-5);
        CHECK(std::fabs(at(t, 1) - rgb.y) < 2e-5);
        CHECK(std::fabs(at(t, 2) - rgb.z) < 2e-5 * rgb.z + 2e-5);
        CHECK(std::fabs(at(t, 3) - std::log2(xyz.y)) < 2e-4);
    }
}

TEST_CASE("light: a black body seen with its frequencies times g is one of gT") {
    constexpr double kPromised = 1e-6;
    double worst = 0;
    for (const double t : {2000.0, 6504.0, 30000.0})
        for (const double g : {0.5, 0.9, 1.3, 2.0}) {
            const Vec3 shifted = reference::seen_black_body(t, g, {}), own = reference::seen_black_body(g * t, 1.0, {});
            worst = std::fmax(worst, length(shifted - own) / length(own));
        }
    MESSAGE("largest difference " << worst);
    CHECK(worst < kPromised);
    LightSpec unshifted;
    unshifted.shift = false;  // that it can fail
    CHECK(length(reference::seen_black_body(6504, 0.5, unshifted) - reference::seen_black_body(3252, 1.0, {})) > 1e-3);
}

TEST_CASE("light: shader and tables agree on the tables' sizes") {
    const std::string text(shader_file("effect/black_body.glsl")), matter(shader_file("object/disc_matter.glsl"));
    CHECK(text.find("#define PLANCK_CELLS " + std::to_string(kBlackBodyCells) + "\n") != std::string::npos);
    CHECK(text.find("#define PLANCK_COLDEST 9.0\n") != std::string::npos);
    CHECK(text.find("#define PLANCK_PER_OCTAVE 102.4\n") != std::string::npos);
    CHECK(kColdest == 9.0);
    CHECK(kBlackBodyCells / (kHottest - kColdest) == doctest::Approx(102.4));
    CHECK(matter.find("#define DISC_MATTER_CELLS " + std::to_string(kDiscFlowCells) + "\n") != std::string::npos);
}

}  // namespace
