// Matter of dumps: what is between two of them, what is read and kept, and what is refused.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "plan/moving.h"
#include "scene/medium_dumps.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"
#include "support/medium_dumps.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

const std::string kHole = "[spacetime]\nmetric = \"schwarzschild\"\n[object]\nmass_suns = 4e6\n",
                  kKind = "[medium]\nkind = \"grid\"\nouter = 8\n",
                  kDumps = kKind + "file = \"flow-%05d.grid\"\ncadence = 2.5\nstart = 10\n";

}  // namespace

TEST_CASE("medium dumps: between two each number of a node is linear in time, logarithms of density and temperature") {
    const TemporaryFolder folder("dumps-between");
    write_spot_dumps(folder.path);
    const GridMatter dumps = spot_dumps(folder.path);
    for (const double part : {0.0, 0.25, 0.5, 0.9}) {
        const int dump = 7;
        const auto form = spot_form();
        const auto mean = MediumGrid::parse(grid_bytes(form,
                                                       [&](double r, double theta, double phi) {
                                                           return mean_node(spot_node(dump, r, theta, phi),
                                                                            spot_node(dump + 1, r, theta, phi), part);
                                                       }),
                                            "mean");
        REQUIRE(mean);
        const auto grid = medium_grid_at(dumps, kSpotStart + (dump + part) * kSpotCadence);
        REQUIRE(grid);
        REQUIRE((*grid)->numbers().size() == mean->numbers().size());
        CHECK((*grid)->other_nodes(*mean) == nullptr);
        double off = 0;
        for (std::size_t n = 0; n < mean->numbers().size(); ++n) {
            const auto is = static_cast<double>((*grid)->numbers()[n]), was = static_cast<double>(mean->numbers()[n]);
            off = std::max(off, std::abs(is - was) / (1 + std::abs(was)));
        }
        CHECK(off < 1e-6);
        if (part == 0) CHECK((*grid)->numbers() == mean->numbers());
    }
}

TEST_CASE("medium dumps: in a film each is read once, two are kept at most, and what is between them") {
    const TemporaryFolder folder("dumps-kept");
    write_spot_dumps(folder.path);
    const GridMatter dumps = spot_dumps(folder.path);
    constexpr int kSteps = 4;  // from dump to dump
    const long long before = dumps_read();
    std::vector<std::weak_ptr<const MediumGrid>> seen;  // each dump at its own time, and all that was between
    for (int i = 0; i <= kSteps * (kSpotDumps - 1); ++i) {
        const auto grid = medium_grid_at(dumps, kSpotStart + i * kSpotCadence / kSteps);
        REQUIRE(grid);
        const auto again = medium_grid_at(dumps, kSpotStart + i * kSpotCadence / kSteps);
        REQUIRE(again);
        CHECK(*again == *grid);
        seen.push_back(*grid);
        const auto alive = std::ranges::count_if(seen, [](const auto& one) { return !one.expired(); });
        CHECK(alive <= 3);
        CHECK(dumps_read() - before == i / kSteps + (i % kSteps != 0 ? 2 : 1));
    }
    CHECK(dumps_read() - before == kSpotDumps);
    // A file that has changed is read again.
    const auto last = spot_file(folder.path, kSpotDumps - 1);
    const auto old = medium_grid_at(dumps, dump_times(dumps).to);
    REQUIRE(write_text_atomically(
        last, grid_bytes(spot_form(), [](double, double, double) { return GridNode{1, 1, 1, 1, 1, 0, 0, 0}; })));
    std::filesystem::last_write_time(last, std::filesystem::last_write_time(last) + std::chrono::seconds(2));
    const auto fresh = medium_grid_at(dumps, dump_times(dumps).to);
    REQUIRE(fresh);
    CHECK(*fresh != *old);
    CHECK((*fresh)->node(0, 0, 0)[0] == 0.0f);
}

TEST_CASE("medium dumps: two scenes keep their own") {
    const TemporaryFolder one("dumps-one"), other("dumps-other");
    write_spot_dumps(one.path), write_spot_dumps(other.path);
    const long long before = dumps_read();
    for (int i = 0; i < 5; ++i)
        for (const TemporaryFolder* folder : {&one, &other})
            REQUIRE(medium_grid_at(spot_dumps(folder->path), kSpotStart + 0.1 * i));
    CHECK(dumps_read() - before == 4);
}

TEST_CASE("medium dumps: a scene finds the first and the last, and its times") {
    const TemporaryFolder folder("dumps-scene");
    write_spot_dumps(folder.path);
    REQUIRE(write_text_atomically(folder.path / "flow-7.grid", "of another name"));
    const auto scene = parse_scene("time = 12\n" + kHole + kDumps, "film.toml", folder.path);
    REQUIRE(scene);
    const GridMatter& grid = scene->medium->grid;
    CHECK(grid == spot_dumps(folder.path));
    CHECK(has_dumps(*scene));
    CHECK(dump_times(grid).from == 10);
    CHECK(dump_times(grid).to == 10 + 11 * 2.5);
    CHECK(dump_words(grid) == "12 dumps, 3 to 14, at times [10, 37.5] r_s/c");
    CHECK(dumps_about(grid, 12) == std::vector{spot_file(folder.path, 0), spot_file(folder.path, 1)});
    CHECK(dumps_about(grid, 12.5 + 1e-12) == std::vector{spot_file(folder.path, 1)});
    CHECK(moving_parts(*scene).empty());  // fast light
    CHECK(changes_with_time(*scene));
    const auto again = parse_scene(scene_file_text(*scene, folder.path), "film.toml", folder.path);
    REQUIRE(again);
    CHECK(again->medium == scene->medium);
    const auto part = parse_scene("time = 12\n" + kHole + kDumps + "first = 5\nlast = 8", "film.toml", folder.path);
    REQUIRE(part);
    CHECK(part->medium->grid.first == 5);
    CHECK(dump_times(part->medium->grid).to == 17.5);
    for (const char* pattern : {"flow-%5d.grid", "flow-#####.grid"}) {
        std::string text = kDumps;
        text.replace(text.find("flow-%05d.grid"), 14, pattern);
        CHECK(parse_scene("time = 12\n" + kHole + text, "film.toml", folder.path));
    }
}

TEST_CASE("medium dumps: what is refused, in one line with file, key and what is allowed") {
    const TemporaryFolder folder("dumps-faults");
    write_spot_dumps(folder.path);
    const auto said = [&](const std::string& text) {
        const auto scene = parse_scene(text, "film.toml", folder.path);
        return scene ? std::string("good") : scene.error().message();
    };
    const auto holds = [&](const std::string& text, const std::vector<std::string>& parts) {
        const std::string message = said(text);
        CAPTURE(message);
        CHECK(message.starts_with("film.toml:"));
        CHECK(message.find('\n') == std::string::npos);
        for (const std::string& part : parts) {
            CAPTURE(part);
            CHECK(message.find(part) != std::string::npos);
        }
    };
    const std::string good = "time = 12\n" + kHole + kDumps;
    CHECK(said(good) == "good");
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    // Numbers, times, placeholders
    holds(changed("time = 12", "time = 9.9"),
          {"film.toml:1: time: 9.9 is not between", "allowed: [10, 37.5] r_s/c, of dumps 3 to 14"});
    holds(changed("time = 12", "time = 37.6"), {"time: 37.6 is not between", "[10, 37.5]"});
    holds(changed("time = 12\n", ""), {"time: 0 is not between", "[10, 37.5]"});
    holds(changed("cadence = 2.5\n", ""), {"medium.cadence: missing", "allowed: "});
    holds(changed("cadence = 2.5", "cadence = 0"), {"medium.cadence", "(0, 1000000]"});
    holds(good + "first = 5\nlast = 4", {"medium.last: 4 is below first = 5"});
    holds(good + "last = 15", {"medium.file: there is no file \"flow-00015.grid\"",
                               "all of \"flow-00003.grid\" to \"flow-00015.grid\", or other first and last"});
    holds(good + "first = -1", {"medium.first", "an integer from 0 to 999999999"});
    holds(changed("%05d", "%03d"), {"medium.file: there is no file \"flow-%03d.grid\""});
    holds(changed("%05d", "%05d%d"), {"medium.file", "placeholder", "one of %05d, %d or ##### (up to 9 digits)"});
    holds(changed("%05d", "%020d"), {"medium.file", "placeholder", "one of %05d, %d or #####"});
    // One file
    const std::string one = "time = 12\n" + kHole + kKind + "file = \"flow-00003.grid\"\n";
    CHECK(said(one) == "good");
    for (const std::string key : {"first = 3", "last = 3", "cadence = 1", "start = 0"})
        holds(one + key,
              {"medium." + key.substr(0, key.find(' ')) + ": is not used here", "with file = \"NAME%05d.grid\" only"});
    // Files
    const auto dump = spot_file(folder.path, 4);
    const std::string bytes = *read_text(dump);
    GridForm form = spot_form();
    form.polar = 8;
    REQUIRE(write_text_atomically(dump, grid_bytes(form, [](double, double, double) { return GridNode{1, 1}; })));
    holds(good, {"medium.file: \"flow-00007.grid\" has other nodes of theta than \"flow-00003.grid\"",
                 "allowed: the same coordinates, spin and nodes in all dumps"});
    form = spot_form(), form.spin = 0.5;
    REQUIRE(write_text_atomically(dump, grid_bytes(form, [](double, double, double) { return GridNode{1, 1}; })));
    holds(good, {"\"flow-00007.grid\" has other spin than"});
    REQUIRE(write_text_atomically(dump, bytes.substr(0, bytes.size() - 4)));
    holds(good, {"medium.file: line 7 of \"flow-00007.grid\": 64508 bytes follow", "64512 of 2016 nodes"});
    REQUIRE(write_text_atomically(dump, "nullscope-medium 2\n"));
    holds(good, {"line 1 of \"flow-00007.grid\": another version"});
    std::filesystem::remove(dump);
    holds(good, {"medium.file: there is no file \"flow-00007.grid\""});
    std::filesystem::create_directory(dump);
    holds(good, {"medium.file: \"flow-00007.grid\" is not a regular file"});
    std::filesystem::remove(dump);
    REQUIRE(::mkfifo(dump.c_str(), 0600) == 0);
    holds(good, {"medium.file: \"flow-00007.grid\" is not a regular file"});
    std::filesystem::remove(dump);
    // Numbers, which are looked at when they are read
    REQUIRE(write_text_atomically(dump, grid_bytes(spot_form(), [](double, double, double) { return GridNode{-1}; })));
    CHECK(said(good) == "good");
    holds(changed("time = 12", "time = 20"),
          {"medium.file: line 7 of \"flow-00007.grid\": density of node (0, 0, 0) is -1"});
}
