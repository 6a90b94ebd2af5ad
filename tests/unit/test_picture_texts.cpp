// What picture files say of themselves: written in every format, read again, and refused where it is damaged.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "base/sha256.h"
#include "image/image_file.h"
#include "image/picture_formats.h"
#include "image/picture_texts.h"
#include "scenefile/picture_scene.h"
#include "scenefile/scene_text.h"
#include "scenefile/scene_writer.h"
#include "support/random_scene.h"
#include "support/temporary_folder.h"

using namespace nullscope;
namespace fs = std::filesystem;

namespace {

Texts sample_texts() {
    std::string longest;
    for (int i = 0; longest.size() < 200'000; ++i)
        longest += fmt::format("{} größer 50 % \\ \"{}\"  \n", i, std::string(i % 90, ' '));
    return {{"nullscope.scene_text", longest},
            {"nullscope.scene", "Größe"},
            {"nullscope.lines", "\n\n  a\n"},
            {"nullscope.blank", " "},
            {"nullscope.dashes", "| + %41 nullscope.no"}};
}

// Without those for other programs.
Texts own_texts(Texts texts) {
    std::erase_if(texts, [](const auto& one) { return !one.first.starts_with(kOwnTexts); });
    return texts;
}

void save_with(const fs::path& file, const Texts& texts) {
    const Image<unsigned char> bytes(8, 4, 3);
    const Image<unsigned short> words(8, 4, 3);
    const Image<float> light(8, 4, 1);
    const PictureFormat* format = format_named(file);
    if (format->save != nullptr) {
        const Status saved = format->save(file, {bytes, words, "A scene", "nullscope 1", std::nullopt, texts});
        REQUIRE_MESSAGE(saved, saved.error().message());
    }
    if (format == &kFitsFormat) {
        const Status saved = save_fits(file, light, {.texts = texts});
        REQUIRE_MESSAGE(saved, saved.error().message());
    }
    if (format != &kExrFormat) return;
    ChannelImage image{8, 4, {{"R", std::vector<float>(32)}}, texts};
    REQUIRE(save_exr(file, image));
    auto loaded = load_exr(file);
    REQUIRE(loaded);
    std::erase_if(loaded->attributes, [](const auto& one) { return !one.first.starts_with(kOwnTexts); });
    CHECK(loaded->attributes == texts);
}

}  // namespace

TEST_CASE("texts that a picture is given are read from it, in every format") {
    const TemporaryFolder folder("texts");
    for (const PictureFormat* format : kPictureFormats) {
        CAPTURE(std::string(format->name));
        const fs::path file = folder.path / fmt::format("a{}", format->ending);
        save_with(file, sample_texts());
        CHECK(is_picture_file(file));
        const auto texts = load_texts(file);
        REQUIRE_MESSAGE(texts, texts.error().message());
        CHECK(own_texts(*texts) == sample_texts());
        save_with(file, {});
        const auto none = load_texts(file);
        REQUIRE(none);
        CHECK(own_texts(*none).empty());
    }
    CHECK_FALSE(load_texts(folder.path / "missing.png"));
}

TEST_CASE("texts that are cut off or announced too long are refused") {
    const TemporaryFolder folder("texts-cut");
    for (const PictureFormat* format : kPictureFormats) {
        CAPTURE(std::string(format->name));
        const fs::path written = folder.path / fmt::format("a{}", format->ending);
        save_with(written, sample_texts());
        std::ifstream in(written, std::ios::binary);
        std::ostringstream all;
        all << in.rdbuf();
        const std::string whole = all.str();
        for (const std::size_t size : {std::size_t{9}, std::size_t{600}, std::size_t{3000}, std::size_t{100'000}}) {
            std::istringstream file(whole.substr(0, size));
            const auto texts = read_texts(file, "cut");
            if (size > 9 || format != &kPngFormat) CHECK_FALSE(texts);
        }
    }
    std::istringstream none("nothing of the kind");
    CHECK_FALSE(read_texts(none, "none"));
}

TEST_CASE("pieces end between characters and are put together, others' are left alone") {
    const std::string begin(239, 'x'), end(300, 'y');
    const Texts texts = {{"nullscope.a", begin + "äöü" + end}, {"other.a", std::string(300, 'z')}};
    const Texts pieces = in_pieces(texts, 240);
    CHECK(pieces.size() == 5);
    CHECK(pieces.at("nullscope.a.0") == std::string(239, 'x'));
    for (const auto& [keyword, text] : pieces) CHECK(text.size() <= 240);
    CHECK(put_together(pieces).at("nullscope.a") == texts.at("nullscope.a"));
    CHECK(put_together({{"other.0", "a"}, {"nullscope.b", "c"}}).size() == 2);
}

TEST_CASE("a scene in a picture's words is the very scene, every digit of it") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> angle(0.01, 3.13);
    int exact = 0, radians = 0;
    for (int i = 0; i < 300; ++i) {
        Scene scene;
        scene.name = "random";
        scene.camera.theta = angle(random), scene.camera.phi = angle(random), scene.camera.yaw = angle(random) - 1.5;
        scene.camera.plane_width = angle(random), scene.camera.roll = angle(random);
        if (i % 3 == 0) scene.camera.projection = Projection::kFisheye, scene.camera.plane_width += 0.5;
        const WrittenScene written = written_scene(scene, {""});
        const auto again = parse_scene(written.text, "again", {});
        REQUIRE_MESSAGE(again, again.error().message());
        CHECK_MESSAGE(scene_lines(*again) == scene_lines(scene), written.text);
        ++(written.text.find(" rad\"") != std::string::npos ? radians : exact);
    }
    CHECK(radians > 50);
    for (const char* text :
         {"theta = \"4 rad\"", "theta = \"nan rad\"", "theta = \"1 deg\"", "theta = \"rad\"", "r = \"9 rad\""})
        CHECK_FALSE_MESSAGE(parse_scene(fmt::format("[camera]\n{}\n", text), "s", {}), text);
}

TEST_CASE("paths are written as the scene has them, and the hash is that of sha256sum") {
    CHECK(path_in({"/a/b", "", "/c"}, "/a/b/../sky.png") == "../sky.png");
    CHECK(path_in({"/a/b", "", "/c"}, "/c/sky.png") == "sky.png");
    CHECK(path_in({"/a/b", "", "/c"}, "/d/sky.png") == "/d/sky.png");
    CHECK(path_in({""}, "sky.png") == "sky.png");
    const TemporaryFolder folder("sha256");
    std::ofstream(folder.path / "a") << "abc";  // FIPS 180-4's first example
    const auto hash = sha256_of(folder.path / "a");
    REQUIRE(hash);
    CHECK(*hash == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK_FALSE(sha256_of(folder.path / "b"));
}
