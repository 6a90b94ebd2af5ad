// Films of the sphere: boxes put into bytes that the test makes, where offsets follow; damaged ones are refused.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "image/sphere_film.h"
#include "scene/scene.h"
#include "scenefile/photo_sphere.h"

using namespace nullscope;

namespace {

std::string number(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += i < 8 ? static_cast<char>(value >> 8 * i & 255) : char{0};
    return text;
}
std::string box(const std::string& type, const std::string& body) { return number(8 + body.size(), 4) + type + body; }

const std::string kDecoder = box("avcC", "how"), kColours = box("colr", "nclx");
const std::string kStart = box("ftyp", "isom");
const std::string kPictures = "PICTURES";

struct Parts {
    std::string in_entry = kDecoder + kColours, header = "vmhd", offsets = "stco", moov_more;
    int entries = 1, tracks = 1;
};

std::string moov_of(const Parts& parts, std::uint64_t offset) {
    const std::string entry = box("avc1", std::string(78, '\1') + parts.in_entry);
    std::string entries;
    for (int i = 0; i < parts.entries; ++i) entries += entry;
    const std::string table =
        box(parts.offsets, number(0, 4) + number(1, 4) + number(offset, parts.offsets == "co64" ? 8 : 4));
    const std::string stbl = box("stbl", box("stsd", number(0, 4) + number(parts.entries, 4) + entries) + table);
    std::string tracks;
    for (int i = 0; i < parts.tracks; ++i)
        tracks += box("trak", box("tkhd", "t") + box("mdia", box("minf", box(parts.header, "v") + stbl)));
    return box("moov", box("mvhd", "m") + tracks + parts.moov_more);
}

// moov before the pictures, as for the web, or behind.
std::string film_of(const Parts& parts, bool first) {
    const std::string media = box("mdat", kPictures);
    if (!first) return kStart + media + moov_of(parts, kStart.size() + 8);
    const std::size_t length = moov_of(parts, 0).size();
    return kStart + moov_of(parts, kStart.size() + length + 8) + media;
}

Status marked(const std::string& film, const FilmSphere& sphere, std::string& to) {
    std::istringstream in(film);
    std::ostringstream out;
    Status copied = copy_with_sphere(in, sphere, out);
    to = out.str();
    return copied;
}

std::string boxes_of(const FilmSphere& sphere) {
    const std::string eyes =
        sphere.eyes == FilmEyes::kOne ? "" : box("st3d", number(0, 4) + number(static_cast<int>(sphere.eyes), 1));
    const auto share = [](double of_all) { return number(static_cast<std::uint64_t>(of_all * 4294967296.0), 4); };
    const std::string equi =
        box("equi", number(0, 4) + share(sphere.top) + share(sphere.bottom) + share(sphere.left) + share(sphere.right));
    return eyes + box("sv3d", box("svhd", number(0, 4) + "nullscope" + number(0, 1)) +
                                  box("proj", box("prhd", number(0, 16)) + equi));
}

}  // namespace

TEST_CASE("sphere film: boxes go between what a decoder needs and the rest, and offsets follow") {
    const FilmSphere part{FilmEyes::kLeftBeside, 0.0, 0.125, 0.25, 0.5};
    for (const FilmSphere& sphere : {FilmSphere{}, FilmSphere{FilmEyes::kLeftAbove}, part})
        for (const bool first : {false, true})
            for (const char* offsets : {"stco", "co64"}) {
                Parts plain, with;
                plain.offsets = with.offsets = offsets;
                with.in_entry = kDecoder + boxes_of(sphere) + kColours;
                std::string film;
                const Status copied = marked(film_of(plain, first), sphere, film);
                REQUIRE_MESSAGE(copied, copied.error().message());
                CHECK(film == film_of(with, first));
            }
}

TEST_CASE("sphere film: QuickTime's entry without a decoder's box, and one that ends in zeros") {
    for (const std::string& in_entry : {std::string(), box("fiel", "f"), number(0, 4)}) {
        Parts plain, with;
        plain.in_entry = in_entry, with.in_entry = boxes_of({}) + in_entry;
        std::string film;
        const Status copied = marked(film_of(plain, true), {}, film);
        REQUIRE_MESSAGE(copied, copied.error().message());
        CHECK(film == film_of(with, true));
    }
}

TEST_CASE("sphere film: what is not such a film is refused") {
    Parts two, twice, sound, again, table, cut;
    two.entries = 2, twice.tracks = 2, sound.header = "smhd", again.in_entry = kDecoder + box("sv3d", "");
    cut.in_entry = number(1000, 4) + "avcC";
    table.offsets = "stco";
    std::string bad_table = film_of(table, true);
    bad_table[bad_table.find("stco") + 11] = 2;  // entries, where there is one
    std::string into_moov = film_of(table, true);
    into_moov.replace(into_moov.find("stco") + 12, 4, number(kStart.size() + 1, 4));
    std::string too_far = film_of(table, true);
    too_far.replace(too_far.find("stco") + 12, 4, number(0xFFFFFFFF, 4));
    const std::string whole = film_of({}, true);
    for (const auto& [film, says] : {std::pair{std::string("{\"rows\": 1}"), "bytes, where"},
                                     {std::string(), "no box 'moov'"},
                                     {kStart, "no box 'moov'"},
                                     {whole + whole, "there twice"},
                                     {whole + box("moof", ""), "fragments"},
                                     {whole.substr(0, whole.size() - 1), "are left"},
                                     {whole + "abc", "cut off"},
                                     {film_of(two, true), "several kinds"},
                                     {film_of(twice, true), "several kinds"},
                                     {film_of(sound, true), "no track of pictures"},
                                     {film_of(again, true), "already"},
                                     {film_of(cut, true), "1000 bytes"},
                                     {bad_table, "table of offsets"},
                                     {into_moov, "impossible place"},
                                     {too_far, "impossible place"}}) {
        std::string to;
        const Status copied = marked(film, {}, to);
        const std::string said = says;
        CAPTURE(said);
        REQUIRE(!copied);
        CHECK_MESSAGE(copied.error().message().find(says) != std::string::npos, copied.error().message());
    }
}

TEST_CASE("sphere film: any byte may be wrong") {
    std::mt19937 random(1);
    for (const bool first : {false, true}) {
        const std::string whole = film_of({}, first);
        int refused = 0;
        for (int i = 0; i < 4000; ++i) {
            std::string film = whole, to;
            film[random() % film.size()] = static_cast<char>(random());
            if (i % 2) film.resize(random() % film.size());
            if (!marked(film, {}, to))
                ++refused;
            else
                CHECK(to.size() == film.size() + boxes_of({}).size());
        }
        CHECK(refused > 1000);
    }
}

TEST_CASE("sphere film: which part of the sphere a camera's film is") {
    CameraSpec camera;
    camera.projection = Projection::kEquirectangular;
    camera.width = 64, camera.height = 32, camera.plane_width = 2 * M_PI;
    CHECK(film_sphere(camera) == FilmSphere{});
    camera.stereo = Stereo::kAllRound;
    CHECK(film_sphere(camera) == FilmSphere{FilmEyes::kLeftAbove});
    camera.stereo = Stereo::kPair;
    CHECK(film_sphere(camera) == FilmSphere{FilmEyes::kLeftBeside});
    camera.stereo = Stereo::kOff;
    camera.plane_width = M_PI;  // half of all round, a quarter beyond each side: 128 x 64 px
    CHECK(film_sphere(camera) == FilmSphere{FilmEyes::kOne, 0.25, 0.25, 0.25, 0.25});
    camera.height = 31;  // its last row is lost
    CHECK(film_sphere(camera)->top + film_sphere(camera)->bottom == doctest::Approx(34.0 / 64.0));
    camera.height = 66;  // beyond the poles
    CHECK(!film_sphere(camera));
    camera.height = 32, camera.projection = Projection::kFisheye;
    CHECK(!film_sphere(camera));
}
