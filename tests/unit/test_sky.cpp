#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "base/atomic_file.h"
#include "image/image_file.h"
#include "sky/milky_way.h"
#include "sky/packed_sky.h"
#include "sky/sky.h"
#include "sky/sky_painter.h"
#include "sky/star_catalogue.h"
#include "sky/star_light.h"
#include "support/costly.h"
#include "support/depth.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace nullscope;
namespace fs = std::filesystem;

namespace {

constexpr double kSkyPi = std::numbers::pi;
constexpr double kSkyDegree = kSkyPi / 180.0;
constexpr double kSkyRounding = 1e-14;  // a division and a subtraction of numbers of order 1
constexpr double kFluxError = 1e-5;     // texels are sums of single-precision numbers
constexpr float kStripeError = 0.1f;   // what a pattern of period two pixels, the worst, leaves of its amplitude of 0.5
constexpr double kPixelError = 0.006;  // of an image of 8 bits: half a code near white is 0.0045 in linear light
constexpr int kSize = 256;             // of faces: quick, and one texel is 0.35 degrees

const fs::path kSkyAssets = test::source_folder() / "assets";

Vec3 sky_direction(double ra_degrees, double dec_degrees) {
    const double ra = ra_degrees * kSkyDegree, dec = dec_degrees * kSkyDegree;
    return {std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)};
}

SkyCube black(int size) {
    SkyCube sky;
    sky.size = size;
    for (Image<float>& face : sky.faces) face = Image<float>(size, size, 3);
    return sky;
}

// Faces that paint(rows) fills, all rows of a face at once.
template <class Paint>
SkyCube faces_of(int size, const Paint& paint) {
    SkyCube sky = black(size);
    for (int face = 0; face < 6; ++face) {
        SkyRows rows{face, size, 0, 0, size, {}, {}};
        for (auto& plane : rows.planes) plane.assign(rows.texels(), 0.0f);
        paint(rows);
        float* out = sky.faces[static_cast<std::size_t>(face)].data.data();
        for (std::size_t i = 0; i < rows.texels(); ++i)
            for (const auto& plane : rows.planes) *out++ = plane[i];
    }
    return sky;
}

SkyCube star_faces(int size, const std::vector<Star>& stars) {
    const StarPainter painter(stars, Mat3{}, 1.0, size, 0);
    return faces_of(size, [&](SkyRows& rows) { painter.add(rows); });
}

double luminance(Vec3 c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

// Integral of luminance over the sphere: texel by texel with its solid angle.
double total_flux(const SkyCube& sky) {
    double sum = 0.0;
    for (const Image<float>& face : sky.faces)
        for (int y = 0; y < sky.size; ++y)
            for (int x = 0; x < sky.size; ++x) {
                const double s = 2.0 * (x + 0.5) / sky.size - 1.0, t = 2.0 * (y + 0.5) / sky.size - 1.0;
                const float* c = face.at(x, y);
                sum += luminance({c[0], c[1], c[2]}) * std::pow(1.0 + s * s + t * t, -1.5);
            }
    return sum * 4.0 / (static_cast<double>(sky.size) * sky.size);
}

// The brightest texel within a radius.
double brightest_near(const SkyCube& sky, Vec3 centre, double radius_degrees) {
    double best = 0.0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < sky.size; ++y)
            for (int x = 0; x < sky.size; ++x) {
                const Vec3 d = cube_direction(face, (x + 0.5) / sky.size, (y + 0.5) / sky.size);
                if (angle_between(d, centre) > radius_degrees * kSkyDegree) continue;
                const float* c = sky.faces[static_cast<std::size_t>(face)].at(x, y);
                best = std::max(best, luminance({c[0], c[1], c[2]}));
            }
    return best;
}

template <class Pixel>
void save_image(const fs::path& path, int width, int height, const Pixel& pixel) {
    Image<unsigned char> image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3 c = pixel((x + 0.5) / width, (y + 0.5) / height);
            unsigned char* out = image.at(x, y);
            for (const double value : {c.x, c.y, c.z})
                *out++ = static_cast<unsigned char>(255.0f * srgb_from_linear(static_cast<float>(value)) + 0.5f);
        }
    REQUIRE(save_png(path, image));
}

// A smooth colour for every direction, so that any mix-up of axes or sides shows.
Vec3 colour_of(Vec3 d) {
    d = normalized(d);
    return 0.5 * (Vec3{1, 1, 1} + Vec3{d.x, d.y, d.z} * 0.8);
}

void check_colours(const SkyCube& sky, const Mat3& world_from_sky, double tolerance) {
    for (int i = 0; i < 500; ++i) {  // a spiral over the sphere
        const double z = 1.0 - 2.0 * (i + 0.5) / 500.0, phi = 2.4 * i;
        const Vec3 d{std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z};
        CHECK(length(sample_sky(sky, world_from_sky * d) - colour_of(d)) < tolerance);
    }
}

}  // namespace

TEST_CASE("stars: a catalogue that was not fetched is refused with how to fetch it, and one that was is read") {
    const TemporaryFolder folder("catalogue");
    std::filesystem::create_directories(folder.path / "sky");
    const auto refused = load_stars(StarCatalogue::kTycho2, folder.path);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message().find("scripts/fetch_stars.py") != std::string::npos);
    std::filesystem::copy_file(kSkyAssets / "sky" / "stars.bin", folder.path / "sky" / "stars-tycho-2.bin");
    const auto read = load_stars(StarCatalogue::kTycho2, folder.path);
    REQUIRE(read);
    CHECK(read->size() == load_stars(StarCatalogue::kHipparcos, kSkyAssets)->size());
}

TEST_CASE("cube_direction and cube_position agree with OpenGL 3.3 table 3.19") {
    struct Row {
        int face;
        Vec3 centre, to_right, down;
    };  // direction of growing s and t
    // s_c, t_c of the table: +x (-rz, -ry), -x (+rz, -ry), +y (+rx, +rz), -y (+rx, -rz), +z (+rx, -ry), -z (-rx, -ry).
    const Row rows[] = {{0, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {1, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                        {2, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {3, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                        {4, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {5, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
    for (const Row& row : rows)
        for (const double u : {0.001, 0.25, 0.5, 0.875, 0.999})
            for (const double v : {0.001, 0.125, 0.5, 0.75, 0.999}) {
                const Vec3 d = row.centre + (2 * u - 1) * row.to_right + (2 * v - 1) * row.down;
                CHECK(length(cube_direction(row.face, u, v) - d) < kSkyRounding);
                const CubePosition p = cube_position(3.7 * d);
                CHECK(p.face == row.face);
                CHECK(std::fabs(p.u - u) < kSkyRounding);
                CHECK(std::fabs(p.v - v) < kSkyRounding);
            }
}

TEST_CASE("sample_sky: texel centres exactly, bilinear between, clamped at the edge of a face") {
    SkyCube sky = black(16);
    for (int x = 0; x < 16; ++x)
        for (int y = 0; y < 16; ++y) sky.faces[2].at(x, y)[1] = static_cast<float>(x + 100 * y);
    const auto sample = [&](double x, double y) { return sample_sky(sky, cube_direction(2, x / 16, y / 16)).y; };
    CHECK(sample(3.5, 7.5) == doctest::Approx(703));
    CHECK(sample(4.25, 7.5) == doctest::Approx(703.75));
    CHECK(sample(4.0, 8.0) == doctest::Approx(753.5));
    CHECK(sample(0.01, 15.99) == doctest::Approx(1500));
}

TEST_CASE("a star's flux does not depend on where it lies, nor on the size of the face" * test::costly()) {
    const double texel = 2.0 / kSize;
    const double off = 0.37 * texel;
    const Vec3 places[] = {
        {1, off, -off},     {1, texel / 2, texel / 2}, {1, 1, off},        {1, 1 + off, 1}, {1, 1, 1},
        {-1, -1, -1 + off}, {0.3, 0.55, -1},           {-1, 1 - off, 0.2}, {off, -off, 1},  {off, -1, 1},
        {-0.99, 1, -0.98}};
    for (const double magnitude : {6.0, 1.0}) {  // without and with a halo
        const double reference = core_sigma(kReferenceFace);
        const double expected =
            kPeakOfMagnitude5 * 2.0 * kSkyPi * reference * reference * std::pow(10.0, -0.4 * (magnitude - 5.0));
        for (const int size : {64, kSize, 512, 1024}) {
            test::Selection selection(size > kSize ? 4 : 1);
            for (const Vec3& place : places) {
                if (!selection.takes_next()) continue;
                CAPTURE(size);
                CAPTURE(place.x);
                CAPTURE(place.y);
                CAPTURE(place.z);
                const SkyCube sky = star_faces(size, {{normalized(place), magnitude, 90}});
                CHECK(std::fabs(total_flux(sky) / expected - 1.0) < kFluxError);  // Approx is absolute below 1
            }
        }
    }
}

TEST_CASE("a star's radiance depends on the angle to it only") {
    constexpr double kNormalisation = 0.02;  // of the peak: sums over texels differ from the integral by up to 1.2 %
    const double reference = core_sigma(kReferenceFace), sigma = core_sigma(kSize);
    const double peak = kPeakOfMagnitude5 * std::pow(10.0, -0.4) * reference * reference / (sigma * sigma);
    for (const Vec3 place : {Vec3{1, 0.001, 0.002}, Vec3{1, 1, 0.3}, Vec3{-1, 1, -1}, Vec3{0.98, -0.97, 1}}) {
        const SkyCube sky = star_faces(kSize, {{normalized(place), 6.0, 90}});
        double worst = 0.0;
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < kSize; ++y)
                for (int x = 0; x < kSize; ++x) {
                    const Vec3 d = cube_direction(face, (x + 0.5) / kSize, (y + 0.5) / kSize);
                    const double angle = angle_between(d, place) / sigma;
                    const float* c = sky.faces[static_cast<std::size_t>(face)].at(x, y);
                    worst = std::max(worst,
                                     std::fabs(luminance({c[0], c[1], c[2]}) - peak * std::exp(-0.5 * angle * angle)));
                }
        CHECK(worst < kNormalisation * peak);
    }
}

TEST_CASE("star colours: blue, white, red, of luminance 1") {
    constexpr double kRounded = 1e-4;  // Rec. 709's luminance has four digits here
    for (const double bv : {-0.3, 0.0, 0.65, 1.8, 5.0})
        CHECK(luminance(star_colour(bv)) == doctest::Approx(1.0).epsilon(kRounded));
    const Vec3 hot = star_colour(-0.2), sun = star_colour(0.65), cool = star_colour(1.85);
    CHECK(hot.z > 1.3 * hot.x);
    CHECK(sun.x == doctest::Approx(sun.z).epsilon(0.25));
    CHECK(cool.x > 3.0 * cool.z);
}

TEST_CASE("the catalogue holds Hipparcos, brightest first") {
    const auto stars = load_stars(kSkyAssets / "sky" / "stars.bin");
    REQUIRE(stars);
    REQUIRE(stars->size() == 118216);
    CHECK((*stars)[0].magnitude == doctest::Approx(-1.44));
    CHECK(angle_between((*stars)[0].direction, sky_direction(101.287, -16.716)) < 0.01 * kSkyDegree);  // Sirius
    CHECK(std::fabs(b_minus_v(static_cast<int>((*stars)[0].colour_code)) - 0.009) < 0.006);
    for (std::size_t i = 1; i < stars->size(); ++i) REQUIRE((*stars)[i - 1].magnitude <= (*stars)[i].magnitude);
}

TEST_CASE("damaged catalogues are errors") {
    const TemporaryFolder folder("stars");
    const std::string good = read_text(kSkyAssets / "sky" / "stars.bin")->substr(0, 16 + 80);
    const auto refused = [&](const std::string& bytes) {
        REQUIRE(write_text_atomically(folder.path / "stars.bin", bytes));
        return !load_stars(folder.path / "stars.bin");
    };
    std::string ten = good;
    ten.replace(12, 4, std::string("\x0a\0\0\0", 4));
    CHECK_FALSE(refused(ten));
    CHECK(refused(good));  // count of all, ten present
    CHECK(refused(""));
    CHECK(refused(ten.substr(0, 15)));
    CHECK(refused(ten + "x"));
    ten[8] = 2;
    CHECK(refused(ten));
    CHECK_FALSE(load_stars(folder.path / "none"));
    CHECK_FALSE(build_sky({}, folder.path / "none", 64));
}

TEST_CASE("the star sky is not mirrored and turns with yaw and tilt") {
    SkySpec spec;
    const auto sky = build_sky(spec, kSkyAssets, kSize);
    REQUIRE(sky);
    const Vec3 betelgeuse = sky_direction(88.793, 7.407), rigel = sky_direction(78.634, -8.202);
    const Vec3 sirius = sky_direction(101.287, -16.716), acrux = sky_direction(186.650, -63.099);
    const double faint = luminance(sample_sky(*sky, sky_direction(20.0, -5.0)));
    for (const Vec3& star : {betelgeuse, rigel, sirius, acrux}) {
        CHECK(brightest_near(*sky, star, 0.3) > 20.0 * faint);
        CHECK(brightest_near(*sky, star, 0.3) > 2.0 * brightest_near(*sky, {star.x, -star.y, star.z}, 0.3));
    }
    CHECK(brightest_near(*sky, sirius, 0.3) > brightest_near(*sky, rigel, 0.3));
    const Vec3 red = sample_sky(*sky, betelgeuse), blue = sample_sky(*sky, rigel);
    CHECK(red.x > 1.5 * red.z);
    CHECK(blue.z > blue.x);
    // Looking at the belt with north up, right is west: Betelgeuse upper left, Rigel lower right.
    const Vec3 belt = sky_direction(84.05, -1.2), west = cross(belt, {0, 0, 1});
    CHECK(dot(betelgeuse - rigel, west) < 0.0);
    CHECK(betelgeuse.z > rigel.z);

    spec.yaw = 40.0 * kSkyDegree;
    spec.tilt = -25.0 * kSkyDegree;
    const auto turned = build_sky(spec, kSkyAssets, kSize);
    REQUIRE(turned);
    const double ct = std::cos(spec.tilt), st = std::sin(spec.tilt), cy = std::cos(spec.yaw), sy = std::sin(spec.yaw);
    const Vec3 tilted{sirius.x, ct * sirius.y - st * sirius.z, st * sirius.y + ct * sirius.z};
    const Vec3 there{cy * tilted.x - sy * tilted.y, sy * tilted.x + cy * tilted.y, tilted.z};
    const double ratio = brightest_near(*turned, there, 0.3) / brightest_near(*sky, sirius, 0.3);
    CHECK(ratio > 0.6);  // its place within a texel changes the brightest one
    CHECK(ratio < 1.6);
}

TEST_CASE("the Milky Way is bright towards the galactic centre, dark at the poles and has no seams") {
    constexpr int kFine = 1024;  // texels of half a pixel of the map
    const auto haze = MilkyWay::load(kSkyAssets / "sky" / "milky-way.jpg", Mat3{}, 1.0, kFine, 0);
    REQUIRE(haze);
    const SkyCube sky = faces_of(kFine, [&](SkyRows& rows) { haze->paint(rows); });
    double peak = 0.0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < kFine; ++y)
            for (int x = 0; x < kFine; ++x) {
                const float* c = sky.faces[static_cast<std::size_t>(face)].at(x, y);
                peak = std::max(peak, luminance({c[0], c[1], c[2]}));
            }
    CHECK(peak > 0.8 * kMapWhite_S10 * radiance_of_s10());
    const double centre = luminance(sample_sky(sky, sky_direction(271.5, -29.5)));  // the Large Sagittarius star cloud
    CHECK(centre > 0.5 * peak);
    for (const double side : {1.0, -1.0})
        CHECK(luminance(sample_sky(sky, side * sky_direction(192.86, 27.13))) < 0.04 * centre);
    const double step = 0.5 / kFine;  // half a texel either side of the edge between two faces
    for (double t = -0.99; t < 1.0; t += 0.02)
        for (const auto& [a, b] : {std::pair{Vec3{1, 1 - step, t}, Vec3{1 - step, 1, t}},
                                   std::pair{Vec3{t, -1, step - 1}, Vec3{t, step - 1, -1}}})
            CHECK(length(sample_sky(sky, a) - sample_sky(sky, b)) < 0.05 * peak);  // its steepest slope a texel
}

TEST_CASE("equirectangular images: every direction gets its colour, also rotated, finer and coarser than the face") {
    const TemporaryFolder folder("equirect");
    SkySpec spec;
    spec.kind = SkyKind::kImage;
    spec.image = folder.path / "sky.png";
    spec.yaw = 0.7;
    spec.tilt = 0.4;
    const double cy = std::cos(0.7), sy = std::sin(0.7), ct = std::cos(0.4), st = std::sin(0.4);
    const Mat3 rotation = Mat3{{cy, sy, 0}, {-sy, cy, 0}, {0, 0, 1}} * Mat3{{1, 0, 0}, {0, ct, st}, {0, -st, ct}};
    for (const int width : {512, 2048}) {
        save_image(spec.image, width, width / 2, [](double u, double v) {
            const double phi = (0.5 - u) * 2.0 * kSkyPi, theta = v * kSkyPi;  // middle: 0, growing to the left
            return colour_of({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
        });
        const auto sky = build_sky(spec, {}, 128);
        REQUIRE(sky);
        check_colours(*sky, rotation, 2.0 * kPixelError);  // three channels, and a texel's slope
    }
    spec.brightness = 0.25;
    const auto dark = build_sky(spec, {}, 64);
    REQUIRE(dark);
    CHECK(length(sample_sky(*dark, {1, 2, 3}) - 0.25 * colour_of(transposed(rotation) * Vec3{1, 2, 3})) < kPixelError);
}

TEST_CASE("an image finer than the face is averaged, not aliased") {
    const TemporaryFolder folder("fine");
    SkySpec spec;
    spec.kind = SkyKind::kImage;
    spec.image = folder.path / "stripes.png";
    save_image(spec.image, 1024, 512, [](double u, double) {
        return static_cast<int>(u * 1024) % 2 ? Vec3{1, 1, 1} : Vec3{};
    });
    const auto sky = build_sky(spec, {}, 32);
    REQUIRE(sky);
    for (const float value : sky->faces[0].data) CHECK(std::fabs(value - 0.5f) < kStripeError);
}

TEST_CASE("band and caps join into one sphere") {
    const TemporaryFolder folder("caps");
    SkySpec spec;
    spec.kind = SkyKind::kImage;
    spec.mapping = SkyMapping::kBandAndCaps;
    spec.band_latitude = 0.6;
    spec.image = folder.path / "band.png";
    spec.north_cap = folder.path / "north.png";
    spec.south_cap = folder.path / "south.png";
    const auto at = [](double phi, double beta) {
        return colour_of({std::cos(beta) * std::cos(phi), std::cos(beta) * std::sin(phi), std::sin(beta)});
    };
    save_image(spec.image, 512, 128, [&](double u, double v) { return at((0.5 - u) * 2 * kSkyPi, 0.6 * (1 - 2 * v)); });
    for (const double side : {1.0, -1.0})  // left is azimuth pi/2; azimuth 0 is below in the north, above in the south
        save_image(side > 0 ? spec.north_cap : spec.south_cap, 256, 256, [&](double u, double v) {
            const double x = 2 * u - 1, y = 2 * v - 1;
            return at(std::atan2(-x, side * y), side * (kSkyPi / 2 - std::hypot(x, y) * (kSkyPi / 2 - 0.6)));
        });
    const auto sky = build_sky(spec, {}, 128);
    REQUIRE(sky);
    check_colours(*sky, Mat3{}, 2.5 * kPixelError);
    spec.south_cap = folder.path / "missing.png";
    CHECK_FALSE(build_sky(spec, {}, 64));
    spec.band_latitude = 2.0;
    CHECK_FALSE(build_sky(spec, {}, 64));
}

TEST_CASE("build_sky: black is black, bad sizes and images are errors, threads do not matter") {
    SkySpec spec;
    spec.kind = SkyKind::kBlack;
    const auto night = build_sky(spec, {}, 16);
    REQUIRE(night);
    CHECK(total_flux(*night) == 0.0);
    for (const int size : {-16, 0, 8, 100, 16384}) CHECK_FALSE(build_sky(spec, {}, size));
    spec.kind = SkyKind::kImage;
    spec.image = kSkyAssets / "sky" / "stars.bin";
    const auto wrong = build_sky(spec, {}, 16);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().kind == ErrorKind::kBadInput);

    const auto many = build_sky({}, kSkyAssets, 128);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto single = build_sky({}, kSkyAssets, 128);
    REQUIRE(many);
    REQUIRE(single);
    for (std::size_t face = 0; face < 6; ++face) CHECK(many->faces[face].data == single->faces[face].data);
    for (const Image<float>& face : many->faces)
        for (const float value : face.data) REQUIRE(std::isfinite(value));
}
