// Skies as textures hold them: packed texels, mip levels, borders.
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "image/half_levels.h"
#include "sky/cube.h"
#include "sky/packed_sky.h"
#include "sky/sky.h"
#include "support/costly.h"
#include "support/folders.h"

using namespace nullscope;

namespace {

const std::filesystem::path kAssets = test::source_folder() / "assets";

// By the definition of OpenGL 3.3 core, 2.1.3 and 2.1.4: five bits of exponent, bias 15, and the rest mantissa.
double unpacked(std::uint64_t bits, int mantissa_bits) {
    const auto exponent = static_cast<int>(bits >> mantissa_bits),
               mantissa = static_cast<int>(bits & ((1u << mantissa_bits) - 1));
    const double fraction = std::ldexp(mantissa, -mantissa_bits);
    return exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1.0 + fraction, exponent - 15);
}
Vec3 unpacked(std::uint32_t texel) {
    return {unpacked(texel & 0x7ff, 6), unpacked(texel >> 11 & 0x7ff, 6), unpacked(texel >> 22, 5)};
}

Vec3 unpacked(std::uint64_t texel) {
    return {unpacked(texel & 0x7fff, 10), unpacked(texel >> 16 & 0x7fff, 10), unpacked(texel >> 32 & 0x7fff, 10)};
}

template <class Texel>
using Level = std::vector<Texel>;

// By face and level; checks that every row comes once, in its order.
template <class Texel>
std::vector<std::vector<Level<Texel>>> levels_of(const SkyPainter& painter, double scale = 1.0) {
    const int levels = sky_levels(painter.face_size()), side = bordered_size(painter.face_size());
    std::vector<std::vector<Level<Texel>>> all(6, std::vector<Level<Texel>>(static_cast<std::size_t>(levels)));
    const SkyFormat format = sizeof(Texel) == 8 ? SkyFormat::kHalfFloats : SkyFormat::kSmallFloats;
    pack_sky(painter, {format, scale}, [&](const PackedRows& rows) {
        REQUIRE(rows.level < levels);
        Level<Texel>& level = all[static_cast<std::size_t>(rows.face)][static_cast<std::size_t>(rows.level)];
        REQUIRE(rows.width == side >> rows.level);
        REQUIRE(level.size() == static_cast<std::size_t>(rows.first * rows.width));
        const auto* texels = static_cast<const Texel*>(rows.texels);
        level.insert(level.end(), texels, texels + rows.count * rows.width);
    });
    for (const auto& face : all)
        for (int level = 0; level < levels; ++level)
            REQUIRE(face[static_cast<std::size_t>(level)].size() ==
                    static_cast<std::size_t>((side >> level) * (side >> level)));
    return all;
}

template <class Texel>
Vec3 mean_of(const Level<Texel>& level) {
    Vec3 sum;
    for (const Texel texel : level) sum = sum + unpacked(texel);
    return sum / static_cast<double>(level.size());
}

// Of the finest level, without the border.
template <class Texel>
Level<Texel> inner_of(const Level<Texel>& level, int face_size) {
    const int border = face_size / kBorderOf, wide = bordered_size(face_size);
    Level<Texel> inner;
    for (int y = border; y < border + face_size; ++y)
        inner.insert(inner.end(), level.begin() + y * wide + border, level.begin() + y * wide + border + face_size);
    return inner;
}

SkyPainter painter_of(int face_size) {
    auto painter = SkyPainter::make({}, kAssets, face_size, face_size / kBorderOf);
    REQUIRE(painter);
    return std::move(*painter);
}

double worst_relative(Vec3 got, Vec3 wanted) {
    return std::max(
        {std::fabs(got.x / wanted.x - 1.0), std::fabs(got.y / wanted.y - 1.0), std::fabs(got.z / wanted.z - 1.0)});
}

}  // namespace

TEST_CASE("packed light: the nearest number there is, never more than the largest, never what is no number") {
    for (double value = std::ldexp(1.0, -20); value < 64000.0; value *= 1.137) {
        const auto v = static_cast<float>(value);
        const Vec3 small = unpacked(packed_light(v, v, v)), half = unpacked(half_light(v, v, v));
        const auto near = [&](double kept, int bits) {
            CHECK(std::fabs(kept - v) <= 0.5 * std::max(std::ldexp(1.0, -14 - bits), std::ldexp(value, -bits)));
        };
        CAPTURE(value);
        near(small.x, 6), near(small.z, 5), near(half.x, 10);
        CHECK(small.y == small.x);
        CHECK(half.y == half.x);
        CHECK(half.z == half.x);
        const auto again = [](double kept) { return static_cast<float>(kept); };
        CHECK(packed_light(again(small.x), again(small.y), again(small.z)) == packed_light(v, v, v));
        CHECK(half_light(again(half.x), again(half.x), again(half.x)) == half_light(v, v, v));
    }
    constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
    CHECK(packed_light(0, -1, -kInfinity) == 0);
    CHECK(packed_light(kNan, kNan, kNan) == 0);
    CHECK(unpacked(half_light(kNan, -1, -kInfinity)) == Vec3{});
    CHECK(unpacked(packed_light(kInfinity, 1e30f, 1e6f)) == Vec3{65024, 65024, 64512});
    CHECK(unpacked(half_light(kInfinity, 65519, 65504)) == Vec3{65504, 65504, 65504});
    CHECK((half_light(1, 1, 1) >> 48) == 0x3c00);
}

TEST_CASE("packing_scale: the largest light stays below 65504, and the least keeps its digits") {
    for (const double largest : {1e-12, 3e-3, 1.0, 65504.0, 65505.0, 1e9}) {
        const double scale = packing_scale(SkyFormat::kHalfFloats, largest);
        CAPTURE(largest);
        CHECK(scale * largest <= 65504.0);
        CHECK(scale * largest > 0.49 * 65504.0);
        CHECK(std::log2(scale) == std::round(std::log2(scale)));
    }
    CHECK(packing_scale(SkyFormat::kHalfFloats, 0.0) == 1.0);
    CHECK(packing_scale(SkyFormat::kSmallFloats, 1e9) == 1.0);
}

TEST_CASE("pack_sky: the texels of build_sky, rounded; threads do not matter" * test::costly()) {
    constexpr int kFace = 256;
    const SkyPainter painter = painter_of(kFace);
    const auto floats = build_sky({}, kAssets, kFace);
    REQUIRE(floats);
    const auto small = levels_of<std::uint32_t>(painter);
    const auto half = levels_of<std::uint64_t>(painter, 2.0);
    for (std::size_t face = 0; face < 6; ++face) {
        Level<std::uint32_t> wanted;
        Level<std::uint64_t> wanted_half;
        const std::vector<float>& data = floats->faces[face].data;
        for (std::size_t i = 0; i < data.size(); i += 3) {
            wanted.push_back(packed_light(data[i], data[i + 1], data[i + 2]));
            wanted_half.push_back(half_light(2 * data[i], 2 * data[i + 1], 2 * data[i + 2]));
        }
        CHECK(inner_of(small[face][0], kFace) == wanted);
        CHECK(inner_of(half[face][0], kFace) == wanted_half);
    }
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(levels_of<std::uint32_t>(painter) == small);
}

TEST_CASE("every mip level of a sky has the light of the finest" * test::costly()) {
    constexpr double kHalf = 5e-4, kSmall = 0.016;  // half a step of what they are stored as: 2^-11 and 2^-6
    constexpr int kFace = 256;
    const SkyPainter painter = painter_of(kFace);
    const auto small = levels_of<std::uint32_t>(painter);
    const auto half = levels_of<std::uint64_t>(painter, 16.0);
    for (std::size_t face = 0; face < 6; ++face) {
        const Vec3 wanted = mean_of(half[face][0]);
        for (std::size_t level = 0; level < half[face].size(); ++level) {
            CAPTURE(face);
            CAPTURE(level);
            CHECK(worst_relative(mean_of(half[face][level]), wanted) < kHalf);
            CHECK(worst_relative(16.0 * mean_of(small[face][level]), wanted) < kSmall);
        }
    }
}

TEST_CASE(
    "half_levels: every level of an image of odd sides has its light, weighted by alpha, and 1 is for opaque pixels "
    "alone") {
    constexpr double kHalf = 5e-4;
    Image<float> image(65, 37, 4);
    double light = 0.0, cover = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float* pixel = image.at(x, y);
            pixel[0] = pixel[1] = pixel[2] = x == 64 ? 30.0f : 0.1f;
            pixel[3] = x % 3 == 0 ? 0.25f : 0.9999f;
            light += pixel[0] * pixel[3], cover += pixel[3];
        }
    const double pixels = 65.0 * 37.0;
    for (const HalfLevel& level : half_levels(image)) {
        Vec3 sum;
        for (std::size_t i = 0; i < level.rgba.size(); i += 4) {
            const double alpha = unpacked(std::uint64_t{level.rgba[i + 3]}, 10);
            sum = sum + Vec3{unpacked(std::uint64_t{level.rgba[i]}, 10) * alpha, alpha, 0};
            CHECK(level.rgba[i + 3] < 0x3c00);
        }
        const double count = static_cast<double>(level.rgba.size()) / 4.0;
        CAPTURE(level.width);
        // What is rounded is light and alpha.
        CHECK(std::fabs(sum.x / count / (light / pixels) - 1.0) < 2 * kHalf);
        CHECK(std::fabs(sum.y / count / (cover / pixels) - 1.0) < kHalf);
    }
}

TEST_CASE("a face with a border goes on into its neighbours, and its own texels stay") {
    constexpr int kFace = 256, kRows = 32;
    const int border = kFace / kBorderOf;
    const auto plain = SkyPainter::make({}, kAssets, kFace, 0);
    REQUIRE(plain);
    const SkyPainter wide = painter_of(kFace);
    SkyRows without, with;
    for (int face = 0; face < 6; ++face) {
        plain->paint(face, 0, kRows, without);
        wide.paint(face, 0, kRows, with);
        for (std::size_t c = 0; c < 3; ++c)
            for (int y = 0; y < kRows; ++y) {
                const auto from = without.planes[c].begin() + y * kFace;
                REQUIRE(std::equal(from, from + kFace, with.planes[c].begin() + y * bordered_size(kFace) + border));
            }
    }
}

TEST_CASE(
    "sizes of skies: half a texel of border at the level of 16, one texel at the last, textures that a driver has") {
    for (const int face : {256, 1024, 4096}) {
        CHECK(bordered_size(face) / (face / 16) == 17);
        CHECK((bordered_size(face) >> (sky_levels(face) - 1)) == 1);
        CHECK(largest_face(bordered_size(face)) == face);
        CHECK(largest_face(bordered_size(face) - 1) == face / 2);
    }
    CHECK(largest_face(16384) == 8192);
    CHECK(largest_face(2048) == 1024);
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
