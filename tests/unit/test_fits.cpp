// FITS files, read by the standard's own words: cards of 80 characters, blocks of 2880 bytes, big-endian floats, the bottom row first.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "command/fits_header.h"
#include "image/image_file.h"
#include "scene/projection.h"
#include "scene/scene.h"
#include "support/temporary_folder.h"

using namespace nullscope;

namespace {

constexpr std::size_t kBlock = 2880, kCard = 80;

struct Fits {
    std::map<std::string, std::string> cards;  // text without its quotes
    std::vector<std::string> comments;
    std::vector<float> values;
};

std::string value_of(const std::string& card) {
    const std::string value = card.substr(10);
    if (!value.starts_with('\'')) return trim(value.substr(0, value.find(" /")));
    return trim(value.substr(1, value.find('\'', 1) - 1));
}

Fits read_fits(const std::filesystem::path& path) {
    const auto bytes = read_text(path);
    REQUIRE(bytes);
    REQUIRE(bytes->size() % kBlock == 0);
    Fits fits;
    std::size_t at = 0;
    for (bool ended = false; !ended; at += kCard) {
        REQUIRE(at + kCard <= bytes->size());
        const std::string card = bytes->substr(at, kCard), key = trim(card.substr(0, 8));
        for (const char c : card) REQUIRE((c >= 0x20 && c < 0x7f));
        ended = key == "END";
        if (card.substr(8, 2) == "= ") {
            CHECK_MESSAGE(!fits.cards.contains(key), key);
            fits.cards[key] = value_of(card);
        } else if (key == "COMMENT") {
            fits.comments.push_back(trim(card.substr(8)));
        }
    }
    at = (at + kBlock - 1) / kBlock * kBlock;
    std::size_t count = 1;
    for (int axis = 1; axis <= std::stoi(fits.cards["NAXIS"]); ++axis)
        count *= std::stoul(fits.cards[fmt::format("NAXIS{}", axis)]);
    REQUIRE(bytes->size() == at + (count * sizeof(float) + kBlock - 1) / kBlock * kBlock);
    for (std::size_t i = 0; i < count; ++i, at += 4) {
        std::uint32_t bits = 0;
        for (std::size_t byte = 0; byte < 4; ++byte) bits = bits << 8 | static_cast<unsigned char>((*bytes)[at + byte]);
        fits.values.push_back(std::bit_cast<float>(bits));
    }
    return fits;
}

Image<float> numbered(int width, int height, int channels) {
    Image<float> image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = 0.1f + static_cast<float>(i) * 1.7e-3f;
    return image;
}

}  // namespace

TEST_CASE("fits: four Stokes planes, bit by bit, the bottom row first") {
    const TemporaryFolder folder("fits");
    const Image<float> image = numbered(53, 31, 4);
    REQUIRE(save_fits(folder.path / "a.fits", image, {}));
    const Fits fits = read_fits(folder.path / "a.fits");
    CHECK(fits.cards.at("SIMPLE") == "T");
    CHECK(fits.cards.at("BITPIX") == "-32");
    CHECK(fits.cards.at("NAXIS") == "3");
    CHECK(fits.cards.at("NAXIS1") == "53");
    CHECK(fits.cards.at("NAXIS2") == "31");
    CHECK(fits.cards.at("NAXIS3") == "4");
    CHECK(fits.cards.at("CTYPE3") == "STOKES");
    CHECK(fits.cards.at("BUNIT").empty());
    CHECK_FALSE(fits.cards.contains("DATE"));
    std::size_t at = 0;
    int differ = 0;
    for (int c = 0; c < 4; ++c)
        for (int y = image.height - 1; y >= 0; --y)
            for (int x = 0; x < image.width; ++x) differ += fits.values[at++] != image.at(x, y)[c];
    CHECK(differ == 0);
    CHECK(folder.files() == 1);
    const auto first = read_text(folder.path / "a.fits");
    REQUIRE(save_fits(folder.path / "a.fits", image, {}));
    CHECK(*read_text(folder.path / "a.fits") == *first);
}

TEST_CASE("fits: one channel is one plane, with its unit and cards of every kind") {
    const TemporaryFolder folder("fits-cards");
    FitsHeader header{"Jy/pixel", "flux density", {}, {"One line.", "µ and \n are no ASCII"}};
    header.cards = {{"FREQ", 230e9, "[Hz] observed"},
                    {"TINY", -7.81221265581954e-11, ""},
                    {"FRAME", 12LL, "of a sequence"},
                    {"OBJECT", "Sagittarius A★", ""},
                    {"LONG", std::string(300, 'w'), "more than a card"}};
    REQUIRE(save_fits(folder.path / "a.fits", numbered(7, 5, 1), header));
    const Fits fits = read_fits(folder.path / "a.fits");
    CHECK(fits.cards.at("NAXIS") == "2");
    CHECK_FALSE(fits.cards.contains("CTYPE3"));
    CHECK(fits.cards.at("BUNIT") == "Jy/pixel");
    CHECK(std::stod(fits.cards.at("FREQ")) == 230e9);
    CHECK(std::stod(fits.cards.at("TINY")) == doctest::Approx(-7.81221265581954e-11).epsilon(1e-14));
    CHECK(fits.cards.at("FRAME") == "12");
    CHECK(fits.cards.at("OBJECT") == "Sagittarius A?");
    CHECK(fits.cards.at("LONG").starts_with("wwww"));
    CHECK(std::ranges::count(fits.comments, "One line.") == 1);
    CHECK(std::ranges::count(fits.comments, "? and ? are no ASCII") == 1);
}

TEST_CASE("fits: what is no such picture, and a place that is none, are refused without a file") {
    const TemporaryFolder folder("fits-refused");
    for (const Image<float>& image : {Image<float>{}, numbered(3, 2, 2), numbered(3, 2, 3)}) {
        const Status saved = save_fits(folder.path / "a.fits", image, {});
        REQUIRE_FALSE(saved);
        CHECK(saved.error().message().find("a.fits") != std::string::npos);
    }
    CHECK_FALSE(save_fits(folder.path / "a.fits", numbered(3, 2, 1), {}, numbered(3, 3, 3)));
    const Status nowhere = save_fits(folder.path / "nowhere" / "a.fits", numbered(3, 2, 1), {});
    REQUIRE_FALSE(nowhere);
    CHECK(nowhere.error().message().find("No such file or directory") != std::string::npos);
    for (const FitsCard& card :
         {FitsCard{"NO KEY", 1.0, ""}, {"TOO_LARGE", 1.0, ""}, {"", 1.0, ""}, {"NAN", std::nan(""), ""}})
        CHECK_FALSE(save_fits(folder.path / "a.fits", numbered(3, 2, 1), {"", "", {card}, {}}));
    CHECK(folder.files() == 0);
}

namespace {

std::map<std::string, double> coordinates(const Scene& scene, bool several = false) {
    FitsHeader header;
    cli::add_coordinates(scene, several, header);
    std::map<std::string, double> numbers;
    for (const FitsCard& card : header.cards)
        if (const auto* number = std::get_if<double>(&card.value)) numbers[card.keyword] = *number;
    return numbers;
}

Scene far_object(ObjectName name) {
    Scene scene;
    scene.object.name = name;
    scene.camera.r = 1e4, scene.camera.plane_width = 1e-3;
    scene.camera.width = 200, scene.camera.height = 100;
    return scene;
}

}  // namespace

TEST_CASE("fits coordinates: as from Earth, north up and east left, where the object is") {
    const auto sky = coordinates(far_object(ObjectName::kSgrA));
    // A pixel is 5e-6 of 2e4 GM/c^2, over the lapse.
    const double pixel_uas = 0.1 / std::sqrt(1.0 - 1e-4) * 5.124331470709856;
    CHECK(sky.at("PIXELUAS") == doctest::Approx(pixel_uas).epsilon(1e-9));
    CHECK(sky.at("CDELT2") == doctest::Approx(pixel_uas / 3.6e9).epsilon(1e-9));
    CHECK(sky.at("CDELT1") == -sky.at("CDELT2"));
    CHECK((sky.at("CRPIX1") == doctest::Approx(100.5) && sky.at("CRPIX2") == doctest::Approx(50.5)));
    CHECK((sky.at("CRVAL1") == 266.4168371 && sky.at("CRVAL2") == -29.0078106));

    Scene shifted = far_object(ObjectName::kGargantua);  // its middle right of and above the line of sight
    shifted.camera.shift_x = 0.25, shifted.camera.shift_y = 0.125;
    const auto elsewhere = coordinates(shifted);
    CHECK((elsewhere.at("CRPIX1") == doctest::Approx(50.5) && elsewhere.at("CRPIX2") == doctest::Approx(38.0)));
    CHECK((elsewhere.at("CRVAL1") == 0.0 && elsewhere.at("CRVAL2") == 0.0));
}

TEST_CASE(
    "fits coordinates: the camera's own directions where there is no one scale, none where a picture has no code") {
    Scene scene = far_object(ObjectName::kM87);
    scene.camera.pixel_aspect = 2.0;
    const double step = 5e-6 / 2.0 * 180.0 / M_PI;
    const auto own = coordinates(scene);
    CHECK((own.at("CDELT1") == doctest::Approx(2.0 * step) && own.at("CDELT2") == doctest::Approx(step)));
    CHECK_FALSE(own.contains("PIXELUAS"));
    scene = far_object(ObjectName::kOther);
    CHECK_FALSE(coordinates(scene).contains("PIXELUAS"));
    scene = far_object(ObjectName::kM87);
    CHECK(coordinates(scene).contains("PIXELUAS"));
    CHECK(coordinates(scene, true).empty());
    scene.camera.warp = "mesh.data";
    CHECK(coordinates(scene).empty());
    scene = far_object(ObjectName::kM87);
    scene.camera.projection = Projection::kFisheye;
    CHECK(coordinates(scene).empty());
}

// Radius on the plane, rad, of a place at this angle from its middle: Calabretta and Greisen 2002 (A&A 395, 1077), zenithal projections.
double zenithal_radius(const std::string& code, double angle) {
    if (code == "TAN") return std::tan(angle);
    if (code == "STG") return 2.0 * std::tan(0.5 * angle);
    if (code == "ARC") return angle;
    if (code == "SIN") return std::sin(angle);
    if (code == "ZEA") return 2.0 * std::sin(0.5 * angle);
    return NAN;
}

TEST_CASE("fits coordinates: of every projection with a code of the standard, where the standard has them") {
    for (int i = 0; i < kProjections; ++i) {
        Scene scene;
        CameraSpec& camera = scene.camera;
        camera.projection = static_cast<Projection>(i);
        const ProjectionRow& row = projection_of(camera);
        set_field_of_view(camera, row.field.usual);
        camera.width = 640, camera.height = 360, camera.pixel_aspect = row.faces ? 1.0 : 1.25;
        CAPTURE(row.name);
        FitsHeader header;
        cli::add_coordinates(scene, false, header);
        std::map<std::string, std::string> types;
        for (const FitsCard& card : header.cards)
            if (const auto* text = std::get_if<std::string>(&card.value)) types[card.keyword] = *text;
        CHECK(types.contains("CTYPE1") == !row.fits.empty());
        const bool none = std::ranges::any_of(
            header.comments, [](const std::string& line) { return line.starts_with("No coordinates"); });
        CHECK(none == row.fits.empty());
        if (row.fits.empty()) continue;
        const std::string code(row.fits);
        CHECK((types["CTYPE1"] == "CALN-" + code && types["CTYPE2"] == "CALT-" + code));
        const auto numbers = coordinates(scene);
        for (const double angle : {0.1, 0.5, 0.9})
            for (const double bearing : {0.3, 2.0, 4.4}) {  // from the right to the top
                const auto seen = pixel_of(camera, {std::sin(angle) * std::cos(bearing),
                                                    std::sin(angle) * std::sin(bearing), -std::cos(angle)});
                REQUIRE(seen);
                const double x = ((*seen)[0] + 0.5 - numbers.at("CRPIX1")) * numbers.at("CDELT1"),
                             y = (camera.height - (*seen)[1] + 0.5 - numbers.at("CRPIX2")) * numbers.at("CDELT2"),
                             radius = zenithal_radius(code, angle) * 180.0 / M_PI;
                CHECK(x == doctest::Approx(radius * std::cos(bearing)));
                CHECK(y == doctest::Approx(radius * std::sin(bearing)));
            }
    }
}

TEST_CASE("fits coordinates: the spin axis turns from north to east as the camera rolls") {
    Scene scene = far_object(ObjectName::kM87);
    for (const double roll_deg : {0.0, 30.0, 108.0, 359.0}) {
        scene.camera.roll = roll_deg * M_PI / 180.0;
        CHECK(coordinates(scene).at("SPIN_PA") == doctest::Approx(roll_deg).epsilon(1e-12));
    }
    scene.camera.roll = -0.5 * M_PI;
    CHECK(coordinates(scene).at("SPIN_PA") == doctest::Approx(270.0));
    scene.camera.theta = 0.0;
    CHECK_FALSE(coordinates(scene).contains("SPIN_PA"));
}

TEST_CASE("fits: the spacetime's parameters have their default or the scene's value, and spin always one") {
    const auto number = [](const Scene& scene, const std::string& keyword) {
        FitsHeader header;
        cli::add_scene(scene, header);
        for (const FitsCard& card : header.cards)
            if (card.keyword == keyword) return std::get<double>(card.value);
        return -1.0;
    };
    Scene scene;
    CHECK(number(scene, "SPIN") == 0.0);
    CHECK(number(scene, "INCLINAT") == doctest::Approx(84.797754));
    scene.spacetime.metric = "kerr-newman";
    CHECK((number(scene, "SPIN") == 0.6 && number(scene, "CHARGE") == 0.6));
    scene.spacetime.parameters["spin"] = 0.25;
    CHECK(number(scene, "SPIN") == 0.25);
    CHECK(number(scene, "MASS") == -1.0);
    scene.object = {7e9, std::nullopt, ObjectName::kM87};
    CHECK((number(scene, "MASS") == 7e9 && number(scene, "DISTANCE") == 16.8e6));
}
