// Broken scenes: the line, the key and a part of the message of each.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "support/folders.h"

using namespace nullscope;
using namespace std::string_literals;

namespace {

struct Broken {
    std::string text;
    int line;
    std::string key;   // "" for faults of the TOML itself
    std::string part;  // of the message
};

const Broken kBroken[] = {
    // Not TOML
    {"[camera\nr = 1", 1, "", ""},
    {"\n\nr 5", 3, "", ""},
    {"[camera]\nr = ", 2, "", ""},
    {"[camera]\nr = 5\nr = 6", 3, "", "redefine"},
    {"[camera]\nr = 5\n[camera]\n", 3, "", "redefine"},
    {"[camera]\nr = 1e999999", 2, "", ""},
    {"[camera]\nr = 99999999999999999999", 2, "", ""},
    {"name = \"abc", 1, "", ""},
    {"name = \"\xFF\xFE\"", 1, "", ""},
    {"name = \"\xC3\"", 1, "", ""},
    {"name = \"a\nb\"", 1, "", ""},
    {"name = \"a\0b\""s, 1, "", ""},
    {"\0\0\0\0"s, 1, "", ""},
    {"x = " + std::string(1000, '['), 1, "", "depth"},
    {"a" + std::string(5000, '.') + "a = 1", 1, "", "more than 4096 dots"},
    // Places that floats do not tell apart
    {"[spacetime]\nmetric = \"ellis\"\nthroat = 0.02\n[ball]\nposition = [1990, 0, 0]\nradius = 20", 5, "ball.position",
     "bodies within 2000 of it"},
    // Matter in orbit where a cosmological constant pulls it outward
    {"[spacetime]\nmetric = \"formula\"\nA = \"1 - 1/r - 0.002*r^2/3\"\n[disc]\nemission = \"thermal\"\nouter = 9.2", 6,
     "disc.outer", "pulled outward"},
    // Unknown words
    {"nmae = \"x\"", 1, "nmae", "nearest known key: name"},
    {"[camra]\nr = 5", 1, "camra", "nearest known key: camera"},
    {"r = 5", 1, "r", "nearest known key: camera.r"},
    {"[camera]\nfoov = 60", 2, "camera.foov", "nearest known key: camera.fov"},
    {"[camera]\ninner = 3", 2, "camera.inner", "nearest known key: disc.inner"},
    {"[sky]\nqqqqqqqq = 1", 2, "sky.qqqqqqqq", "allowed: kind, mapping, image"},
    {"[disc]\n\"\" = 1", 2, "disc.", "unknown key"},
    {"\"\" = 1", 1, "", "unknown key"},
    {"[\"\"]\nr = 1", 1, "", "unknown key"},
    {"[disc]\n\"a\\nb\\u001b[2J\" = 1", 2, "disc.a?b?[2J", "unknown key"},
    {"[disc]\n\"\\u009b2J\" = 1", 2, "disc.??2J", "unknown key"},
    {"[camera.r]\nx = 1", 1, "camera.r", "must be a number, not a table"},
    {"[[camera]]\nr = 5", 1, "camera", "must be a section"},
    {"camera = 5", 1, "camera", "must be a section"},
    {"name = \"x\"\ndisc = true", 2, "disc", "must be a section"},
    // Spacetime
    {"[spacetime]\nmetric = \"schwarzchild\"", 2, "spacetime.metric", "nearest: schwarzschild"},
    {"[spacetime]\nmetric = \"\"", 2, "spacetime.metric", "allowed: schwarzschild"},
    {"[spacetime]\nmetric = 5", 2, "spacetime.metric", "must be a string, not an integer"},
    {"[spacetime]\nmetric = [\"minkowski\"]", 2, "spacetime.metric", "must be a string, not an array"},
    {"[spacetime]\nspin = 0.5", 2, "spacetime.spin", "no parameter of metric \"schwarzschild\"; allowed: metric"},
    {"[spacetime]\nmetric = \"minkowski\"\ncharge = 0.5", 3, "spacetime.charge", "parameter of metric \"minkowski\""},
    {"[spacetime]\ncharge = 0.5\nmetric = \"kerrr\"", 3, "spacetime.metric", "unknown word \"kerrr\""},
    {"[spacetime]\nmetrik = \"minkowski\"", 2, "spacetime.metrik", "nearest known key: spacetime.metric"},
    {"[spacetime]\nmetric = \"ellis\"\nthroat = 0", 3, "spacetime.throat", "allowed: [0.01, 100]"},
    {"[spacetime]\nmetric = \"neutron-star\"\nradius = 0.9", 3, "spacetime.radius", "allowed: [1.125, 1000]"},
    {"[split]\nmetric = \"kerrr\"", 2, "split.metric", "unknown word \"kerrr\""},
    {"[split]\nmetric = \"ellis\"\nthroat = 0", 3, "split.throat", "allowed: [0.01, 100]"},
    {"[split]\nmetric = \"ellis\"\ncharge = 1", 3, "split.charge", "no parameter of metric \"ellis\""},
    {"[split]\nmetric = \"neutron-star\"\nradius = 20", 2, "camera.r", "a static camera cannot be at 15"},
    {"[split]\ncharge = 1", 2, "split.charge", "no parameter of metric \"schwarzschild\""},
    // Camera
    {"[camera]\nr = 1.0", 2, "camera.r", "on or inside the horizon; allowed: r > 1"},
    {"[camera]\nr = 0.3", 2, "camera.r", "allowed: r > 1"},
    {"[camera]\nr = 0", 2, "camera.r", "cannot be at 0, on or inside the horizon; allowed: r > 1"},
    {"[camera]\nr = -3", 2, "camera.r", "allowed: r > 1"},
    {"[camera]\nr = -2e9", 2, "camera.r", "-2000000000 is out of range; allowed: [-1000000000, 1000000000]"},
    {"[spacetime]\nmetric = \"minkowski\"\n[camera]\nr = -3", 4, "camera.r",
     "a static camera cannot be at -3; allowed: r > 0"},
    {"[spacetime]\nmetric = \"reissner-nordstrom\"\ncharge = -0.1", 3, "spacetime.charge", "allowed: [0, 3]"},
    {"[far_sky]\nkind = \"image\"", 2, "far_sky.image", "missing, but kind = \"image\""},
    {"[camera]\nr = nan", 2, "camera.r", "must be finite"},
    {"[camera]\nr = -inf", 2, "camera.r", "must be finite"},
    {"[camera]\nr = \"5\"", 2, "camera.r", "must be a number, not a string"},
    {"[camera]\nr = true", 2, "camera.r", "must be a number, not a boolean"},
    {"[camera]\nr = 2020-01-01", 2, "camera.r", "must be a number, not a date or time"},
    {"[camera]\nr = [5]", 2, "camera.r", "must be a number, not an array"},
    {"[camera]\ntheta = 181", 2, "camera.theta", "allowed: [0, 180]"},
    {"[camera]\ntheta = -1e-9", 2, "camera.theta", "allowed: [0, 180]"},
    {"[camera]\nyaw = 1e300", 2, "camera.yaw", "allowed: [-3600, 3600]"},
    {"[camera]\nphi = inf", 2, "camera.phi", "must be finite"},
    {"[camera]\npitch = \"up\"", 2, "camera.pitch", "must be a number"},
    {"[camera]\nroll = {}", 2, "camera.roll", "must be a number, not a table"},
    {"[camera]\nfov = 0", 2, "camera.fov", "allowed: (0, 360]"},
    {"[camera]\nfov = 180", 2, "camera.fov", "too wide for a pinhole"},
    {"[camera]\nfov = 200\nprojection = \"pinhole\"", 2, "camera.fov", "too wide for a pinhole"},
    {"[camera]\nprojection = \"cube\"\nsize = [64, 64]", 3, "camera.size",
     "allowed: [192, 128], any three columns and two"},
    {"[camera]\nprojection = \"cube\"\nshift_x = 0.1", 3, "camera.shift_x", "allowed: 0 where projection"},
    {"[camera]\nprojection = \"cube\"\npixel_aspect = 2", 3, "camera.pixel_aspect", "allowed: 1 where projection"},
    {"[camera]\nprojection = \"fisheye\"\nfov = 9", 3, "camera.fov", "allowed: [10, 360]"},
    {"[camera]\nprojection = \"fisheye\"\nplane_width = 1", 3, "camera.plane_width", "is not used here"},
    {"[camera]\nprojection = \"cylindrical\"\n[zoom]", 2, "camera.projection",
     "[zoom] requires projection = \"pinhole\""},
    {"[camera]\nprojection = \"fisheye\"\n[split]\nmetric = \"kerr\"", 2, "camera.projection", "[split] requires"},
    {"[medium]\nkind = \"grid\"\n[object]\nname = \"m87\"", 2, "medium.file", "missing, but kind = \"grid\""},
    {"[medium]\nfile = \"none.grid\"", 2, "medium.file", "there is no file"},
    {"[medium]\nkind = \"gas\"\nfile = \"broken/warp-short.data\"", 3, "medium.file", "is not used here"},
    {"[spacetime]\nmetric = \"kerr\"\n[medium]\nkind = \"grid\"\nfile = \"broken/warp-short.data\"\n[object]\nname = "
     "\"m87\"",
     5, "medium.file", "line 1 of \"warp-short.data\": the line \"nullscope-medium\" is expected here"},
    {"[object]\nname = \"m87\"\n[medium]\nkind = \"formula\"\nemission = \"synchrotron\"\nfield_direction = \"file\"",
     6, "medium.field_direction", "file where kind = \"grid\""},
    {"[object]\nname = \"m87\"\n[medium]\nkind = \"jet\"\ninner = 0.9", 5, "medium.inner", "allowed: above 1"},
    {"[medium]\nkind = \"jet\"\nemission = \"black-body\"\nouter = 3", 4, "medium.outer", "allowed: inner < outer"},
    {"[medium]\nkind = \"jet\"\nemission = \"black-body\"\nfalloff = -9\nouter = 1e5", 4, "medium.falloff",
     "at most 1e+30 at medium.outer"},
    {"[medium]\nkind = \"jet\"\nopening = 90", 3, "medium.opening", "allowed: [0.5, 80]"},
    {"[medium]\nkind = \"jet\"\nlorentz = nan", 3, "medium.lorentz", "allowed: [1, 1000]"},
    {"[object]\nname = \"m87\"\n[medium]\nkind = \"flow\"\nflattening = 1000\nstep = 0.05", 6, "medium.step",
     "allowed: at least"},
    {"[medium]\nkind = \"gas\"\nlorentz = 2", 3, "medium.lorentz", "kind = \"jet\""},
    {"[camera]\nwarp = \"none.data\"", 2, "camera.warp", "there is no file"},
    {"[camera]\nwarp = \"broken/warp-short.data\"\n[zoom]", 2, "camera.warp", "cannot be combined with [zoom]"},
    {"[camera]\nwarp = 3", 2, "camera.warp", "a warp mesh file, relative to the scene file"},
    {"[path]\nkind = \"keys\"\n[[path.key]]\n[[path.key]]\nprojection = \"fisheye\"", 1, "path.key", "projection"},
    {"[camera]\nfov = 60\nplane_width = 1", 2, "camera.fov", "says the same as camera.plane_width"},
    {"[camera]\nfocal_distance = 1\nfov = 60", 3, "camera.fov", "says the same as camera.focal_distance"},
    {"[camera]\nplane_width = 0", 2, "camera.plane_width", "out of range"},
    {"[camera]\nfocal_distance = -1", 2, "camera.focal_distance", "out of range"},
    {"[camera]\nsize = [1280]", 2, "camera.size", "must be two integers, not 1"},
    {"[camera]\nsize = 1280", 2, "camera.size", "must be two integers, not an integer"},
    {"[camera]\nsize = [1280.0, 720]", 2, "camera.size", "the first is a floating-point number"},
    {"[camera]\nsize = [0, 720]", 2, "camera.size", "0 is out of range; allowed: two integers from 1 to 65536"},
    {"[camera]\nsize = [16, 65537]", 2, "camera.size", "65537 is out of range"},
    {"[camera]\nsize = [16, 9223372036854775807]", 2, "camera.size", "out of range"},
    {"[camera]\nvelocity = 0.5", 2, "camera.velocity", "must be three numbers"},
    {"[camera]\nvelocity = [0.5, 0]", 2, "camera.velocity", "must be three numbers, not 2"},
    {"[camera]\nvelocity = [0, nan, 0]", 2, "camera.velocity", "component 2 is not a finite number"},
    {"[camera]\nvelocity = [0, 0, \"c\"]", 2, "camera.velocity", "component 3 is not a finite number"},
    {"[camera]\nvelocity = [1, 0, 0]", 2, "camera.velocity", "light; allowed: three numbers, speed below 1"},
    {"[camera]\nvelocity = [0.8, 0.6, 0.1]", 2, "camera.velocity", "not below that of light"},
    {"[camera]\nvelocity = [1e308, 1e308, 0]", 2, "camera.velocity", "not below that of light"},
    {"[camera]\nexposure = 31", 2, "camera.exposure", "allowed: [-30, 30]"},
    // Sky
    {"[sky]\nkind = \"star\"", 2, "sky.kind",
     "(nearest: stars); allowed: stars, image, black, nebula, points, plain, checker, grid, stripes, noise or formula"},
    {"[sky]\nkind = 1", 2, "sky.kind", "must be a string"},
    {"\n[sky]\nkind = \"image\"", 3, "sky.image", "missing, but kind = \"image\""},
    {"[sky]\nkind = \"image\"\nimage = \"no-such.png\"", 3, "sky.image", "there is no file \"no-such.png\""},
    {"[sky]\nkind = \"image\"\nimage = \"/\"", 3, "sky.image", "there is no file \"/\""},
    {"[sky]\nkind = \"image\"\nimage = \"\"", 3, "sky.image", "there is no file"},
    {"[sky]\nkind = \"image\"\nimage = \"a\\u0000b\"", 3, "sky.image", "control characters"},
    {"[sky]\nimage = \"CMakeLists.txt\"", 2, "sky.image", "with kind = \"image\" only"},
    {"[sky]\nkind = \"black\"\nmapping = \"equirectangular\"", 3, "sky.mapping", "with kind = \"image\" only"},
    {"[camera]\neye_distance = 0.1", 2, "camera.eye_distance", "is not used here"},
    {"[camera]\nstereo = \"all-round\"", 2, "camera.stereo", "allowed: projection = \"equirectangular\""},
    {"[camera]\nstereo = \"pair\"\n[zoom]", 2, "camera.stereo", "stereo cannot be combined with [zoom]"},
    {"[camera]\nstereo = \"pair\"\n[split]\nmetric = \"kerr\"", 2, "camera.stereo",
     "stereo cannot be combined with [split]"},
    {"[camera]\nstereo = \"pair\"\n[picture]\nauto_exposure = \"on\"", 2, "camera.stereo", "its own exposure"},
    {"[camera]\nr = 4\nstereo = \"pair\"\neye_distance = 2.1", 4, "camera.eye_distance", "allowed: at most 2 here"},
    {"[camera]\nr = 1.0001\nstereo = \"pair\"\nyaw = 90\neye_distance = 0.1", 5, "camera.eye_distance", "no eye"},
    {"[path]\nkind = \"keys\"\n[[path.key]]\n[[path.key]]\nstereo = \"pair\"", 1, "path.key", "stereo"},
    {"[sky]\nkind = \"image\"\nimage = \"CMakeLists.txt\"\nmapping = \"cube\"", 4, "sky.mapping", "word \"cube\""},
    {"[sky]\nkind = \"image\"\nimage = \"CMakeLists.txt\"\nmapping = \"band-and-caps\"", 4, "sky.north_cap", "missing"},
    {"[sky]\nkind = \"image\"\nimage = \"CMakeLists.txt\"\nnorth_cap = \"CMakeLists.txt\"", 4, "sky.north_cap",
     "with mapping = \"band-and-caps\" only"},
    {"[sky]\nband_latitude = 40", 2, "sky.band_latitude", "with mapping = \"band-and-caps\" only"},
    {"[sky]\nband_latitude = 90", 2, "sky.band_latitude", "allowed: (0, 90)"},
    {"[sky]\nbrightness = -1", 2, "sky.brightness", "allowed: [0, 1000000]"},
    {"[sky]\ntilt = nan", 2, "sky.tilt", "must be finite"},
    // Disc
    {"[disc]\ninner = 12", 2, "disc.inner", "inner = 12 is not below outer = 12; allowed: inner < outer"},
    {"[disc]\nouter = 2", 2, "disc.outer", "inner = 3 is not below outer = 2"},
    {"[disc]\nouter = 5\ninner = 6", 3, "disc.inner", "inner = 6 is not below outer = 5"},
    {"[disc]\ninner = 0", 2, "disc.inner", "out of range"},
    {"[disc]\nouter = 1e7", 2, "disc.outer", "out of range"},
    {"[disc]\nopacity = -0.01", 2, "disc.opacity", "allowed: [0, 1]"},
    {"[disc]\nopacity = 1.01", 2, "disc.opacity", "allowed: [0, 1]"},
    {"[disc]\nedge = 0.51", 2, "disc.edge", "allowed: [0, 0.5]"},
    {"[disc]\nimage = \"no-such.png\"", 2, "disc.image", "there is no file"},
    {"[disc]\nimage = 3", 2, "disc.image", "must be a string"},
    {"[disc]\nrotation = \"x\"", 2, "disc.rotation", "must be a number"},
    {"[disc]\nbrightness = inf", 2, "disc.brightness", "must be finite"},
    // Text
    {"name = 5", 1, "name", "must be a string"},
    {"name = \"a\\nb\"", 1, "name", "control characters"},
    {"description = \"\\u001b[31m\"", 1, "description", "control characters"},
    {"description = \"" + std::string(201, 'x') + "\"", 1, "description", "201 bytes are too long"},
};

}  // namespace

TEST_CASE("every broken scene is refused in one line that names file, line and key") {
    // Its CMakeLists.txt serves as an image: none is opened.
    const std::filesystem::path base = nullscope::test::data_folder();
    for (const Broken& broken : kBroken) {
        const Result<Scene> scene = parse_scene(broken.text, "dir/scene.toml", base);
        CAPTURE(broken.text.substr(0, 100));
        REQUIRE_FALSE(scene);
        const std::string& message = scene.error().message();
        CAPTURE(message);
        CHECK(scene.error().kind == ErrorKind::kBadInput);
        const std::string key = broken.key.empty() ? "" : broken.key + ": ";
        CHECK(message.starts_with(fmt::format("dir/scene.toml:{}: {}", broken.line, key)));
        CHECK(message.find(broken.part) != std::string::npos);
        CHECK(message.find_first_of("\n\r\x1b"s + '\0') == std::string::npos);
        CHECK(message.size() < 500);
    }
}

TEST_CASE("every projection takes its fields of view, and refuses others with their range") {
    for (int i = 1; i < kProjections; ++i) {
        const ProjectionRow& row = projection_row(static_cast<Projection>(i));
        if (row.faces) continue;
        const double least = row.field.least * 180.0 / M_PI, most = row.field.most * 180.0 / M_PI;
        const auto read = [&](double fov) {
            return parse_scene(fmt::format("[camera]\nprojection = \"{}\"\nfov = {:.12g}\n", row.name, fov),
                               "scene.toml", nullscope::test::data_folder());
        };
        CAPTURE(row.name);
        for (const double fov : {least, row.field.usual * 180.0 / M_PI, row.field.below ? most - 1e-3 : most})
            CHECK(read(fov));
        for (const double fov : {0.9 * least, row.field.below ? most : 1.001 * most}) {
            const auto refused = read(fov);
            REQUIRE_FALSE(refused);
            const std::string range = fmt::format("[{:.0f}, {:.0f}{}", least, most, row.field.below ? ')' : ']');
            CHECK(refused.error().message().starts_with("scene.toml:3: camera.fov: "));
            if (fov <= 360.0) CHECK(refused.error().message().find("allowed: " + range) != std::string::npos);
        }
    }
}
