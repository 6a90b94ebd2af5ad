#include "scenefile/scene_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "scenefile/sections.h"

namespace nullscope {
namespace {

std::string canonical_words(const SceneKey& key, const KeyValue& value) {
    if (!value.there) return "missing";
    switch (key.type) {
        case KeyType::kNumber: return fmt::format("{:.17g}", value.number);
        case KeyType::kNumbers: return fmt::format("{:.17g}", fmt::join(value.numbers, " "));
        case KeyType::kVelocity:
        case KeyType::kPoint:
        case KeyType::kColour:
            return fmt::format("{:.17g} {:.17g} {:.17g}", value.vector.x, value.vector.y, value.vector.z);
        case KeyType::kWhole: return fmt::format("{}", value.width);
        case KeyType::kSize: return fmt::format("{} {}", value.width, value.height);
        case KeyType::kChoice: return fmt::format("{}", value.choice);
        case KeyType::kFile: return value.path.string();
        case KeyType::kText:
        case KeyType::kMetric:
        case KeyType::kFormula: break;
    }
    return value.text;
}

}  // namespace

std::vector<SceneLine> scene_lines(const Scene& scene) {
    std::vector<SceneLine> lines;
    const auto add_section = [&](std::string_view section, const std::string& label, const Scene& holder) {
        for (const SceneKey& key : keys_of(section)) {
            if (!key.member.readable()) continue;
            const KeyValue value = key.member.get(holder);
            lines.push_back({label.empty() ? std::string(key.key) : fmt::format("{}.{}", label, key.key),
                             canonical_words(key, value), value.path});
        }
    };
    const auto add_parameters = [&](const std::string& section, const SpacetimeSpec& spec) {
        for (const auto& [name, value] : spec.parameters)
            lines.push_back({fmt::format("{}.{}", section, name), fmt::format("{:.17g}", value), {}});
        for (const auto& [name, text] : spec.parameters.formulas)
            lines.push_back({fmt::format("{}.{}", section, name), text, {}});
    };
    for_each_section(scene, [&](const Section& section, const std::string& label, const Scene& holder) {
        add_section(section.name, label, holder);
    });
    for (const Section& section : sections())
        if (section.spacetime && count_of(scene, section) > 0)
            add_parameters(std::string(section.name), section.spacetime.of(scene));
    for (std::size_t i = 0; scene.path && i < scene.path->keys.size(); ++i) {
        const PathKey& key = scene.path->keys[i];
        const std::string label = fmt::format("path.key[{}]", i);
        lines.push_back({label + ".frame", fmt::format("{:.17g}", key.frame), {}});
        lines.push_back({label + ".time", fmt::format("{:.17g}", key.time), {}});
        for (std::size_t k = 0; k < key.values.size(); ++k)
            lines.push_back(
                {fmt::format("{}.set.{}", label, scene.path->keyed[k]), fmt::format("{:.17g}", key.values[k]), {}});
        Scene there;
        there.camera = key.camera;
        add_section("camera", label, there);
        if (key.camera.zoom) add_section("zoom", label, there);
    }
    return lines;
}

}  // namespace nullscope
