// Several frequencies of matter: how files name them, which of them a picture shows, Faraday's rotation between them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "compare/rotation_measure.h"
#include "plan/effects.h"
#include "scene/known_object.h"
#include "scene/medium_bands.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"

using namespace nullscope;

namespace {

Result<Scene> matter(const std::string& keys) {
    return parse_scene("[object]\nname = \"m87\"\n[sky]\nkind = \"black\"\n[medium]\nkind = \"flow\"\n" + keys,
                       "bands.toml", {});
}

bool as_colours(const Scene& scene) { return effect_set(required_effects(scene)).contains(Effect::kMediumBands); }

// One pixel whose angle is `start` + rm lambda^2, plus what each band has more.
std::vector<BandPicture> turned(const std::vector<double>& frequencies, double start, double rm) {
    std::vector<BandPicture> bands;
    for (const double frequency : frequencies) {
        const double wavelength = kLight_m_s / (1e9 * frequency), angle = start + rm * wavelength * wavelength;
        BandPicture band{frequency, Image<float>(1, 1, 1), Image<float>(1, 1, 4)};
        band.stokes.data = {1.0f, static_cast<float>(0.5 * std::cos(2 * angle)),
                            static_cast<float>(0.5 * std::sin(2 * angle)), 0.0f};
        bands.push_back(std::move(band));
    }
    return bands;
}

}  // namespace

TEST_CASE("medium bands: a number, or several, read and written") {
    const auto one = matter("frequency = 86\n"), alone = matter("frequency = [86]\n"),
               several = matter("frequency = [86, 230.5, 345]\n"),
               second = matter("frequency = [86, 230.5]\nshown_band = 2\n");
    REQUIRE(one);
    REQUIRE(alone);
    REQUIRE(several);
    REQUIRE(second);
    CHECK(one->medium == alone->medium);
    CHECK_FALSE(has_bands(*one));
    CHECK(several->medium->bands_GHz == std::vector<double>{86, 230.5, 345});
    CHECK(several->medium->frequency_GHz == 86);
    CHECK(second->medium->frequency_GHz == 230.5);
    CHECK(scene_file_text(*one, {}).find("frequency = 86\n") != std::string::npos);
    CHECK(scene_file_text(*several, {}).find("frequency = [86, 230.5, 345]\n") != std::string::npos);
    for (const auto& scene : {several, second}) {
        const auto again = parse_scene(scene_file_text(*scene, {}), "again.toml", {});
        REQUIRE(again);
        CHECK(again->medium == scene->medium);
    }
    CHECK(as_colours(*several));
    CHECK_FALSE(as_colours(*second));
    CHECK_FALSE(as_colours(*one));
    const auto polarised = matter(
        "frequency = [86, 230]\nemission = \"synchrotron\"\nfield_direction = \"east\"\npolarisation = \"on\"\n");
    REQUIRE(polarised);
    CHECK(has_bands(*polarised));
    CHECK_FALSE(as_colours(*polarised));  // one march each
    CHECK(typed_numbers({86, 230.5}) == "86, 230.5");
    std::vector<double> typed = {86};
    CHECK(take_typed_numbers(" 86 ,230.5", typed));
    CHECK(typed == std::vector<double>{86, 230.5});
    CHECK_FALSE(take_typed_numbers("86, 230.5", typed));
    CHECK(take_typed_numbers("86, x", typed));
    CHECK(std::isnan(typed.back()));
}

TEST_CASE("medium bands: which a picture shows, and by what names files have them") {
    MediumSpec medium;
    medium.bands_GHz = {86, 230};
    CHECK(bands_as_colours(medium) == std::vector<std::size_t>{0, 1});
    medium.bands_GHz = {22, 43, 86, 230, 345};
    CHECK(bands_as_colours(medium) == std::vector<std::size_t>{0, 2, 4});
    for (const std::size_t count : {2, 3}) {  // light that is equal in all is white
        Vec3 sum;
        for (std::size_t i = 0; i < count; ++i) sum = sum + colour_of_band(i, count);
        CHECK(length(sum - Vec3{1, 1, 1}) == 0.0);
    }
    CHECK(band_name(86) == "86GHz");
    CHECK(band_name(86.268) == "86,268GHz");
    CHECK(frequency_words(medium) == "22, 43, 86, 230, 345 GHz");
}

TEST_CASE("rotation measure: of angles that grow with the squared wavelength, to whole numbers of half turns") {
    constexpr double kRounding = 1e-5;  // of floats
    for (const double rm : {3e4, -7e4}) {
        const auto bands = turned({86, 230, 345}, 0.7, rm);
        const auto found = rotation_measures(bands);
        REQUIRE(found.size() == 2);
        for (const RotationMeasure& one : found) CHECK(one.rad_m2 == doctest::Approx(rm).epsilon(kRounding));
        CHECK(rotation_measure_image(bands).data[0] == doctest::Approx(rm).epsilon(kRounding));
        CHECK(found[0].low_GHz == 86);
        CHECK(found[1].high_GHz == 345);
    }
    const double square = std::pow(kLight_m_s / 86e9, 2) - std::pow(kLight_m_s / 230e9, 2), far = 2e6;
    const auto wrapped = rotation_measures(turned({86, 230}, 0.2, far));
    REQUIRE(wrapped.size() == 1);
    CHECK(wrapped[0].step_rad_m2 == doctest::Approx(M_PI / square).epsilon(kRounding));
    const double turns = (far - wrapped[0].rad_m2) / wrapped[0].step_rad_m2;
    CHECK(std::abs(turns - std::round(turns)) < 1e-4);
    CHECK(std::abs(wrapped[0].rad_m2) <= 0.5 * wrapped[0].step_rad_m2);
    CHECK(words_of({86, 230, -41000.0, 3e5}) == "RM 86-230 GHz -4.1e+04 rad/m^2 (+ n 3e+05)");
    auto dark = turned({86, 230}, 0.2, 1e4);
    dark[1].stokes.data = {1.0f, 0.0f, 0.0f, 0.0f};
    CHECK(rotation_measures(dark).empty());
    CHECK(rotation_measure_image(dark).data[0] == 0.0f);
    CHECK(rotation_measures(turned({86}, 0.2, 1e4)).empty());
}
