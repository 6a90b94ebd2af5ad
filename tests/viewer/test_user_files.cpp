// Settings and scenes that were not saved: what is kept, and what is hostile.
#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scenefile/scene_file.h"
#include "studio/autosave.h"
#include "studio/user_files.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;
namespace fs = std::filesystem;

// A home of the test's own.
struct Home {
    TemporaryFolder made{"home"};
    fs::path folder = made.path;
    Home() {
        ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
        ::setenv("XDG_STATE_HOME", folder.c_str(), 1);
    }
    void write(const char* name, const std::string& text) const {
        fs::create_directories(folder / "nullscope");
        std::ofstream(folder / "nullscope" / name) << text;
    }
};

TEST_CASE("settings: what is saved is read again, and a broken file is as none") {
    const Home home;
    CHECK(load_settings() == Settings());
    Settings settings{true, 1.5, 1280, 720, {"/a b/\"c\".toml", "/d\\e.toml"}, true, {}, {}};
    settings.numbers = {LengthUnit::kKilometre, 6.5e9, true};
    settings.place = ScreenPlace{-7, 300};
    REQUIRE(save_settings(settings));
    CHECK(load_settings() == settings);
    for (const char* text :
         {"", "hints_seen = ", "hints_seen = 3\ntext_scale = \"x\"\nrecent = 7\nwindow = [1]\nwindow_place = [1, 1e30]",
          "theme = 3", "theme = \"blue\"", "units = \"mile\"\nmass_suns = -1\ndecimal_comma = 1",
          "text_scale = 1e9\nwindow = [-5, 99999999]\nrecent = [1, [2], \"\\u0007\"]", "\x01\xff"}) {
        home.write("viewer.toml", text);
        CHECK(load_settings() == Settings());
    }
    home.write("viewer.toml", std::string(1 << 20, 'a'));
    CHECK(load_settings() == Settings());
}

TEST_CASE("autosave: a changed scene is kept, one that is as it was is not, and an end makes it the last session") {
    const Home home;
    const auto loaded = load_scene("first-light");
    REQUIRE(loaded);
    Scene scene = *loaded;
    const fs::path own = home.folder / "nullscope" / ("unsaved-" + std::to_string(::getpid()) + ".toml");
    Autosave autosave;
    REQUIRE(autosave.keep(scene, *loaded, 0.0));
    CHECK_FALSE(fs::exists(own));
    scene.camera.r = 33.0;
    scene.camera.width += 7;
    REQUIRE(autosave.keep(scene, *loaded, 1.0));
    CHECK_FALSE(fs::exists(own));  // not yet
    REQUIRE(autosave.keep(scene, *loaded, 2.0));
    REQUIRE(fs::exists(own));
    CHECK(load_scene(own.string())->camera.r == 33.0);
    CHECK_FALSE(left_scene());  // this process runs
    REQUIRE(autosave.keep(*loaded, *loaded, 4.0));
    CHECK_FALSE(fs::exists(own));
    autosave.end(scene, *loaded);
    CHECK_FALSE(fs::exists(own));
    CHECK(load_scene(last_session().string())->camera.r == 33.0);
}

TEST_CASE("autosave: what a process that is gone has left is found, and nothing else") {
    const Home home;
    for (const char* name : {"unsaved-.toml", "unsaved-x.toml", "unsaved-12x.toml", "unsaved--4.toml",
                             "unsaved-99999999999.toml", ".unsaved-999999.7-1.tmp.toml", "viewer.toml"})
        home.write(name, "name = \"other\"\n");
    CHECK_FALSE(left_scene());
    home.write("unsaved-4194303.toml", "name = \"left\"\n");  // above the usual greatest number of a process
    const auto left = left_scene();
    REQUIRE(left);
    REQUIRE(take_left_scene(*left));
    CHECK_FALSE(left_scene());
    CHECK(load_scene(last_session().string())->name == "left");
}

}  // namespace
