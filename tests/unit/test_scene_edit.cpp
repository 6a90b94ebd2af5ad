// Scenes changed key by key: every key of every scene that ships, sections that come and go, what is refused.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "scene/bodies.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_text.h"
#include "scenefile/sections.h"
#include "support/costly.h"

using namespace nullscope;

namespace {

Scene shipped(const char* name) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    return *scene;
}

std::string canonical(const Scene& scene) {
    std::string text;
    for (const SceneLine& line : scene_lines(scene)) text += fmt::format("{} = {}\n", line.name, line.value);
    return text;
}

const SceneKey& key_of(std::string_view section, std::string_view name) {
    for (const SceneKey& key : scene_keys())
        if (key.section == section && key.key == name) return key;
    FAIL("no key " << section << "." << name);
    std::abort();
}

SectionRef section_of(const Scene& scene, std::string_view label) {
    for (SectionRef& at : scene_sections(scene))
        if (at.label == label) return at;
    FAIL("no section " << label);
    std::abort();
}

}  // namespace

TEST_CASE("scene edit: a key that gets the value it has leaves every scene as it is" * test::costly()) {
    for (const SceneInfo& info : shipped_scenes()) {
        CAPTURE(info.name);
        const Scene scene = shipped(info.name.c_str());
        for (const SectionRef& at : scene_sections(scene)) {
            const Scene holder = section_holder(scene, at);
            int edits = 0;
            for (const SceneKey& key : scene_keys()) {
                if (key.section != at.section || !key.member.readable() || key.type == KeyType::kMetric) continue;
                if (key.meant != nullptr && !key.meant(holder)) continue;
                const KeyValue value = key.member.get(holder);
                if (!value.there || ++edits > 3) continue;
                CAPTURE(full_name(key));
                const auto edited = with_value(scene, at, key, value);
                REQUIRE_MESSAGE(edited, edited.error().message());
                CHECK(canonical(*edited) == canonical(scene));
            }
        }
    }
}

TEST_CASE("scene edit: bodies are added, changed, copied and removed, each by itself") {
    Scene scene = shipped("first-light");
    for (int i = 0; i < 3; ++i) {
        auto more = with_section(scene, "ball");
        REQUIRE_MESSAGE(more, more.error().message());
        scene = *more;
    }
    REQUIRE(scene.bodies.size() == 3);
    KeyValue radius;
    radius.number = 0.75;
    auto edited = with_value(scene, section_of(scene, "ball[2]"), key_of("ball", "radius"), radius);
    REQUIRE_MESSAGE(edited, edited.error().message());
    const auto radius_of = [](const Scene& s, std::size_t i) { return std::get<BallSpec>(s.bodies[i].shape).radius; };
    CHECK(radius_of(*edited, 1) == 0.75);
    CHECK(radius_of(*edited, 0) == radius_of(scene, 0));
    CHECK(radius_of(*edited, 2) == radius_of(scene, 2));
    auto copied = with_copy(*edited, section_of(*edited, "ball[2]"));
    REQUIRE(copied);
    REQUIRE(copied->bodies.size() == 4);
    CHECK(radius_of(*copied, 2) == 0.75);
    auto fewer = without_section(*copied, section_of(*copied, "ball"));
    REQUIRE(fewer);
    REQUIRE(fewer->bodies.size() == 3);
    CHECK(radius_of(*fewer, 0) == 0.75);
}

TEST_CASE("scene edit: sections come and go") {
    for (const std::string& section : optional_sections()) {
        CAPTURE(section);
        const Scene before = shipped("first-light");
        Scene scene = before;
        if (section == "disc") scene.disc.reset();
        if (section == "cap") {  // as a spot needs a disc
            Material& star = add_body<SphereSpec>(scene).material;
            star.temperature_K = 6000, star.colour = {1, 1, 1};
        }
        auto with = with_section(scene, section);
        REQUIRE_MESSAGE(with, with.error().message());
        const SectionRef at = section_of(*with, section);
        auto without = without_section(*with, at);
        REQUIRE(without);
        CHECK(canonical(*without) == canonical(scene));
        CHECK(can_be_added(*with, section) == is_of_several(section));
        CHECK(can_be_added(*without, section));
    }
    CHECK(is_of_several("ball"));
    CHECK_FALSE(is_of_several("zoom"));
    CHECK_FALSE(can_be_added(shipped("first-light"), "camera"));
}

TEST_CASE("scene edit: every section has a row, every row keys, and what can be added says what it is") {
    std::set<std::string_view> names;
    for (const Section& section : sections()) {
        CAPTURE(section.name);
        CHECK(names.insert(section.name).second);
        CHECK_FALSE(keys_of(section.name).empty());
        CHECK(section.optional() == !section.help.empty());
        CHECK(section.optional() == (section.remove != nullptr || section.list != nullptr));
        if (!section.within.empty()) CHECK(find_section(section.within) != nullptr);
    }
    std::size_t keys = 0;
    for (const std::string_view name : names) keys += keys_of(name).size();
    CHECK(keys == scene_keys().size());
}

TEST_CASE("scene edit: what a file may not say is refused, and the message names the key") {
    const Scene scene = shipped("first-light");
    KeyValue value;
    value.number = -2.0;
    const auto refused = with_value(scene, section_of(scene, "disc"), key_of("disc", "inner"), value);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message().starts_with("disc.inner: "));
    value.number = NAN;
    CHECK_FALSE(with_value(scene, section_of(scene, "camera"), key_of("camera", "r"), value));
}
