#include "scene/scene_key.h"

#include <fmt/format.h>

#include <vector>

#include "base/numbered_files.h"
#include "base/text.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    }
    return list;
}

}  // namespace

std::string full_name(const SceneKey& key) {
    return key.section.empty() ? std::string(key.key) : fmt::format("{}.{}", key.section, key.key);
}

std::string allowed_text(const SceneKey& key) {
    const KeyRange& range = key.range;
    switch (key.type) {
        case KeyType::kNumber:
            return fmt::format("{}{}, {}{}", range.open_low ? '(' : '[', range.low, range.high,
                               range.open_high ? ')' : ']');
        case KeyType::kNumbers:
            return fmt::format("[{}, {}], or up to {} of these{}", range.low, range.high, kMostNumbers,
                               key.any_order ? "" : " in ascending order");
        case KeyType::kVelocity: return "three numbers, speed below 1";
        case KeyType::kPoint:
        case KeyType::kColour: return fmt::format("three numbers from {} to {}", range.low, range.high);
        case KeyType::kWhole: return fmt::format("an integer from {} to {}", range.low, range.high);
        case KeyType::kFormula: return fmt::format("a formula of {}", list_of(split(key.choices, ' ')));
        case KeyType::kSize: return fmt::format("two integers from {} to {}", range.low, range.high);
        case KeyType::kChoice: return list_of(split(key.choices, ' '));
        case KeyType::kText: return fmt::format("one line of at most {} bytes", kLongestText);
        case KeyType::kFile:
            return fmt::format("{} file, relative to the scene file{}",
                               key.choices.empty() ? "an image" : fmt::format("a {}", key.choices),
                               key.series ? fmt::format(", or several with {} in the name", kNumberPlaces) : "");
        case KeyType::kMetric: break;
    }
    std::vector<std::string> metrics;
    for (const MetricEntry& entry : metric_registry()) metrics.emplace_back(entry.key);
    return list_of(metrics);
}

}  // namespace nullscope
