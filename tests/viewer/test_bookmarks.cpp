// Bookmarks: what is kept, renamed, deleted and brought back, and files that are broken.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "image/image_file.h"
#include "scenefile/scene_file.h"
#include "studio/bookmarks.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;
namespace fs = std::filesystem;

struct Folder {
    TemporaryFolder home{"bookmarks"};
    fs::path path = home.path / "bookmarks";  // not there yet
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(path);
        std::ofstream(path / name) << text;
    }
};

Scene scene_at(double r) {
    Scene scene = *load_scene("first-light");
    scene.camera.r = r;
    return scene;
}

Image<unsigned char> picture() { return {32, 18, 3}; }

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("bookmarks: a scene is kept whole, numbered, and found again") {
    const Folder folder;
    Bookmarks first(folder.path);
    first.list();
    CHECK(first.all().empty());
    CHECK(*first.add(scene_at(31.0), "first-light", picture()) == "First light 1");
    CHECK(*first.add(scene_at(32.0), "first-light", {}) == "First light 2");
    Bookmarks other(folder.path);
    other.list();
    REQUIRE(other.all().size() == 2);
    const std::string newest = other.all()[0].stem, oldest = other.all()[1].stem;
    CHECK(other.all()[0].name.empty());  // not read yet
    CHECK(other.read(newest));
    CHECK_FALSE(other.read(newest));
    CHECK(other.all()[0].name == "First light 2");
    const auto kept = load_scene(other.scene_file(oldest).string());
    REQUIRE(kept);
    CHECK(kept->camera.r == 31.0);
    CHECK(load_image(other.picture_file(oldest))->width == 32);
    CHECK_FALSE(fs::exists(other.picture_file(newest)));
    // A bookmark of a bookmark does not gather numbers.
    CHECK(*other.add(*kept, other.scene_file(oldest).string(), {}) == "First light 3");
    CHECK(*other.add(*kept, "elsewhere.toml", {}) == "First light 1 4");
}

TEST_CASE("bookmarks: another name") {
    const Folder folder;
    Bookmarks bookmarks(folder.path);
    REQUIRE(bookmarks.add(scene_at(31.0), "first-light", picture()));
    const std::string stem = bookmarks.all()[0].stem;
    REQUIRE(bookmarks.rename(stem, "  the \"ring\" \\ \xc3\xa9 "));
    CHECK(bookmarks.all()[0].name == "the \"ring\" \\ \xc3\xa9");
    const auto read = load_scene(bookmarks.scene_file(stem).string());
    REQUIRE(read);
    CHECK(read->name == "the \"ring\" \\ \xc3\xa9");
    CHECK(read->camera.r == 31.0);
    const std::string before = text_of(bookmarks.scene_file(stem));
    for (const std::string& name : {std::string(), std::string("  "), std::string("a\nb"), std::string(81, 'x')})
        CHECK_FALSE(bookmarks.rename(stem, name));
    CHECK(text_of(bookmarks.scene_file(stem)) == before);
    CHECK_FALSE(bookmarks.rename("bookmark-000099", "other"));
}

TEST_CASE("bookmarks: what is deleted comes back, the last first, and its number is not given again") {
    const Folder folder;
    Bookmarks bookmarks(folder.path);
    REQUIRE(bookmarks.add(scene_at(31.0), "first-light", picture()));
    REQUIRE(bookmarks.add(scene_at(32.0), "first-light", {}));
    const std::string two = bookmarks.all()[0].stem, one = bookmarks.all()[1].stem;
    const std::string scene = text_of(bookmarks.scene_file(one)), drawn = text_of(bookmarks.picture_file(one));
    REQUIRE(bookmarks.remove(two));
    REQUIRE(bookmarks.remove(one));
    CHECK(bookmarks.all().empty());
    CHECK(fs::is_empty(folder.path));
    CHECK(bookmarks.last_removed() == "First light 1");
    CHECK(*bookmarks.add(scene_at(33.0), "first-light", {}) == "First light 3");
    REQUIRE(bookmarks.restore());
    CHECK(text_of(bookmarks.scene_file(one)) == scene);
    CHECK(text_of(bookmarks.picture_file(one)) == drawn);
    CHECK(bookmarks.last_removed() == "First light 2");
    REQUIRE(bookmarks.restore());
    CHECK(bookmarks.last_removed().empty());
    REQUIRE(bookmarks.restore());  // nothing is left to do
    CHECK(bookmarks.all().size() == 3);
    CHECK(bookmarks.read(two));
    CHECK(bookmarks.all()[1].name == "First light 2");
}

TEST_CASE("bookmarks: broken files are skipped and named, and left alone") {
    const Folder folder;
    folder.write("bookmark-000001.toml", "[camera]\nr = ");
    folder.write("bookmark-000002.toml", "[camera]\nr = 12\n");
    folder.write("bookmark-999x.toml", "bad = \"\x01\"");
    folder.write(".hidden.toml", "");
    folder.write("picture.jpg", "");
    fs::create_directories(folder.path / "folder.toml");
    Bookmarks bookmarks(folder.path);
    bookmarks.list();
    REQUIRE(bookmarks.all().size() == 3);
    for (const Bookmark& bookmark : std::vector<Bookmark>(bookmarks.all())) CHECK(bookmarks.read(bookmark.stem));
    CHECK(bookmarks.all()[0].error.find("bookmark-999x.toml") != std::string::npos);
    CHECK(bookmarks.all()[1].name == "bookmark-000002");
    CHECK(bookmarks.all()[2].error.find("bookmark-000001.toml") != std::string::npos);
    CHECK_FALSE(bookmarks.rename("bookmark-000001", "mended"));
    CHECK(text_of(folder.path / "bookmark-000001.toml") == "[camera]\nr = ");
    CHECK(bookmarks.add(scene_at(31.0), "", {}));
    CHECK(bookmarks.all()[0].stem == "bookmark-000003");
}

TEST_CASE("bookmarks: no more than can be shown, and none without a folder") {
    const Folder folder;
    for (std::size_t i = 0; i < Bookmarks::kMost + 5; ++i) folder.write("b" + std::to_string(i) + ".toml", "");
    Bookmarks full(folder.path);
    full.list();
    CHECK(full.all().size() == Bookmarks::kMost);
    const auto refused = full.add(scene_at(31.0), "", picture());
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message().find("200") != std::string::npos);
    Bookmarks homeless{fs::path()};
    homeless.list();
    CHECK(homeless.all().empty());
    CHECK_FALSE(homeless.add(scene_at(31.0), "", picture()));
    // A file where the folder should be.
    folder.write("file", "");
    Bookmarks blocked(folder.path / "file");
    CHECK_FALSE(blocked.add(scene_at(31.0), "", picture()));
}
