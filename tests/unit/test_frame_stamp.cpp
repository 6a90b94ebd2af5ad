// Stamps of films: equal for equal input, another for any change of scene, size, options or an image's contents.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "cli/frame_store.h"
#include "plan/body_kind.h"
#include "scenefile/scene_keys.h"
#include "scenefile/sections.h"

using namespace nullscope;
using namespace nullscope::cli;

namespace {

struct Run {
    Scene scene, other;
    CaptureOptions options;
    std::string method = "strip", version = "1.0";
    double first_time = 0;
    bool split = false;

    std::string stamp() const {
        return frame_stamp({scene, split ? &other : nullptr, options, method, first_time, version});
    }
};

Run full_run() {
    Run run;
    run.options.output = "film.mp4";
    for (const Section& section : sections())
        if (section.optional()) section.add(run.scene);
    return run;
}

// Another value of one key of the scene, drawn by chance.
void change_key(Scene& scene, std::mt19937& random) {
    const auto keys = scene_keys();
    const SceneKey& key = keys[random() % keys.size()];
    if (full_name(key) == "path.file" || full_name(key) == "format")  // what it names is in other keys; of the file
        return change_key(scene, random);
    KeyValue value;
    value.number =
        key.range.low + (key.range.high - key.range.low) * std::uniform_real_distribution<double>(0.01, 0.99)(random);
    value.vector = {value.number, 0.5, 0.25};
    value.width = 2000000 + static_cast<int>(random() % 1000000), value.height = 7;
    value.choice = key.member.readable() && key.member.get(scene).choice == 1 ? 0 : 1;
    value.text = fmt::format("text {}", random());
    value.path = fmt::format("none {}.png", random());
    key.member.set(scene, value);
}

}  // namespace

TEST_CASE("a hundred random changes of scene and options: each gives another stamp, equal runs an equal one") {
    std::mt19937 random(19);
    int changes = 0;
    while (changes < 100) {
        Run run = full_run();
        const std::string before = run.stamp();
        CHECK(before == full_run().stamp());
        const auto number = 1 + static_cast<int>(random() % 16);
        switch (random() % 16) {
            case 0: run.options.renderer = "reference"; break;
            case 1: run.options.context = "osmesa"; break;
            case 2: run.options.raydata = true; break;
            case 3: run.options.time_step = number; break;
            case 4: run.options.largest_texture = 16 * number; break;
            case 5: run.options.output = "film%05d.exr"; break;
            case 6: run.method = fmt::format("euler:{}", number); break;
            case 7: run.first_time = number; break;
            case 8: run.version = "1.1"; break;
            case 9: run.split = true; break;
            case 10: run.scene.camera.width += number; break;
            case 11: run.options.plain = true; break;
            case 12: run.options.quality = number; break;
            case 13: run.options.bits = "16", run.options.output = "film%05d.png"; break;
            default: change_key(run.scene, random);
        }
        CAPTURE(changes);
        CAPTURE(stamp_difference(before, run.stamp()));
        CHECK(run.stamp() != before);
        ++changes;
    }
}

TEST_CASE("stamps hold the samples of the reference, the contents of images, and the scene beside") {
    Run run = full_run();
    run.options.renderer = "reference";
    const std::string three = run.stamp();
    run.options.samples = 3;  // the default
    CHECK(run.stamp() == three);
    run.options.samples = 2;
    CHECK(stamp_difference(three, run.stamp()) == "different --samples");

    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("nullscope-stamp-{}", std::random_device()());
    std::filesystem::create_directories(folder);
    const auto write = [](const std::filesystem::path& file, const char* text) { std::ofstream(file) << text; };
    write(folder / "a.png", "one"), write(folder / "b.png", "one"), write(folder / "c.png", "two");
    const auto with_image = [&](const char* name) {
        Run other = full_run();
        other.scene.sky.image = folder / name;
        return other.stamp();
    };
    CHECK(with_image("a.png") == with_image("b.png"));
    CHECK(stamp_difference(with_image("a.png"), with_image("c.png")) == "different sky.image");
    std::filesystem::remove_all(folder);

    Run split = full_run();
    split.split = true;
    const std::string before = split.stamp();
    split.other.camera.r = 5;
    split.other.sky.kind = SkyKind::kGrid;
    CHECK(stamp_difference(before, split.stamp()) == "different --split camera.r, --split sky.kind");
    CHECK(stamp_difference("", before) == "they have no stamp");
}

TEST_CASE("names of a sequence's files have one place for the number") {
    const auto name = [](const char* pattern, int frame) {
        const auto names = FrameNames::parse(pattern);
        return names ? names->of(frame) : names.error().message();
    };
    CHECK(name("a%05d.png", 12) == "a00012.png");
    CHECK(name("a%d.png", 12) == "a12.png");
    CHECK(name("a%4d.png", 12) == "a0012.png");
    CHECK(name("a%02d.png", 123) == "a123.png");
    CHECK(name("x/#####.exr", 7) == "x/00007.exr");
    CHECK(name("100%_%d.png", 7) == "100%_7.png");
    for (const char* pattern : {"a.png", "%d%d.png", "#a#.png", "%s.png", "%d/a.png", "%010d.png", "##########.png"})
        CHECK(name(pattern, 0).find("allowed: names with one of") != std::string::npos);
    CHECK(FrameNames::parse("x/a%d.png")->stamp_file() == "x/a.png.stamp");
    CHECK(FrameNames::parse("x/%05d.png")->stamp_file() == "x/frames.png.stamp");
}
