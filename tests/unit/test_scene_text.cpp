// The canonical text of a scene changes with every key of a scene file, and with nothing else.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "plan/body_kind.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_text.h"
#include "scenefile/sections.h"

using namespace nullscope;

namespace {

// Every section is there, so that every key has a place.
Scene full_scene() {
    Scene scene;
    for (const Section& section : sections())
        if (section.optional()) section.add(scene);
    scene.disc->accretion.emplace();
    scene.path->keys = {{0.0, {}}, {1.0, {}}};
    return scene;
}

std::string text_of(const Scene& scene) {
    std::string text;
    for (const SceneLine& line : scene_lines(scene)) text += fmt::format("{} = {}\n", line.name, line.value);
    return text;
}

// A value of a kind's own; two draws differ in what the key reads, but for choices of few words.
KeyValue random_value(const SceneKey& key, std::mt19937& random, int choice) {
    const auto unit = [&] { return std::uniform_real_distribution<double>()(random); };
    const auto number = [&] { return key.range.low + (key.range.high - key.range.low) * unit(); };
    KeyValue value;
    value.number = number();
    value.vector = {unit(), unit(), unit()};
    value.numbers = {number(), number()};
    value.width = static_cast<int>(random() % 1000000), value.height = static_cast<int>(random() % 1000000);
    value.choice = choice;
    value.text = fmt::format("text {}", random());
    value.path = fmt::format("image {}.png", random());
    return value;
}

}  // namespace

TEST_CASE("the canonical text of a scene changes with every key of the table, by a line of its name") {
    std::mt19937 random(20);
    for (const SceneKey& key : scene_keys()) {
        CAPTURE(full_name(key));
        if (full_name(key) == "path.file") continue;  // what it names is in other keys
        if (full_name(key) == "format") continue;     // of the file
        Scene one = full_scene(), other = full_scene();
        key.member.set(one, random_value(key, random, 0));
        key.member.set(other, random_value(key, random, 1));
        const auto a = scene_lines(one), b = scene_lines(other);
        REQUIRE(a.size() == b.size());
        std::vector<std::string> changed;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (a[i].value != b[i].value || a[i].name != b[i].name) changed.push_back(a[i].name);
        REQUIRE_FALSE(changed.empty());
        const std::string name = full_name(key) == "camera.fov" ? "camera.plane_width" : full_name(key);
        for (const std::string& line : changed)
            CHECK((line == name || (name == "camera.projection" && line == "camera.plane_width")));
    }
}

TEST_CASE("the canonical text of a scene holds what may be missing, parameters, keys of the path and files") {
    const Scene bare;
    const std::string text = text_of(bare);
    CHECK(text == text_of(Scene{}));
    const auto differs = [&](auto change) {
        Scene scene;
        change(scene);
        return text_of(scene) != text;
    };
    CHECK(differs([](Scene& s) { s.disc.emplace(); }));
    CHECK(differs([](Scene& s) { s.sky.temperature_K = 5772.0; }));
    CHECK(differs([](Scene& s) { s.spacetime.parameters["charge"] = 0.1; }));
    CHECK(differs([](Scene& s) { s.spacetime.parameters.formulas["A"] = "1 - 2/r"; }));
    CHECK(differs([](Scene& s) { s.camera.r = std::nextafter(s.camera.r, 100.0); }));
    CHECK(differs([](Scene& s) { s.path.emplace(); }));
    Scene keys = full_scene();
    const std::string before = text_of(keys);
    keys.path->keys[1].camera.yaw = 0.5;
    CHECK(text_of(keys) != before);
    keys.sky.image = "stars.png";
    const auto lines = scene_lines(keys);
    CHECK(std::count_if(lines.begin(), lines.end(), [](const SceneLine& line) { return line.file == "stars.png"; }) ==
          1);
}
