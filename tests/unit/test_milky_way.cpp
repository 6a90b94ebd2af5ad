// The sky that ships against what is known of the sky: places and magnitudes of bright stars, places of nebulae and clusters, surface
// brightness. Coordinates are J2000, as tables of bright stars and of Messier and NGC objects have them, rounded.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "image/image_file.h"
#include "sky/milky_way.h"
#include "sky/star_catalogue.h"
#include "sky/star_light.h"
#include "support/folders.h"

using namespace nullscope;

namespace {

constexpr double kMilkyWayDegree = std::numbers::pi / 180.0;
const std::filesystem::path kSky = test::source_folder() / "assets" / "sky";

Vec3 milky_way_direction(double ra_degrees, double dec_degrees) {
    const double ra = ra_degrees * kMilkyWayDegree, dec = dec_degrees * kMilkyWayDegree;
    return {std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)};
}

struct BrightStar {
    const char* name;
    double ra_hours, ra_minutes, dec_degrees, dec_minutes, magnitude;
};
constexpr BrightStar kStars[] = {
    {"Sirius", 6, 45.15, -16, 42.97, -1.46},     {"Canopus", 6, 23.95, -52, 41.74, -0.74},
    {"Arcturus", 14, 15.67, 19, 10.95, -0.05},   {"Vega", 18, 36.94, 38, 47.02, 0.03},
    {"Capella", 5, 16.69, 45, 59.88, 0.08},      {"Rigel", 5, 14.54, -8, 12.10, 0.13},
    {"Procyon", 7, 39.30, 5, 13.50, 0.37},       {"Achernar", 1, 37.71, -57, 14.20, 0.46},
    {"Betelgeuse", 5, 55.17, 7, 24.42, 0.50},    {"Hadar", 14, 3.82, -60, 22.38, 0.61},
    {"Altair", 19, 50.78, 8, 52.10, 0.77},       {"Aldebaran", 4, 35.92, 16, 30.55, 0.86},
    {"Antares", 16, 29.41, -26, 25.92, 0.96},    {"Spica", 13, 25.19, -11, 9.68, 0.97},
    {"Pollux", 7, 45.32, 28, 1.57, 1.14},        {"Fomalhaut", 22, 57.65, -29, 37.33, 1.16},
    {"Deneb", 20, 41.43, 45, 16.82, 1.25},       {"Mimosa", 12, 47.72, -59, 41.32, 1.25},
    {"Regulus", 10, 8.37, 11, 58.03, 1.35},      {"Adhara", 6, 58.63, -28, 58.33, 1.50},
    {"Shaula", 17, 33.61, -37, 6.23, 1.63},      {"Gacrux", 12, 31.17, -57, 6.80, 1.63},
    {"Bellatrix", 5, 25.13, 6, 20.98, 1.64},     {"Elnath", 5, 26.29, 28, 36.45, 1.65},
    {"Miaplacidus", 9, 13.20, -69, 43.03, 1.68}, {"Alnilam", 5, 36.21, -1, 12.12, 1.69},
    {"Alnair", 22, 8.23, -46, 57.67, 1.74},      {"Alioth", 12, 54.03, 55, 57.58, 1.77},
    {"Dubhe", 11, 3.73, 61, 45.05, 1.79},        {"Mirfak", 3, 24.32, 49, 51.67, 1.80},
    {"Wezen", 7, 8.39, -26, 23.60, 1.84},        {"Kaus Australis", 18, 24.17, -34, 23.08, 1.85},
    {"Avior", 8, 22.51, -59, 30.57, 1.86},       {"Alkaid", 13, 47.54, 49, 18.80, 1.86},
    {"Sargas", 17, 37.32, -42, 59.87, 1.87},     {"Menkalinan", 5, 59.53, 44, 56.85, 1.90},
    {"Atria", 16, 48.66, -69, 1.67, 1.92},       {"Alhena", 6, 37.71, 16, 23.95, 1.92},
    {"Peacock", 20, 25.65, -56, 44.10, 1.94},    {"Mirzam", 6, 22.70, -17, 57.35, 1.98},
    {"Alphard", 9, 27.59, -8, 39.52, 1.98},      {"Polaris", 2, 31.82, 89, 15.85, 1.98},
    {"Hamal", 2, 7.17, 23, 27.75, 2.00},         {"Diphda", 0, 43.59, -17, 59.20, 2.02},
    {"Nunki", 18, 55.27, -26, 17.80, 2.05},      {"Mirach", 1, 9.73, 35, 37.23, 2.05},
    {"Alpheratz", 0, 8.39, 29, 5.43, 2.06},      {"Rasalhague", 17, 34.94, 12, 33.60, 2.08},
    {"Kochab", 14, 50.71, 74, 9.33, 2.08},       {"Denebola", 11, 49.06, 14, 34.32, 2.14}};

// What is found within `radius` degrees of a place: the middle of the light (or of its lack, or of what is red) that differs from the ring about
// it by more than 0.3 of the greatest difference.
enum class Seek { kLight, kDark, kRed };
struct Feature {
    const char* name;
    double ra, dec;
    Seek seek;
    double radius;
};
constexpr Feature kFeatures[] = {{"M31", 10.685, 41.269, Seek::kLight, 1.0},
                                 {"M33", 23.462, 30.660, Seek::kLight, 0.6},
                                 {"Orion nebula", 83.82, -5.39, Seek::kLight, 0.8},
                                 {"Flame nebula", 85.43, -1.90, Seek::kLight, 0.5},
                                 {"Large Magellanic Cloud", 80.9, -69.75, Seek::kLight, 2.0},
                                 {"30 Doradus", 84.68, -69.10, Seek::kLight, 0.5},
                                 {"Small Magellanic Cloud", 13.19, -72.83, Seek::kLight, 1.4},
                                 {"47 Tucanae", 6.02, -72.08, Seek::kLight, 0.5},
                                 {"omega Centauri", 201.70, -47.48, Seek::kLight, 0.5},
                                 {"Carina nebula", 161.0, -59.75, Seek::kLight, 0.8},
                                 {"Lagoon nebula", 270.92, -24.38, Seek::kLight, 0.6},
                                 {"Omega nebula", 275.20, -16.17, Seek::kLight, 0.4},
                                 {"Eagle nebula", 274.70, -13.80, Seek::kLight, 0.4},
                                 {"North America nebula", 314.7, 44.3, Seek::kRed, 1.0},
                                 {"California nebula", 60.5, 36.4, Seek::kRed, 0.8},
                                 {"Rosette nebula", 98.0, 5.0, Seek::kRed, 0.7},
                                 {"h and chi Persei", 34.9, 57.13, Seek::kLight, 0.6},
                                 {"M11 in the Scutum cloud", 282.77, -6.27, Seek::kLight, 0.4},
                                 {"Centaurus A", 201.365, -43.02, Seek::kLight, 0.4},
                                 {"NGC 6397", 265.17, -53.67, Seek::kLight, 0.3},
                                 {"NGC 6752", 287.7, -59.98, Seek::kLight, 0.3},
                                 {"M4", 245.90, -26.53, Seek::kLight, 0.4},
                                 {"M35", 92.25, 24.34, Seek::kLight, 0.4},
                                 {"Pipe nebula, its stem", 260.7, -26.8, Seek::kDark, 0.7}};

// The map as it is sampled: pixels with their light in S10 and their directions.
struct Map {
    Image<float> image;

    static Map load() {
        auto image = load_image(kSky / "milky-way.jpg");
        REQUIRE(image);
        REQUIRE(image->width == 2 * image->height);
        return {std::move(*image)};
    }
    double light(int x, int y) const {
        const float* c = image.at(x, y);
        return kMapWhite_S10 * (0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
    }
    double value(int x, int y, Seek seek) const {
        const float* c = image.at(x, y);
        if (seek == Seek::kRed) return kMapWhite_S10 * static_cast<double>(c[0] - c[1]);
        return seek == Seek::kLight ? light(x, y) : -light(x, y);
    }
    // what(x, y, direction, solid angle in square degrees) of every pixel within `radius` degrees.
    template <class What>
    void within(Vec3 centre, double radius, const What& what) const {
        const double pixel = 180.0 / image.height, middle = std::asin(centre.z) / kMilkyWayDegree;
        for (int y = 0; y < image.height; ++y) {
            const double dec = 90.0 - (y + 0.5) * pixel;
            if (std::fabs(dec - middle) > radius) continue;
            for (int x = 0; x < image.width; ++x) {
                const Vec3 d = milky_way_direction((0.5 - (x + 0.5) / image.width) * 360.0, dec);
                if (angle_between(d, centre) <= radius * kMilkyWayDegree)
                    what(x, y, d, pixel * pixel * std::cos(dec * kMilkyWayDegree));
            }
        }
    }
};

Vec3 found_place(const Map& map, const Feature& feature) {
    const Vec3 centre = milky_way_direction(feature.ra, feature.dec);
    std::vector<double> ring;
    double most = 0.0;
    map.within(centre, 2.0 * feature.radius, [&](int x, int y, Vec3 d, double) {
        if (angle_between(d, centre) > 1.2 * feature.radius * kMilkyWayDegree)
            ring.push_back(map.value(x, y, feature.seek));
    });
    std::nth_element(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2), ring.end());
    const double level = ring[ring.size() / 2];
    map.within(centre, feature.radius,
               [&](int x, int y, Vec3, double) { most = std::max(most, map.value(x, y, feature.seek) - level); });
    Vec3 sum{};
    map.within(centre, feature.radius, [&](int x, int y, Vec3 d, double area) {
        sum = sum + std::max(map.value(x, y, feature.seek) - level - 0.3 * most, 0.0) * area * d;
    });
    return normalized(sum);
}

// Surface brightness in V without stars brighter than 6.5, S10, about galactic coordinates: assets/sky/README.md says whence.
struct Field {
    const char* name;
    double longitude, latitude, radius, published_S10;
};
constexpr Field kFields[] = {{"Sagittarius, by the galactic centre", 0.0, -4.0, 4.0, 500.0},
                             {"Cygnus", 75.0, 1.0, 5.0, 280.0},
                             {"Carina", 288.0, -1.0, 5.0, 380.0},
                             {"anticentre", 180.0, 0.0, 6.0, 150.0},
                             {"north galactic pole", 0.0, 90.0, 15.0, 33.0}};
constexpr double kExcluded = 6.5;     // V of the brightest stars in these figures
constexpr double kUncertainty = 0.3;  // of published figures and of a picture that was made to be looked at

Vec3 galactic(double longitude, double latitude) {
    const Vec3 centre = milky_way_direction(266.405, -28.936), pole = milky_way_direction(192.8595, 27.1284);
    const double l = longitude * kMilkyWayDegree, b = latitude * kMilkyWayDegree;
    return std::cos(b) * std::cos(l) * centre + std::cos(b) * std::sin(l) * cross(pole, centre) + std::sin(b) * pole;
}

}  // namespace

TEST_CASE(
    "bright stars of the catalogue: 50 of them are where they are known to be, as bright as they are known to be") {
    const auto stars = load_stars(kSky / "stars.bin");
    REQUIRE(stars);
    CHECK(std::size(kStars) == 50);
    for (const BrightStar& known : kStars) {
        const Vec3 place =
            milky_way_direction(15.0 * (known.ra_hours + known.ra_minutes / 60.0),
                                known.dec_degrees + std::copysign(known.dec_minutes / 60.0, known.dec_degrees));
        const auto nearest = std::min_element(stars->begin(), stars->begin() + 300, [&](const Star& a, const Star& b) {
            return angle_between(a.direction, place) < angle_between(b.direction, place);
        });
        CAPTURE(std::string(known.name));
        CHECK(angle_between(nearest->direction, place) <
              0.02 * kMilkyWayDegree);                                  // proper motion, and binaries' middles
        CHECK(std::fabs(nearest->magnitude - known.magnitude) < 0.15);  // some vary
    }
}

TEST_CASE("the Milky Way map: 24 nebulae, clusters and galaxies within 0.3 degrees of their places") {
    const Map map = Map::load();
    for (const Feature& feature : kFeatures) {
        CAPTURE(std::string(feature.name));
        CHECK(angle_between(found_place(map, feature), milky_way_direction(feature.ra, feature.dec)) <
              0.3 * kMilkyWayDegree);
    }
}

TEST_CASE("the Milky Way map: with the catalogue's stars as bright as published, in five fields") {
    const Map map = Map::load();
    const auto stars = load_stars(kSky / "stars.bin");
    REQUIRE(stars);
    for (const Field& field : kFields) {
        const Vec3 centre = galactic(field.longitude, field.latitude);
        double light = 0.0, area = 0.0, drawn = 0.0;
        map.within(centre, field.radius, [&](int x, int y, Vec3, double square_degrees) {
            light += square_degrees * map.light(x, y), area += square_degrees;
        });
        for (const Star& star : *stars)
            if (star.magnitude > kExcluded && angle_between(star.direction, centre) < field.radius * kMilkyWayDegree)
                drawn += std::pow(10.0, -0.4 * (star.magnitude - 10.0)) / area;
        CAPTURE(std::string(field.name));
        CHECK(light / area == doctest::Approx(field.published_S10 - drawn).epsilon(kUncertainty));
    }
}

TEST_CASE("the Milky Way is painted in the unit of the stars: as much light as its map says") {
    constexpr int kFace = 64;
    const auto way = MilkyWay::load(kSky / "milky-way.jpg", Mat3{}, 1.0, kFace, 0);
    REQUIRE(way);
    const Map map = Map::load();
    double painted = 0.0, mapped = 0.0;
    for (int face = 0; face < 6; ++face) {
        SkyRows rows{face, kFace, 0, 0, kFace, {}, {}};
        for (auto& plane : rows.planes) plane.assign(rows.texels(), 0.0f);
        way->paint(rows);
        for (int y = 0; y < kFace; ++y)
            for (int x = 0; x < kFace; ++x) {
                const double s = 2.0 * (x + 0.5) / kFace - 1.0, t = 2.0 * (y + 0.5) / kFace - 1.0;
                const auto at = static_cast<std::size_t>(y * kFace + x);
                painted += (0.2126 * rows.planes[0][at] + 0.7152 * rows.planes[1][at] + 0.0722 * rows.planes[2][at]) *
                           std::pow(1.0 + s * s + t * t, -1.5) * 4.0 / (kFace * kFace);
            }
    }
    map.within({0, 0, 1}, 180.0, [&](int x, int y, Vec3, double square_degrees) {
        mapped += square_degrees * map.light(x, y) * star_flux(10.0);
    });
    constexpr double kSampling = 0.01;  // points 1.4 degrees apart, of a map of 0.18
    CHECK(painted == doctest::Approx(mapped).epsilon(kSampling));
}
