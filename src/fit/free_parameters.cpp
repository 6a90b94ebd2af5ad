#include "fit/free_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assets.h"
#include "base/text.h"
#include "scenefile/key_place.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_override.h"
#include "spacetime/registry.h"

namespace nullscope::fit {
namespace {

constexpr const char* kFreeWords = "KEY=LOW:HIGH, as in --free spin=0:0.99,camera.theta=10:80";
constexpr double kBetween = 0.381966;  // of a range: a place that is no whole number

Error bad_free(const std::string& words, const std::string& what, const std::string& allowed = kFreeWords) {
    return bad_input(without_controls(fmt::format("--free {}: {}", words, what)), allowed);
}

// A key without a section, but for those that scene files have there, is a parameter of the metric.
std::string whole_key(const std::string& key) {
    const bool at_top = std::ranges::any_of(
        scene_keys(), [&](const SceneKey& known) { return known.section.empty() && known.key == key; });
    return key.find('.') == std::string::npos && !at_top ? "spacetime." + key : key;
}

Result<FreeParameter> parse_one(const std::string& words) {
    const std::size_t equals = words.find('=');
    if (equals == std::string::npos || equals == 0) return bad_free(words, "no key and its range");
    const std::vector<std::string> ends = split(words.substr(equals + 1), ':');
    if (ends.size() != 2) return bad_free(words, "no range");
    const auto low = parse_number(ends[0]), high = parse_number(ends[1]);
    if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high)) return bad_free(words, "no range of numbers");
    if (!(*low < *high)) return bad_free(words, "the range is empty");
    return FreeParameter{whole_key(trim(words.substr(0, equals))), *low, *high, true, words};
}

// The key that was meant by a word without a section; empty: nobody knows.
std::string meant(const std::string& word, const MetricEntry& metric) {
    std::vector<std::string> keys, names;
    for (const MetricParameter& parameter : metric.parameters)
        keys.emplace_back(parameter.name), names.emplace_back(parameter.name);
    for (const SceneKey& key : scene_keys())
        if (key.type == KeyType::kNumber) keys.push_back(full_name(key)), names.emplace_back(key.key);
    const auto found = std::ranges::find(names, nearest_word(word, names));
    return found == names.end() ? "" : keys[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace

Result<std::vector<FreeParameter>> parse_free(const std::string& words) {
    std::vector<FreeParameter> free;
    for (const std::string& part : split(words, ',')) {
        TRY(one, parse_one(trim(part)));
        if (std::ranges::any_of(free, [&](const FreeParameter& other) { return other.key == one->key; }))
            return bad_free(words, one->key + " is there twice", "each key once");
        free.push_back(std::move(*one));
    }
    if (free.size() > kMostParameters)
        return bad_free(words, fmt::format("{} parameters", free.size()), fmt::format("at most {}", kMostParameters));
    return free;
}

Result<SceneFamily> SceneFamily::open(std::string scene, const std::vector<std::string>& set,
                                      std::vector<FreeParameter> free) {
    TRY(overrides, parse_overrides(set));
    TRY(as_it_is, load_scene(scene, note_on_terminal, *overrides));
    SceneFamily family;
    family.read_ = [scene = std::move(scene), set = std::move(*overrides)](const SceneOverrides& more) {
        SceneOverrides all = set;
        all.insert(all.end(), more.begin(), more.end());
        return load_scene(
            scene, [](const std::string&) {}, all);
    };
    return family.with(std::move(free));
}

Result<SceneFamily> SceneFamily::of_text(std::string text, std::vector<FreeParameter> free) {
    SceneFamily family;
    family.read_ = [text = std::move(text)](const SceneOverrides& overrides) {
        return parse_scene_in({assets_directory() / "scenes"}, text, "scene", overrides);
    };
    TRY(as_it_is, family.read_({}));
    return family.with(std::move(free));
}

Result<SceneFamily> SceneFamily::with(std::vector<FreeParameter> more) const {
    SceneFamily family = *this;
    family.free_.insert(family.free_.end(), more.begin(), more.end());
    TRY(named, family.check_names());
    TRY(good, family.check());
    return family;
}

// A word without a section that is no parameter of the scene's metric.
Status SceneFamily::check_names() const {
    for (const FreeParameter& one : free_) {
        const std::string word = trim(one.words.substr(0, one.words.find('=')));
        if (word.empty() || word == one.key || one.key != whole_key(word)) continue;
        TRY(scene, read_({}));
        const MetricEntry* metric = find_metric(scene->spacetime.metric);
        if (metric == nullptr ||
            std::ranges::find(metric->parameters, word, &MetricParameter::name) != std::ranges::end(metric->parameters))
            continue;
        const std::string hint = meant(word, *metric);
        return bad_free(
            one.words,
            fmt::format("no parameter of metric \"{}\"{}", metric->key,
                        hint.empty() ? "" : fmt::format("; did you mean {}?", hint)),
            "a number of the scene, as in camera.theta=10:80; a metric's by its name alone, as in spin=0:0.99");
    }
    return Done{};
}

// What the reader says of words of --set is said of those of --free.
Error SceneFamily::said_of_free(Error error) const {
    for (const FreeParameter& one : free_) {
        const std::string set = "--set " + one.key + "=";
        for (std::string* part : {&error.file, &error.what})
            if (part->starts_with(set)) {
                const std::size_t end = std::min(part->find(": "), part->size());
                part->replace(0, end, "--free " + (one.words.empty() ? one.key : one.words));
            }
    }
    return error;
}

// Both ends of each range, and a place between, with the others between.
Status SceneFamily::check() const {
    std::vector<double> middle;
    for (const FreeParameter& one : free_) middle.push_back(one.at(kBetween));
    for (std::size_t i = 0; i < free_.size(); ++i)
        for (const double share : {0.0, 1.0, kBetween}) {
            std::vector<double> values = middle;
            values[i] = free_[i].at(share);
            if (auto scene = at(values); !scene) return scene.error();
        }
    return Done{};
}

Result<Scene> SceneFamily::somewhere() const {
    std::vector<double> values;
    for (const FreeParameter& one : free_) values.push_back(one.at(0.5));
    return at(values);
}

Result<Scene> SceneFamily::at(const std::vector<double>& values) const {
    SceneOverrides overrides;
    for (std::size_t i = 0; i < free_.size(); ++i) overrides.push_back({free_[i].key, fmt::format("{}", values[i])});
    auto scene = read_(overrides);
    return scene ? std::move(scene) : Result<Scene>(said_of_free(scene.error()));
}

}  // namespace nullscope::fit
