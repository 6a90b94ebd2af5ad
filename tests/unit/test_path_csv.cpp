// Paths as tables: written and read back they are the same cameras; what a table may not say is refused with its line and column.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "observer/path.h"
#include "scenefile/path_csv.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;

std::vector<PathKey> frames_of(const CameraPath& path) {
    std::vector<PathKey> keys;
    for (int frame = 0; frame < path.frames(); ++frame)
        keys.push_back({static_cast<double>(frame), path.at(frame), path.clock(frame)});
    return keys;
}

double angle_off(double a, double b) { return std::fabs(std::remainder(a - b, 2 * M_PI)); }

// The largest difference of two cameras' numbers, of lengths relative to r.
double off(const CameraSpec& a, const CameraSpec& b) {
    double most = length(a.velocity - b.velocity);
    for (const auto number : kCameraNumbers) {
        const bool turns = number == &CameraSpec::phi || number == &CameraSpec::yaw || number == &CameraSpec::roll;
        const double apart = turns ? angle_off(a.*number, b.*number) : std::fabs(a.*number - b.*number);
        most = std::max(most, apart / std::max(1.0, std::fabs(a.*number)));
    }
    if (a.zoom)
        most = std::max({most, std::fabs(a.zoom->depth - b.zoom->depth), angle_off(a.zoom->angle, b.zoom->angle)});
    return most;
}

// The scene with its path in a file, as a user writes it.
Result<Scene> with_path_file(Scene scene, const std::string& table) {
    const TemporaryFolder folder("path-csv");
    std::ofstream(folder.path / "camera.csv") << table;
    const double rate = scene.path->rate;
    scene.path.reset();
    return parse_scene(
        scene_file_text(scene, {}) + fmt::format("\n[path]\nkind = \"keys\"\nrate = {}\nfile = \"camera.csv\"\n", rate),
        "scene.toml", folder.path);
}

Scene scene_of(const std::string& text) {
    auto scene = parse_scene(text, "scene.toml", {});
    const std::string reason = scene ? "" : scene.error().message();
    REQUIRE_MESSAGE(scene, reason);
    return std::move(*scene);
}

constexpr const char* kFlight = R"([camera]
r = 20
fov = 50
[path]
kind = "keys"
easing = "smooth"
[[path.key]]
[[path.key]]
frame = 10
r = 12
phi = 300
theta = 70
yaw = 25
roll = -170
fov = 40
velocity = [0.1, 0, -0.3]
time = 3
[[path.key]]
frame = 24
r = 9
phi = 700
exposure = 1.5
shift_x = 0.25
)";

TEST_CASE("path csv: what is written reads back as the same cameras") {
    const std::string lens =
        "[camera]\nplane_width = 2\nfocal_distance = 3\n[path]\nkind = \"keys\"\n"
        "[[path.key]]\n[[path.key]]\nframe = 9\nr = 8\nplane_width = 1\n";
    std::vector<std::pair<std::string, Scene>> scenes{{"keys", scene_of(kFlight)}, {"lens", scene_of(lens)}};
    for (const char* name : {"plunge", "kerr-plunge", "zoom"}) {
        auto scene = load_scene(name);
        REQUIRE(scene);
        scenes.emplace_back(name, std::move(*scene));
    }
    for (const auto& named : scenes)
        for (const PathPlaces places : {PathPlaces::kSpherical, PathPlaces::kCartesian}) {
            CAPTURE(named.first);
            const Scene& scene = named.second;
            const auto path = CameraPath::make(scene);
            REQUIRE(path);
            const auto keys = frames_of(*path);
            const auto table = path_csv(keys, places);
            REQUIRE(table);
            const auto again = with_path_file(scene, *table);
            const std::string reason = again ? "" : again.error().message();
            REQUIRE_MESSAGE(again, reason);
            const auto there = CameraPath::make(*again);
            REQUIRE(there);
            CHECK(there->frames() == path->frames());
            double most = 0, late = 0;
            for (const PathKey& key : keys) {
                most = std::max(most, off(there->at(key.frame), key.camera));
                late = std::max(late, std::fabs(there->clock(key.frame) - key.time));
                CHECK(there->at(key.frame).observer == key.camera.observer);
            }
            fmt::print("{:<12} {} frames: cameras within {:.1e}, times {:.1e}\n", named.first, keys.size(), most, late);
            CHECK(most < 1e-9);
            CHECK(late == 0);
            CHECK(again->path->rate == scene.path->rate);
            // The scene's text has the keys, so that it stands alone.
            const auto alone = parse_scene(scene_file_text(*again, {}), "alone.toml", {});
            REQUIRE(alone);
            CHECK(alone->path->keys.size() == keys.size());
        }
}

TEST_CASE("path csv: columns may be left out, and stand in any order") {
    const Scene scene = scene_of("[camera]\nr = 7\nfov = 33\ntheta = 80\n");
    const auto keys =
        read_path_csv("\xef\xbb\xbf# made elsewhere\nyaw, \"phi\"\r\n10,350\r\n\n20,10\r\n", "t.csv", scene);
    REQUIRE(keys);
    REQUIRE(keys->size() == 2);
    CHECK((*keys)[1].frame == 1);
    CHECK((*keys)[1].camera.r == 7);
    CHECK((*keys)[1].camera.plane_width == scene.camera.plane_width);
    CHECK((*keys)[0].camera.phi == doctest::Approx(350 * M_PI / 180));
    // Places have no turns: phi goes the shorter way.
    const auto round = read_path_csv("x,y,z\n-5,1,0\n-5,-1,0\n", "t.csv", scene);
    REQUIRE(round);
    CHECK((*round)[1].camera.phi == doctest::Approx(2 * M_PI - (*round)[0].camera.phi));
}

TEST_CASE("path csv: errors name file, line, column and what is allowed") {
    const Scene scene = scene_of("");
    struct Case {
        const char *table, *message;
    };
    const Case cases[] = {
        {"", "t.csv:1: row: fewer than two rows; allowed: a header and two rows or more"},
        {"frame,r\n0,9\n", "t.csv:2: row: fewer than two rows; allowed: a header and two rows or more"},
        {"frame,rol\n0,9\n1,9\n",
         "t.csv:1: header: unknown column \"rol\"; allowed: frame, time, r, theta, phi, yaw, pitch, "
         "roll, observer, fall_from, energy, fov, plane_width, focal_distance, shift_x, shift_y, "
         "exposure, depth, angle, velocity_r, velocity_theta, velocity_phi, x, y, z (nearest: roll)"},
        {"r,r\n", "t.csv:1: r: this column is there twice; allowed: once"},
        {"frame,r\n0,9\n1\n", "t.csv:3: row: 1 fields; allowed: 2, as in the header"},
        {"theta\n90\n# south\n181\n", "t.csv:4: theta: 181 is out of range; allowed: [0, 180]"},
        {"theta\n90\nnan\n", "t.csv:3: theta: \"nan\" is no number; allowed: [0, 180]"},
        {"theta\n90\n\n9O\n", "t.csv:4: theta: \"9O\" is no number; allowed: [0, 180]"},
        {"frame,r\n0,9\n0,8\n", "t.csv:3: frame: 0 is not after the row before; allowed: frames that grow"},
        {"frame,r\n0,9\n-1,8\n", "t.csv:3: frame: -1 is out of range; allowed: [0, 1000000]"},
        {"time\n0\n1e10\n", "t.csv:3: time: 10000000000 is out of range; allowed: [-1000000000, 1000000000]"},
        {"r\n3\n0.9\n", "t.csv:3: r: a static camera cannot be at 0.9, on or inside the horizon; allowed: r > 1"},
        {"velocity_r,velocity_theta,velocity_phi\n0,0,0\n0.8,0,0.7\n",
         "t.csv:3: velocity_r: the speed is not below that of light; allowed: three numbers, speed below 1"},
        {"velocity_r,velocity_phi\n",
         "t.csv:1: header: not all of velocity_r, velocity_theta, velocity_phi; allowed: all or none"},
        {"x,y,z,phi\n", "t.csv:1: header: both x, y, z and r, theta, phi are given; allowed: one of both"},
        {"x,y,z\n0,0,0\n", "t.csv:2: x: the centre has no direction; allowed: another place"},
        {"energy\n1\n2\n", "t.csv:2: energy: is not used here; allowed: with observer = \"throw\" only"},
        {"fov,plane_width\n60,1\n",
         "t.csv:2: fov: says the same as camera.plane_width; allowed: either fov, or plane_width and "
         "focal_distance"},
        {"observer\nstatik\n",
         "t.csv:2: observer: unknown word \"statik\" (nearest: static); allowed: static, rain, fall, "
         "throw, orbit, zamo, carter or counter-orbit"},
        {"r\n\"9\n",
         "t.csv:2: row: a quote is not closed, or something follows it; allowed: \"...\" around whole fields"},
    };
    for (const Case& one : cases) {
        const auto keys = read_path_csv(one.table, "t.csv", scene);
        REQUIRE_MESSAGE(!keys, one.table);
        CHECK(keys.error().message() == one.message);
    }
}

TEST_CASE("path csv: of a scene file") {
    const Scene scene = scene_of("[path]\nkind = \"keys\"\n[[path.key]]\n[[path.key]]\nr = 9\n");
    const auto said = [](const Result<Scene>& read) { return read ? "" : read.error().message(); };
    CHECK(said(with_path_file(scene, "r\n9\n0\n"))
              .ends_with("camera.csv:3: r: a static camera cannot be at 0, on or inside the horizon; allowed: r > 1"));
    CHECK(said(with_path_file(scene, "r,observer\n9,static\n8,rain\n")).find("one observer") != std::string::npos);
    const auto text = [&](const char* path) { return said(parse_scene(path, "scene.toml", {})); };
    CHECK(text("[path]\nkind = \"keys\"\nfile = \"no.csv\"\n") ==
          "scene.toml:3: path.file: there is no file \"no.csv\"; allowed: a CSV file, relative to the scene file");
}

TEST_CASE("path csv: what a table cannot say is refused") {
    std::vector<PathKey> keys(2);
    keys[1].frame = 1, keys[1].camera.r = -3;
    CHECK(!path_csv(keys, PathPlaces::kCartesian));
    CHECK(path_csv(keys, PathPlaces::kSpherical));
    // Turns go on from frame to frame, as far as a scene's angles may.
    keys.clear();
    for (int i = 0; i < 300; ++i) {
        keys.push_back({static_cast<double>(i), {}, 0});
        keys.back().camera.phi = std::remainder(0.25 * i, 2 * M_PI);
    }
    const auto many = path_csv(keys, PathPlaces::kSpherical);
    REQUIRE(!many);
    CHECK(many.error().message().starts_with("frame 252: phi is 3610 degrees"));
    keys.resize(250);
    CHECK(path_csv(keys, PathPlaces::kSpherical));
}

}  // namespace
