// The made nebula: the same for the same seed, another for another, without seams, bright and dark.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sky/nebula.h"
#include "sky/sky.h"
#include "support/folders.h"

using namespace nullscope;

namespace {

constexpr int kNebulaFace = 128;

SkyCube nebula(const NebulaSpec& spec) {
    SkySpec sky;
    sky.kind = SkyKind::kNebula;
    sky.nebula = spec;
    auto cube = build_sky(sky, {}, kNebulaFace);
    REQUIRE(cube);
    return std::move(*cube);
}

double luminance(const float* c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

}  // namespace

TEST_CASE("nebula: the same seed gives the same sky, another seed another; its colours are those that it is given") {
    const SkyCube one = nebula({}), again = nebula({}), other = nebula({.seed = 2});
    for (std::size_t face = 0; face < 6; ++face) {
        CHECK(one.faces[face].data == again.faces[face].data);
        CHECK(one.faces[face].data != other.faces[face].data);
    }
    const Nebula all({}, Mat3{}, 1.0, kNebulaFace, 0), red({.oxygen = {0, 0, 0}}, Mat3{}, 1.0, kNebulaFace, 0);
    Vec3 sum{}, sum_of_red{};
    for (int y = -20; y <= 20; ++y)
        for (int z = -20; z <= 20; ++z) {
            const Vec3 place = normalized(Vec3{1.0, 0.04 * y, 0.04 * z});
            sum = sum + all.light(place), sum_of_red = sum_of_red + red.light(place);
        }
    CHECK(sum_of_red.x > 2.0 * sum_of_red.y);
    CHECK(sum.y > 1.3 * sum_of_red.y);
    CHECK(sum.x < 1.2 * sum_of_red.x);
}

TEST_CASE("nebula: bright about its heart, dark elsewhere, finite and without seams") {
    const SkyCube sky = nebula({});
    std::vector<double> light;
    for (const Image<float>& face : sky.faces)
        for (std::size_t i = 0; i < face.data.size(); i += 3) light.push_back(luminance(&face.data[i]));
    std::sort(light.begin(), light.end());
    CHECK(light.front() >= 0.0);
    CHECK(light[light.size() / 4] < 0.01);                  // black space
    CHECK(light[light.size() - light.size() / 20] > 0.05);  // and a twentieth that is plainly seen
    // Painted faces agree with the formula, next to edges too.
    const Nebula gas({}, Mat3{}, 1.0, kNebulaFace, 0);
    double off = 0.0, all = 0.0;
    for (int face = 0; face < 6; ++face) {
        SkyRows rows{face, kNebulaFace, 0, 0, kNebulaFace, {}, {}};
        for (auto& plane : rows.planes) plane.assign(rows.texels(), 0.0f);
        gas.paint(rows);
        for (int y = 0; y < kNebulaFace; ++y)
            for (int x = 0; x < kNebulaFace; x += x == 0 || x == kNebulaFace - 2 ? 1 : 2) {
                const Vec3 wanted =
                    gas.light(normalized(cube_direction(face, (x + 0.5) / kNebulaFace, (y + 0.5) / kNebulaFace)));
                off += std::fabs(rows.row(1, y)[x] - wanted.y), all += wanted.y;
            }
    }
    CHECK(off < 0.05 * all);  // filaments finer than a texel; places that are off by a texel or two: 0.1 and more
}

TEST_CASE("nebula: its stars are many, brightest first, and hot ones are among the brightest") {
    const std::vector<Star> stars = Nebula({}, Mat3{}, 1.0, kNebulaFace, 0).stars();
    CHECK(stars.size() > 10000);
    for (std::size_t i = 1; i < stars.size(); ++i) REQUIRE(stars[i - 1].magnitude <= stars[i].magnitude);
    const auto hot = std::count_if(stars.begin(), stars.begin() + 20,
                                   [](const Star& s) { return b_minus_v(static_cast<int>(s.colour_code)) < -0.2; });
    CHECK(hot >= 3);
}
