// Paths as tables: written and read back they are the same cameras; what a table may not say is refused with its line and column.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/text.h"
#include "observer/path.h"
#include "observer/pose.h"
#include "observer/turn.h"
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

Scene path_scene(const std::string& text) {
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
    std::vector<std::pair<std::string, Scene>> scenes{{"keys", path_scene(kFlight)}, {"lens", path_scene(lens)}};
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

double axes_off(const Mat3& m, const Mat3& n) {
    return std::max({length(m.a - n.a), length(m.b - n.b), length(m.c - n.c)});
}

// Columns of a table by their names, others left out.
std::string columns_of_table(const std::string& table, const std::vector<std::string>& without) {
    std::string text;
    std::vector<std::string> names;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> fields = split(line, ',');
        if (names.empty()) names = fields;
        std::vector<std::string> kept;
        for (std::size_t i = 0; i < fields.size(); ++i)
            if (std::ranges::find(without, names[i]) == without.end()) kept.push_back(fields[i]);
        text += fmt::format("{}\n", fmt::join(kept, ","));
    }
    return text;
}

TEST_CASE("path csv: the axes that are written are the camera's, without the angles too") {
    for (const std::string name : {"plunge", "kerr-plunge", "keys"}) {
        auto scene = name == "keys" ? Result<Scene>(path_scene(kFlight)) : load_scene(name);
        REQUIRE(scene);
        const auto path = CameraPath::make(*scene);
        REQUIRE(path);
        const auto keys = frames_of(*path);
        for (const PathPlaces places : {PathPlaces::kSpherical, PathPlaces::kCartesian}) {
            const auto table = path_csv(keys, places);
            REQUIRE(table);
            const auto both = read_path_csv(*table, "t.csv", *scene);
            REQUIRE(both);
            CHECK(!both->by_axes);
            const auto read = read_path_csv(columns_of_table(*table, {"yaw", "pitch", "roll"}), "t.csv", *scene);
            const std::string reason = read ? "" : read.error().message();
            REQUIRE_MESSAGE(read, reason);
            CHECK(read->by_axes);
            double most = 0;
            for (std::size_t i = 0; i < keys.size(); ++i)
                most = std::max(most,
                                axes_off(world_from_camera(read->keys[i].camera), world_from_camera(keys[i].camera)));
            fmt::print("{:<12} axes of {} cameras within {:.1e}\n", name, keys.size(), most);
            CHECK(most < 1e-14);
        }
    }
    // Over the pole places have no phi, by which yaw is told.
    std::vector<PathKey> pole(2);
    pole[1].frame = 1;
    for (PathKey& key : pole)
        key.camera.theta = 0, key.camera.phi = 0.8, key.camera.yaw = 0.3, key.camera.pitch = 0.2, key.camera.roll = 1;
    const auto places = path_csv(pole, PathPlaces::kCartesian);
    REQUIRE(places);
    const auto there = read_path_csv(*places, "t.csv", path_scene(""));
    REQUIRE(there);
    CHECK(axes_off(world_from_camera(there->keys[1].camera), world_from_camera(pole[1].camera)) < 1e-14);
    // Of a zoom, whose depth and angle turn the camera, there are none.
    const auto zoom = load_scene("zoom");
    REQUIRE(zoom);
    const auto path = CameraPath::make(*zoom);
    REQUIRE(path);
    const auto table = path_csv(frames_of(*path), PathPlaces::kSpherical);
    REQUIRE(table);
    CHECK(table->find("look_x") == std::string::npos);
}

TEST_CASE("path csv: columns may be left out, and stand in any order") {
    const Scene scene = path_scene("[camera]\nr = 7\nfov = 33\ntheta = 80\n");
    const auto table =
        read_path_csv("\xef\xbb\xbf# made elsewhere\nyaw, \"phi\"\r\n10,350\r\n\n20,10\r\n", "t.csv", scene);
    REQUIRE(table);
    const std::vector<PathKey>& keys = table->keys;
    REQUIRE(keys.size() == 2);
    CHECK(!table->by_axes);
    CHECK(keys[1].frame == 1);
    CHECK(keys[1].camera.r == 7);
    CHECK(keys[1].camera.plane_width == scene.camera.plane_width);
    CHECK(keys[0].camera.phi == doctest::Approx(350 * M_PI / 180));
    // Places have no turns: phi goes the shorter way.
    const auto round = read_path_csv("x,y,z\n-5,1,0\n-5,-1,0\n", "t.csv", scene);
    REQUIRE(round);
    CHECK(round->keys[1].camera.phi == doctest::Approx(2 * M_PI - round->keys[0].camera.phi));
}

TEST_CASE("path csv: the camera's axes in world axes are those of yaw, pitch and roll") {
    std::mt19937 dice(1);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(dice); };
    std::string angles = "r,theta,phi,yaw,pitch,roll\n", looks = "r,theta,phi,look_x,look_y,look_z,up_x,up_y,up_z\n",
                turns = "qw,qx,qy,qz,r,theta,phi\n";
    std::vector<CameraSpec> cameras;
    for (int i = 0; i < 200; ++i) {
        CameraSpec camera;
        camera.theta = i % 10 == 0 ? 0 : i % 10 == 1 ? M_PI : between(0, M_PI);
        camera.phi = between(-6, 6), camera.yaw = between(-3.1, 3.1), camera.roll = between(-3.1, 3.1);
        camera.pitch = i % 10 == 2 ? M_PI / 2 : i % 10 == 3 ? -M_PI / 2 : between(-1.57, 1.57);
        const auto degrees = [](double angle) { return angle * 180 / std::numbers::pi; };
        const std::string place = fmt::format("9,{},{}", degrees(camera.theta), degrees(camera.phi));
        const Mat3 axes = world_from_camera(camera);
        const Vec3 look = -2.5 * axes.c, up = 1e-3 * axes.b + 0.7 * look;  // of any length, up not upright
        const Quaternion q = turn_of(axes);
        const double size = between(-1, 1) > 0 ? 1.0005 : -0.9995;
        angles += fmt::format("{},{},{},{}\n", place, degrees(camera.yaw), degrees(camera.pitch), degrees(camera.roll));
        looks += fmt::format("{},{},{},{},{},{},{}\n", place, look.x, look.y, look.z, up.x, up.y, up.z);
        turns += fmt::format("{},{},{},{},{}\n", size * q.w, size * q.x, size * q.y, size * q.z, place);
        cameras.push_back(camera);
    }
    for (const std::string& table : {angles, looks, turns}) {
        const auto read = read_path_csv(table, "t.csv", path_scene(""));
        const std::string reason = read ? "" : read.error().message();
        REQUIRE_MESSAGE(read, reason);
        CHECK(read->by_axes == (table != angles));
        REQUIRE(read->keys.size() == cameras.size());
        double most = 0;
        for (std::size_t i = 0; i < cameras.size(); ++i)
            most = std::max(most, axes_off(world_from_camera(read->keys[i].camera), world_from_camera(cameras[i])));
        fmt::print("axes of 200 cameras within {:.1e}\n", most);
        CHECK(most < 2e-12);
    }
    // The quaternion that turns nothing: right, up and backward are x, y and z.
    const auto plain = read_path_csv("qw,qx,qy,qz\n1,0,0,0\n0,0,0,-1\n", "t.csv", path_scene("[camera]\nphi = 33\n"));
    REQUIRE(plain);
    CHECK(axes_off(world_from_camera(plain->keys[0].camera), Mat3{}) < 1e-15);
    CHECK(axes_off(world_from_camera(plain->keys[1].camera), {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}) < 1e-15);
}

TEST_CASE("path csv: between rows with axes the camera turns the shortest way at an even rate") {
    // By 150 degrees about (1, 2, 2)/3 in 10 frames, over a pole of yaw, while the camera moves.
    const double angle = 150 * M_PI / 180;
    const auto about = [](double by) {
        const double s = std::sin(by / 2) / 3;
        return Quaternion{std::cos(by / 2), s, 2 * s, 2 * s};
    };
    const Quaternion a = about(0.3), b = about(0.3 + angle);
    const std::string table = fmt::format("frame,x,y,z,qw,qx,qy,qz\n5,9,0,1,{},{},{},{}\n15,4,7,-2,{},{},{},{}\n", a.w,
                                          a.x, a.y, a.z, -b.w, -b.x, -b.y, -b.z);
    const Scene still = path_scene("[path]\nkind = \"keys\"\n[[path.key]]\n[[path.key]]\nr = 9\n");
    const auto scene = with_path_file(still, table);
    const std::string reason = scene ? "" : scene.error().message();
    REQUIRE_MESSAGE(scene, reason);
    CHECK(scene->path->turn == PathTurn::kShortest);
    const auto path = CameraPath::make(*scene);
    REQUIRE(path);
    for (double frame = 5; frame <= 15; frame += 0.125) {
        CAPTURE(frame);
        const Mat3 wanted = axes_of(about(0.3 + angle * (frame - 5) / 10));
        CHECK(axes_off(world_from_camera(path->at(frame)), wanted) < 1e-13);
    }
    // A scene that is saved turns likewise.
    const auto alone = parse_scene(scene_file_text(*scene, {}), "alone.toml", {});
    REQUIRE(alone);
    CHECK(alone->path->turn == PathTurn::kShortest);
    const auto again = CameraPath::make(*alone);
    REQUIRE(again);
    CHECK(axes_off(world_from_camera(again->at(8)), world_from_camera(path->at(8))) < 1e-12);
    // Small turns, none, and half a turn.
    CHECK(axes_off(axes_between(axes_of(about(1)), axes_of(about(1 + 1e-9)), 0.5), axes_of(about(1 + 5e-10))) < 1e-15);
    CHECK(axes_off(axes_between(axes_of(about(1)), axes_of(about(1)), 0.5), axes_of(about(1))) < 1e-15);
    const Mat3 half = axes_between(Mat3{}, axes_of(about(M_PI)), 0.5);
    CHECK(std::min(axes_off(half, axes_of(about(M_PI / 2))), axes_off(half, axes_of(about(-M_PI / 2)))) < 1e-15);
}

TEST_CASE("path csv: errors name file, line, column and what is allowed") {
    const Scene scene = path_scene("");
    struct Case {
        const char *table, *message;
    };
    const Case cases[] = {
        {"", "t.csv:1: row: fewer than two rows; allowed: a header and two rows or more"},
        {"frame,r\n0,9\n", "t.csv:2: row: fewer than two rows; allowed: a header and two rows or more"},
        {"frame,rol\n0,9\n1,9\n",
         "t.csv:1: header: unknown column \"rol\"; allowed: frame, time, r, theta, phi, yaw, pitch, "
         "roll, observer, fall_from, energy, fov, plane_width, focal_distance, shift_x, shift_y, "
         "exposure, depth, angle, velocity_r, velocity_theta, velocity_phi, x, y, z, "
         "look_x, look_y, look_z, up_x, up_y, up_z, qw, qx, qy, qz (nearest: roll)"},
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
        {"look_x,look_y,look_z,up_x,up_y\n",
         "t.csv:1: header: not all of look_x, look_y, look_z, up_x, up_y, up_z; allowed: all or none"},
        {"qw,qx,qz\n", "t.csv:1: header: not all of qw, qx, qy, qz; allowed: all or none"},
        {"qw,qx,qy,qz,roll\n",
         "t.csv:1: header: the camera's axes are given twice; allowed: one of yaw, pitch, roll; look_x, look_y, "
         "look_z, up_x, up_y, up_z; qw, qx, qy, qz; or all of the first two"},
        {"look_x,look_y,look_z,up_x,up_y,up_z,yaw,pitch\n",
         "t.csv:1: header: the camera's axes are given twice; allowed: one of yaw, pitch, roll; look_x, look_y, "
         "look_z, up_x, up_y, up_z; qw, qx, qy, qz; or all of the first two"},
        {"theta,yaw,pitch,roll,look_x,look_y,look_z,up_x,up_y,up_z\n90,0,0,0,-2,0,0,0,0,3\n90,0,0,0,-1,0.0002,0,0,0,"
         "1\n",
         "t.csv:3: look_x: the axes are 0.0002 rad from those of yaw, pitch, roll; allowed: within 0.0001 rad; or "
         "leave "
         "either out"},
        {"yaw,pitch,roll,look_x,look_y,look_z,up_x,up_y,up_z,depth\n",
         "t.csv:1: look_x: there is a [zoom], whose depth and angle turn the camera; allowed: without [zoom]"},
        {"qw,qx,qy,qz,depth\n",
         "t.csv:1: qw: there is a [zoom], whose depth and angle turn the camera; allowed: without [zoom]"},
        {"look_x,look_y,look_z,up_x,up_y,up_z\n0,0,-1,1,0,0\n0,-0,0,0,0,1\n",
         "t.csv:3: look_x: look_x, look_y, look_z are 0; allowed: not all of them 0"},
        {"look_x,look_y,look_z,up_x,up_y,up_z\n1,0,0,0,0,0\n",
         "t.csv:2: up_x: up_x, up_y, up_z are 0; allowed: not all of them 0"},
        {"look_x,look_y,look_z,up_x,up_y,up_z\n3,0,4,-6.000001,0,-8\n",
         "t.csv:2: up_x: up_x, up_y, up_z are along look_x, look_y, look_z; allowed: 1e-06 rad or more from it and its "
         "opposite"},
        {"look_x,look_y,look_z,up_x,up_y,up_z\n1e10,0,0,0,0,1\n",
         "t.csv:2: look_x: 10000000000 is out of range; allowed: [-1000000000, 1000000000]"},
        {"qw,qx,qy,qz\n1,0,0,0\n0,0.75,0,0\n",
         "t.csv:3: qw: qw, qx, qy, qz have the length 0.75; allowed: [0.999, 1.001]"},
        {"qw,qx,qy,qz\n0,0,0,0\n", "t.csv:2: qw: qw, qx, qy, qz have the length 0; allowed: [0.999, 1.001]"},
        {"qw,qx,qy,qz\n1,0,north,0\n", "t.csv:2: qy: \"north\" is no number; allowed: [-1.001, 1.001]"},
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
    const Scene scene = path_scene("[path]\nkind = \"keys\"\n[[path.key]]\n[[path.key]]\nr = 9\n");
    const auto said = [](const Result<Scene>& read) { return read ? "" : read.error().message(); };
    CHECK(said(with_path_file(scene, "r\n9\n0\n"))
              .ends_with("camera.csv:3: r: a static camera cannot be at 0, on or inside the horizon; allowed: r > 1"));
    CHECK(said(with_path_file(scene, "r,observer\n9,static\n8,rain\n")).find("one observer") != std::string::npos);
    CHECK(said(parse_scene("[path]\nkind = \"fall\"\nturn = \"shortest\"\n", "s.toml", {}))
              .starts_with("s.toml:3: path.turn"));
    const TemporaryFolder folder("path-csv");
    std::ofstream(folder.path / "q.csv") << "qw,qx,qy,qz\n1,0,0,0\n1,0,0,0\n";
    CHECK(said(parse_scene("[path]\nkind = \"keys\"\nturn = \"angles\"\nfile = \"q.csv\"\n", "s.toml", folder.path)) ==
          "s.toml:3: path.turn: the file has the camera's axes, not its angles; allowed: shortest");
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
