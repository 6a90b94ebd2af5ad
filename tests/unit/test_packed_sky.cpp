// Skies as textures hold them: packed texels, mip levels, borders.
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sky/cube.h"
#include "sky/packed_sky.h"
#include "sky/sky.h"
#include "support/folders.h"

using namespace nullscope;

namespace {

const std::filesystem::path kAssets = test::source_folder() / "assets";

// By the definition of OpenGL 3.3 core, 2.1.3 and 2.1.4: five bits of exponent, bias 15, and the rest mantissa.
double unpacked(std::uint32_t bits, int mantissa_bits) {
    const auto exponent = static_cast<int>(bits >> mantissa_bits),
               mantissa = static_cast<int>(bits & ((1u << mantissa_bits) - 1));
    const double fraction = std::ldexp(mantissa, -mantissa_bits);
    return exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1.0 + fraction, exponent - 15);
}
Vec3 unpacked(std::uint32_t texel) {
    return {unpacked(texel & 0x7ff, 6), unpacked(texel >> 11 & 0x7ff, 6), unpacked(texel >> 22, 5)};
}

using Level = std::vector<std::uint32_t>;

// By face and level; checks that every row comes once, in its order.
std::vector<std::vector<Level>> levels_of(const SkyPainter& painter, bool bordered) {
    const int levels = sky_levels(painter.face_size(), bordered),
              side = bordered ? bordered_size(painter.face_size()) : painter.face_size();
    std::vector<std::vector<Level>> all(6, std::vector<Level>(static_cast<std::size_t>(levels)));
    pack_sky(painter, [&](const PackedRows& rows) {
        REQUIRE(rows.level < levels);
        Level& level = all[static_cast<std::size_t>(rows.face)][static_cast<std::size_t>(rows.level)];
        REQUIRE(rows.width == side >> rows.level);
        REQUIRE(level.size() == static_cast<std::size_t>(rows.first * rows.width));
        level.insert(level.end(), rows.texels, rows.texels + rows.count * rows.width);
    });
    for (const auto& face : all)
        for (int level = 0; level < levels; ++level)
            REQUIRE(face[static_cast<std::size_t>(level)].size() ==
                    static_cast<std::size_t>((side >> level) * (side >> level)));
    return all;
}

}  // namespace

TEST_CASE("packed_light: cut off after six and five bits, never more than it was, never what is no number") {
    for (double value = std::ldexp(1.0, -20); value < 65000.0; value *= 1.137) {
        const auto v = static_cast<float>(value);
        const Vec3 kept = unpacked(packed_light(v, v, v));
        const double step6 = std::max(std::ldexp(1.0, -20), std::ldexp(value, -6)),
                     step5 = std::max(std::ldexp(1.0, -19), std::ldexp(value, -5));
        CAPTURE(value);
        CHECK(kept.x <= v);
        CHECK(kept.x > v - step6);
        CHECK(kept.y == kept.x);
        CHECK(kept.z <= v);
        CHECK(kept.z > v - step5);
        CHECK(packed_light(static_cast<float>(kept.x), static_cast<float>(kept.y), static_cast<float>(kept.z)) ==
              packed_light(v, v, v));
    }
    constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
    CHECK(packed_light(0, -1, -kInfinity) == 0);
    CHECK(packed_light(kNan, kNan, kNan) == 0);
    const Vec3 most = unpacked(packed_light(kInfinity, 1e30f, 1e6f));
    CHECK(most.x == 65024.0);
    CHECK(most.y == 65024.0);
    CHECK(most.z == 64512.0);
}

TEST_CASE("halve_packed: the mean of two by two") {
    const Level four = {packed_light(1, 0, 3e-5f), packed_light(2, 8, 0), packed_light(3, 8, 3e-5f),
                        packed_light(4, 0, 0)};
    std::uint32_t one = 0;
    halve_packed(four.data(), 2, 2, &one);
    CHECK(unpacked(one).x == 2.5);
    CHECK(unpacked(one).y == 4.0);
    const double dark = unpacked(packed_light(0, 0, 3e-5f)).z / 2;
    CHECK(unpacked(one).z <= dark);
    CHECK(unpacked(one).z > dark - std::ldexp(1.0, -19));
}

TEST_CASE("pack_sky: the texels of build_sky, and each level the halved one before it; threads do not matter") {
    constexpr int kFace = 256;
    const auto painter = SkyPainter::make({}, kAssets, kFace, 0);
    const auto floats = build_sky({}, kAssets, kFace);
    REQUIRE(painter);
    REQUIRE(floats);
    const auto all = levels_of(*painter, false);
    for (std::size_t face = 0; face < 6; ++face) {
        Level wanted;
        const std::vector<float>& data = floats->faces[face].data;
        for (std::size_t i = 0; i < data.size(); i += 3)
            wanted.push_back(packed_light(data[i], data[i + 1], data[i + 2]));
        CHECK(all[face][0] == wanted);
        for (std::size_t level = 1; level < all[face].size(); ++level) {
            const int width = kFace >> (level - 1);
            Level half(all[face][level].size());
            halve_packed(all[face][level - 1].data(), width, width, half.data());
            CHECK(all[face][level] == half);
        }
    }
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(levels_of(*painter, false) == all);
}

TEST_CASE("a face with a border goes on into its neighbours, and its own texels stay") {
    constexpr int kFace = 256, kBorder = kFace / kBorderOf, kWide = kFace + 2 * kBorder;
    const auto plain = SkyPainter::make({}, kAssets, kFace, 0), wide = SkyPainter::make({}, kAssets, kFace, kBorder);
    REQUIRE(plain);
    REQUIRE(wide);
    CHECK((bordered_size(kFace) >> (sky_levels(kFace, true) - 1)) ==
          17);  // 16 texels of the face and half a texel on each side
    const auto faces = levels_of(*plain, false), bordered = levels_of(*wide, true);
    for (std::size_t face = 0; face < 6; ++face)
        for (int y = 0; y < kFace; ++y) {
            const auto from = bordered[face][0].begin() + (y + kBorder) * kWide + kBorder;
            REQUIRE(std::equal(from, from + kFace, faces[face][0].begin() + y * kFace));
        }
}

TEST_CASE("a star beyond an edge or a corner of a face shines into its border") {
    constexpr int kFace = 256, kBorder = kFace / kBorderOf, kWide = kFace + 2 * kBorder;
    const double sigma = core_sigma(kFace), peak = star_flux(6.0) / (2.0 * M_PI * sigma * sigma);
    constexpr double kNormalisation = 0.02;  // of the peak: sums over texels differ from the integral by up to 1.2 %
    for (const Vec3 place :
         {Vec3{1.02, 1, 0.3}, Vec3{-1.02, 1, 0.3}, Vec3{0.3, 1, 1.02}, Vec3{0.3, 1, -1.02}, Vec3{1.05, 1, 1.05}}) {
        const Vec3 star = normalized(place);  // of the plane of +y beyond the face
        const StarPainter painter({{star, 6.0, 90}}, Mat3{}, 1.0, kFace, kBorder);
        SkyRows rows{2, kFace, kBorder, -kBorder, kWide, {}, {}};
        for (auto& plane : rows.planes) plane.assign(rows.texels(), 0.0f);
        painter.add(rows);
        double worst = 0.0, brightest = 0.0;
        for (int y = -kBorder; y < kFace + kBorder; ++y)
            for (int x = -kBorder; x < kFace + kBorder; ++x) {
                const auto at = static_cast<std::size_t>((y + kBorder) * kWide + x + kBorder);
                const double light =
                    0.2126 * rows.planes[0][at] + 0.7152 * rows.planes[1][at] + 0.0722 * rows.planes[2][at];
                const double angle =
                    angle_between(star, cube_direction(2, (x + 0.5) / kFace, (y + 0.5) / kFace)) / sigma;
                worst = std::max(worst, std::fabs(light - peak * std::exp(-0.5 * angle * angle)));
                brightest = std::max(brightest, light);
            }
        CAPTURE(place.x);
        CAPTURE(place.z);
        CHECK(worst < kNormalisation * peak);
        CHECK(brightest > 0.5 * peak);
    }
}
