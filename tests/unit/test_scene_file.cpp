// Scene files that are good, and the one-line messages of those that are not.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/text.h"
#include "plan/body_kind.h"
#include "scene/bodies.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_keys.h"
#include "scenefile/sections.h"
#include "spacetime/registry.h"
#include "support/folders.h"

using namespace nullscope;
namespace fs = std::filesystem;

namespace {

constexpr double kSceneFileDegree = std::numbers::pi / 180.0;
constexpr double kSceneFileRounding = 1e-15;  // degrees to radians and back: a unit in the last place
constexpr double kShownDefault = 1e-4;        // relative: the key table shows defaults to five digits

// A folder with image files (empty: they are not opened) that is gone at the end.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / fmt::format("nullscope-scene-{}", ::getpid())) {
        fs::create_directories(path_ / "sub");
        for (const char* name : {"a.png", "n.png", "s.png", "sub/b.png"}) std::ofstream(path_ / name).put('x');
    }
    ~Folder() { fs::remove_all(path_); }
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

Result<Scene> parse(std::string_view text, const fs::path& base = ".") {
    return parse_scene(text, "dir/scene.toml", base);
}

bool one_plain_line(const std::string& message) {
    return !message.empty() && std::none_of(message.begin(), message.end(),
                                            [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

constexpr std::string_view kFullScene = R"(name = "All"
description = "Every key."
[spacetime]
metric = "schwarzschild"
[camera]
r = 20
theta = 81.5
phi = -30
yaw = 10
pitch = -20.5
roll = 5
velocity = [0.1, 0, -0.2]
fov = 90
size = [640, 480]
exposure = 1.5
[sky]
kind = "image"
mapping = "band-and-caps"
image = "a.png"
north_cap = "n.png"
south_cap = "sub/../s.png"
band_latitude = 40
yaw = 90
tilt = 60
brightness = 2
[disc]
inner = 4
outer = 10.5
image = "sub/b.png"
opacity = 0.5
edge = 0.25
rotation = 45
brightness = 3
)";

}  // namespace

TEST_CASE("an empty file, a bare metric and an empty section are whole scenes") {
    for (const char* text : {"", "\n# only a comment\n", "[spacetime]\nmetric = \"schwarzschild\"\n", "[camera]\n",
                             "\xEF\xBB\xBF[sky]\r\nkind = \"stars\"\r\n"}) {
        const Result<Scene> scene = parse(text);
        REQUIRE(scene);
        CHECK(scene->name == "scene");  // the file's stem
        CHECK(scene->spacetime.metric == "schwarzschild");
        CHECK(scene->camera.r == CameraSpec{}.r);
        CHECK_FALSE(scene->disc);
    }
    CHECK(parse("[spacetime]\nmetric = \"minkowski\"\n[camera]\nr = 0.5")->spacetime.metric == "minkowski");
    const Result<Scene> disc = parse("[disc]");
    REQUIRE(disc);
    REQUIRE(disc->disc);
    CHECK(disc->disc->outer == DiscSpec{}.outer);
}

TEST_CASE("every key arrives in its field and its unit") {
    const Folder folder;
    const Result<Scene> read = parse(kFullScene, folder.path());
    REQUIRE_MESSAGE(read, read.error().message());
    const Scene& s = *read;
    CHECK(s.name == "All");
    CHECK(s.description == "Every key.");
    CHECK(s.spacetime.metric == "schwarzschild");
    CHECK(s.camera.r == 20.0);
    CHECK(s.camera.theta == doctest::Approx(81.5 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.camera.phi == doctest::Approx(-30 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.camera.yaw == doctest::Approx(10 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.camera.pitch == doctest::Approx(-20.5 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.camera.roll == doctest::Approx(5 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(length(s.camera.velocity - Vec3{0.1, 0, -0.2}) == 0.0);
    CHECK(s.camera.plane_width == doctest::Approx(2.0).epsilon(kSceneFileRounding));
    CHECK(s.camera.focal_distance == 1.0);
    CHECK(s.camera.width == 640);
    CHECK(s.camera.height == 480);
    CHECK(s.camera.exposure_ev == 1.5);
    CHECK(s.sky.kind == SkyKind::kImage);
    CHECK(s.sky.mapping == SkyMapping::kBandAndCaps);
    CHECK(s.sky.image == folder.path() / "a.png");
    CHECK(s.sky.north_cap == folder.path() / "n.png");
    CHECK(fs::equivalent(s.sky.south_cap, folder.path() / "s.png"));
    CHECK(s.sky.band_latitude == doctest::Approx(40 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.sky.yaw == doctest::Approx(90 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.sky.tilt == doctest::Approx(60 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.sky.brightness == 2.0);
    REQUIRE(s.disc);
    CHECK(s.disc->inner == 4.0);
    CHECK(s.disc->outer == 10.5);
    CHECK(s.disc->image == folder.path() / "sub/b.png");
    CHECK(s.disc->opacity == 0.5);
    CHECK(s.disc->edge == 0.25);
    CHECK(s.disc->rotation == doctest::Approx(45 * kSceneFileDegree).epsilon(kSceneFileRounding));
    CHECK(s.disc->brightness == 3.0);
    const Result<Scene> plane = parse("[camera]\nplane_width = 3\nfocal_distance = 2.5");
    REQUIRE(plane);
    CHECK(plane->camera.plane_width == 3.0);
    CHECK(plane->camera.focal_distance == 2.5);
    CHECK(parse("[camera]\ntheta = 180")->camera.theta <= std::numbers::pi);
    CHECK(parse("camera.r = 7")->camera.r == 7.0);
    CHECK(parse("camera = { r = 7, size = [1, 65536] }")->camera.height == 65536);
    CHECK(parse("[camera]\nvelocity = [0, 0.999999, 0]")->camera.velocity.y == 0.999999);
}

TEST_CASE("the defaults that the key table shows are those of an empty scene") {
    const Scene empty = *parse("");
    for (const SceneKey& key : scene_keys()) {
        if (key.type != KeyType::kNumber || key.section == "disc" || key.fallback.empty()) continue;
        Scene changed = empty;
        for (const Section& section : sections())
            if (section.optional()) section.add(changed);
        KeyValue value;
        value.number = *parse_number(key.fallback) * (key.unit == "deg" ? kSceneFileDegree : 1.0);
        CHECK(key.range.contains(*parse_number(key.fallback)));
        key.member.set(changed, value);
        const auto fields = [](const Scene& s) {
            return std::vector<double>{
                s.camera.r,           s.camera.theta, s.camera.phi,         s.camera.yaw,
                s.camera.pitch,       s.camera.roll,  s.camera.plane_width, s.camera.focal_distance,
                s.camera.exposure_ev, s.sky.yaw,      s.sky.tilt,           s.sky.band_latitude,
                s.sky.brightness};
        };
        for (std::size_t i = 0; i < fields(empty).size(); ++i) {
            const double before = fields(empty)[i], after = fields(changed)[i];
            CHECK_MESSAGE(after == doctest::Approx(before).epsilon(kShownDefault), full_name(key));
        }
    }
}

TEST_CASE("docs/scenes.md has every key, every metric's parameter and every allowed range") {
    const Result<std::string> docs = read_text(test::source_folder() / "docs/scenes.md");
    REQUIRE(docs);
    const auto shown = [](std::string_view text, bool code) {
        return text.empty() ? std::string("-") : code ? fmt::format("`{}`", text) : std::string(text);
    };
    for (const SceneKey& key : scene_keys()) {
        const std::string row = fmt::format("| `{}` | {} | {} | {} | {} |\n", full_name(key), shown(key.unit, false),
                                            shown(key.fallback, true), allowed_text(key), key.help);
        CHECK_MESSAGE(docs->find(row) != std::string::npos, row);
    }
    for (const MetricEntry& metric : metric_registry()) {
        for (const MetricParameter& parameter : metric.parameters) {
            const std::string name = fmt::format("`spacetime.{}`", parameter.name);
            CHECK_MESSAGE(docs->find(name) != std::string::npos, name);
        }
    }
}

TEST_CASE("a file may name the scene format; a newer one is refused before its unknown keys are") {
    CHECK(parse("format = 1\n"));
    const Result<Scene> told = parse("halo = 3\nformat = 2\n[camera]\nr = \"far\"\n");
    REQUIRE(!told);
    CHECK(told.error().key == "format");
    CHECK(told.error().line == 2);
    CHECK(told.error().what.find("scene format 2") != std::string::npos);
    CHECK(!parse("format = 0\n"));
    CHECK(!parse("format = 1.0\n"));
}

TEST_CASE("names of older files still work, but not beside those of now") {
    const Result<Scene> old = parse(
        "[beside]\nmetric = \"minkowski\"\n[sphere]\nswing = 0.2\n[path]\nlook = \"centre\"\n"
        "[sky]\nkind = \"points\"\nfaintest = 6\neven_stars = 9\n[camera]\nobserver = \"rain\"\n");
    REQUIRE_MESSAGE(old, old.error().message());
    CHECK(old->split->metric == "minkowski");
    CHECK(std::get<SphereSpec>(old->bodies.front().shape).amplitude == 0.2);
    CHECK(old->path->orientation == PathOrientation::kCentre);
    CHECK(old->sky.magnitude_limit == 6.0);
    CHECK(old->sky.uniform_stars == 9);
    const Result<Scene> twice = parse("[sphere]\namplitude = 0.1\nswing = 0.2\n");
    REQUIRE(!twice);
    CHECK(twice.error().key == "sphere.amplitude");
    CHECK(twice.error().line == 3);
    CHECK(!parse("[split]\nmetric = \"kerr\"\n[beside]\nmetric = \"kerr\"\n"));
}

TEST_CASE("of several faults the first in the file is reported, whatever the order of its keys") {
    const Result<Scene> scene = parse("[sky]\nyaw = \"x\"\n[camera]\nr = -1\nfov = 500\n");
    REQUIRE_FALSE(scene);
    CHECK(scene.error().message().starts_with("dir/scene.toml:2: sky.yaw: "));
}

TEST_CASE("scenes that ship: each has one place in the gallery, in a group that groups.toml names") {
    std::size_t count = 0;
    for (const SceneGroup& group : in_gallery_groups(shipped_scenes())) {
        CHECK(group.title != "Others");
        for (const SceneInfo& scene : group.scenes) {
            CAPTURE(scene.name);
            CHECK_FALSE(scene.title.empty());
            CHECK(std::filesystem::is_regular_file(assets_directory() / "gallery" / (scene.name + ".jpg")));
            ++count;
        }
    }
    CHECK(count == shipped_scenes().size());
}

TEST_CASE("scenes that ship can be read and say what they are") {
    const std::vector<SceneInfo> scenes = shipped_scenes();
    CHECK(scenes.size() >= 6);
    CHECK(std::is_sorted(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
    for (const SceneInfo& info : scenes) {
        const Result<Scene> by_name = load_scene(info.name);
        REQUIRE_MESSAGE(by_name, by_name.error().message());
        CHECK(load_scene(info.path.string()));
        CHECK_FALSE(by_name->name.empty());
        CHECK(info.description == by_name->description);
        CHECK(info.description.ends_with("."));
        CHECK(one_plain_line(info.description));
    }
}

TEST_CASE("files that cannot be read are errors that say why") {
    const Folder folder;
    const auto message = [](const std::string& name) {
        const Result<Scene> scene = load_scene(name);
        REQUIRE_FALSE(scene);
        CHECK(scene.error().kind == ErrorKind::kBadInput);
        CHECK(one_plain_line(scene.error().message()));
        return scene.error().message();
    };
    CHECK(message("first-lite").find("nearest: first-light") != std::string::npos);
    CHECK(message("no/such/file.toml").find("no such file") != std::string::npos);
    CHECK(message("").find("no such file") != std::string::npos);
    CHECK(message("evil\n\x1b[2Jname").find("no such file") != std::string::npos);
    CHECK(message(std::string(100'000, 'x')).size() < 1000);
    CHECK(message(folder.path().string()).find("a folder") != std::string::npos);
    CHECK(message("/dev/zero").find("not a regular file") != std::string::npos);
    const fs::path big = folder.path() / "big.toml";
    std::ofstream(big) << std::string(kLargestSceneFile + 1, '#');
    CHECK(message(big.string()).find("larger than 1048576 bytes") != std::string::npos);
    CHECK_FALSE(parse(std::string(kLargestSceneFile + 1, ' ')));
    CHECK(parse(std::string(kLargestSceneFile, ' ')));
    const fs::path broken = folder.path() / "broken.toml";
    std::ofstream(broken) << "\n[camera]\nr = -1\n";
    CHECK(message(broken.string())
              .starts_with(broken.string() +
                           ":3: camera.r: a static camera cannot be at -1, on or inside the horizon; allowed: r > 1"));
    std::ofstream(folder.path() / "good.toml") << "[sky]\nkind = 'image'\nimage = 'a.png'\n";
    CHECK(load_scene((folder.path() / "good.toml").string())->sky.image == folder.path() / "a.png");
}

TEST_CASE("hostile text: nothing crashes, every refusal is one plain line") {
    const Folder folder;
    const auto harmless = [&](const std::string& text) {
        const Result<Scene> scene = parse(text, folder.path());
        if (scene) return true;
        const std::string& message = scene.error().message();
        return one_plain_line(message) && message.starts_with("dir/scene.toml:") && message.size() < 2000;
    };
    for (std::size_t n = 0; n <= kFullScene.size(); ++n) CHECK(harmless(std::string(kFullScene.substr(0, n))));
    std::mt19937 engine(1);
    for (int i = 0; i < 5000; ++i) {  // one to four bytes of a good scene replaced
        std::string text(kFullScene);
        for (unsigned k = 0; k <= engine() % 4; ++k) text[engine() % text.size()] = static_cast<char>(engine());
        CHECK(harmless(text));
    }
    const auto repeated = [](const char* word, int n) {
        std::string text;
        for (int i = 0; i < n; ++i) text += word;
        return text;
    };
    for (const int n : {10, 300, 4000, 100'000}) {
        CHECK(harmless(fmt::format("x = {}", repeated("[", n))));
        CHECK(harmless(fmt::format("x = {}", repeated("{a=", n))));
        CHECK(harmless(repeated("a.", n) + "a = 1"));
        CHECK(harmless(fmt::format("[{}a]", repeated("a.", n))));
        CHECK(harmless(fmt::format("x = [{}", repeated("{a.a.a=[", n))));
        CHECK(harmless(fmt::format("x = {}", repeated("9", n))));
        CHECK(harmless(repeated("k", n) + " = 1"));
        CHECK(harmless(fmt::format("[{}]", repeated("k", n))));
        CHECK(harmless(fmt::format("name = \"{}\"", repeated("\xC3\xA9", n))));
        CHECK(harmless(fmt::format("sky.image = \"{}\"", repeated("\xC3\xA9", n))));
    }
}

TEST_CASE("a path through keys ends at its last key unless its length is given") {
    const std::string keys = "[[path.key]]\nr = 9\n[[path.key]]\nframe = 48\nr = 8\n";
    const auto open_end = parse_scene("[path]\nkind = \"keys\"\n" + keys, "a.toml", ".");
    REQUIRE(open_end);
    CHECK(open_end->path->frames == 49);
    const auto given = parse_scene("[path]\nkind = \"keys\"\nframes = 240\n" + keys, "a.toml", ".");
    REQUIRE(given);
    CHECK(given->path->frames == 240);
}
