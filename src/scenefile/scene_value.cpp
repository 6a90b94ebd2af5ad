#include "scenefile/scene_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/numbered_files.h"
#include "base/text.h"
#include "expr/formula.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;
using Checked = Result<KeyValue>;

std::string_view type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table: return "a table";
        case toml::node_type::array: return "an array";
        case toml::node_type::string: return "a string";
        case toml::node_type::integer: return "an integer";
        case toml::node_type::floating_point: return "a floating-point number";
        case toml::node_type::boolean: return "a boolean";
        default: return "a date or time";
    }
}

std::optional<double> finite_number(const toml::node& node) {
    if (!node.is_number()) return std::nullopt;
    const std::optional<double> value = node.value<double>();
    return value && std::isfinite(*value) ? value : std::nullopt;
}

// "1.0471975511965976 rad", as pictures write an angle that no number of degrees gives exactly.
std::optional<double> radians_of(const toml::node& node) {
    constexpr std::string_view kUnit = " rad";
    const toml::value<std::string>* text = node.as_string();
    if (text == nullptr || !text->get().ends_with(kUnit)) return std::nullopt;
    return parse_number(std::string_view(text->get()).substr(0, text->get().size() - kUnit.size()));
}

Checked check_number(const SceneKey& key, const toml::node& node) {
    if (const auto radians = key.unit == "deg" ? radians_of(node) : std::nullopt) {
        if (!std::isfinite(*radians)) return bad_input("must be finite");
        if (!key.range.contains(*radians * 180.0 / std::numbers::pi))
            return bad_input(fmt::format("{} rad is out of range", *radians));
        return KeyValue{.number = *radians};
    }
    if (!node.is_number()) return bad_input(fmt::format("must be a number, not {}", type_name(node)));
    const std::optional<double> number = finite_number(node);
    if (!number) return bad_input("must be finite");
    if (!key.range.contains(*number)) return bad_input(fmt::format("{} is out of range", *number));
    return KeyValue{.number = key.unit == "deg" ? *number * std::numbers::pi / 180.0 : *number};
}

// A number, or an array of them, in ascending order unless the key takes any.
Checked check_numbers(const SceneKey& key, const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr && !node.is_number())
        return bad_input(fmt::format("must be a number or an array of numbers, not {}", type_name(node)));
    if (array == nullptr) {
        SceneKey plain = key;
        plain.unit = {};  // lists of angles stay degrees
        TRY(one, check_number(plain, node));
        return KeyValue{.numbers = {one->number}};
    }
    if (array->empty()) return bad_input("an array without a number");
    if (array->size() > kMostNumbers) return bad_input(fmt::format("{} numbers are too many", array->size()));
    KeyValue value;
    for (const toml::node& item : *array) {
        const std::optional<double> number = finite_number(item);
        if (!number) return bad_input(fmt::format("number {} is not a finite number", value.numbers.size() + 1));
        if (!key.range.contains(*number)) return bad_input(fmt::format("{} is out of range", *number));
        if (key.any_order) {
            value.numbers.push_back(*number);
            continue;
        }
        if (std::ranges::find(value.numbers, *number) != value.numbers.end())
            return bad_input(fmt::format("{} is there twice", *number));
        if (!value.numbers.empty() && *number < value.numbers.back())
            return bad_input(fmt::format("{} comes after {}", *number, value.numbers.back()));
        value.numbers.push_back(*number);
    }
    return value;
}

// An array of that many entries. words: of messages.
Result<const toml::array*> array_of(const toml::node& node, std::size_t count, std::string_view words) {
    const toml::array* array = node.as_array();
    if (array == nullptr) return bad_input(fmt::format("must be {}, not {}", words, type_name(node)));
    if (array->size() != count) return bad_input(fmt::format("must be {}, not {}", words, array->size()));
    return array;
}

// velocity, place or colour
Checked check_vector(const SceneKey& key, const toml::node& node) {
    TRY(array, array_of(node, 3, "three numbers"));
    std::array<double, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> number = finite_number(*(*array)->get(i));
        if (!number) return bad_input(fmt::format("component {} is not a finite number", i + 1));
        v[i] = *number;
        if (key.type != KeyType::kVelocity && !key.range.contains(v[i]))
            return bad_input(fmt::format("{} is out of range", v[i]));
    }
    const Vec3 vector{v[0], v[1], v[2]};
    if (key.type == KeyType::kVelocity && !(length(vector) <= kFastestCamera))
        return bad_input("the speed is not below that of light");
    return KeyValue{.vector = vector};
}

Checked check_whole(const SceneKey& key, const toml::node& node) {
    if (!node.is_integer()) return bad_input(fmt::format("must be an integer, not {}", type_name(node)));
    const double number = node.value<double>().value_or(-1e300);  // integers above 2^53 have no double: out of range
    if (!key.range.contains(number)) return bad_input(fmt::format("{} is out of range", number));
    return KeyValue{.width = static_cast<int>(number)};
}

Checked check_size(const SceneKey& key, const toml::node& node) {
    TRY(array, array_of(node, 2, "two integers"));
    std::array<int, 2> size{};
    for (std::size_t i = 0; i < 2; ++i) {
        const toml::node& item = *(*array)->get(i);
        if (!item.is_integer())
            return bad_input(
                fmt::format("must be two integers, but the {} is {}", i == 0 ? "first" : "second", type_name(item)));
        const double number = item.value<double>().value_or(-1.0);  // integers above 2^53 have no double: out of range
        if (!key.range.contains(number)) return bad_input(fmt::format("{} is out of range", number));
        size[i] = static_cast<int>(number);
    }
    return KeyValue{.width = size[0], .height = size[1]};
}

Checked check_text(const SceneKey& key, const std::string& text, const SceneFolders& folders) {
    KeyValue value;
    value.text = text;
    if (text != without_controls(text)) return bad_input("control characters are not allowed");
    if (key.type == KeyType::kText) {
        if (text.size() > kLongestText) return bad_input(fmt::format("{} bytes are too long", text.size()));
    } else if (key.type == KeyType::kFormula) {
        if (const auto formula = expr::Formula::parse(text, split(key.choices, ' ')); !formula)
            return bad_input(formula.error().what);
    } else if (key.type == KeyType::kFile) {
        const bool several = key.series && names_numbers(fs::path(text).filename().string());
        const auto there = std::ranges::find_if(folders, [&](const fs::path& folder) {
            std::error_code error;
            if (!several) return fs::is_regular_file(folder / text, error);
            const fs::path file = folder / text;
            const auto files = NumberedFiles::parse(file.filename().string(), file.parent_path().string());
            return !files || !files->on_disk().empty();  // of too many placeholders others tell
        });
        if (there == folders.end()) return bad_input(fmt::format("there is no file {}", in_quotes(text)));
        value.path = *there / text;
    } else {
        std::vector<std::string> words = split(key.choices, ' ');
        if (key.type == KeyType::kMetric) {
            words.clear();
            for (const MetricEntry& entry : metric_registry()) words.emplace_back(entry.key);
        }
        const auto found = std::find(words.begin(), words.end(), text);
        const std::string nearest = nearest_word(text, words);
        if (found == words.end())
            return bad_input(fmt::format("unknown word {}{}", in_quotes(text),
                                         nearest.empty() ? "" : fmt::format(" (nearest: {})", nearest)));
        value.choice = static_cast<int>(found - words.begin());
    }
    return value;
}

}  // namespace

Result<KeyValue> check_value(const SceneKey& key, const toml::node& node, const SceneFolders& folders) {
    switch (key.type) {
        case KeyType::kNumber: return check_number(key, node);
        case KeyType::kNumbers: return check_numbers(key, node);
        case KeyType::kVelocity:
        case KeyType::kPoint:
        case KeyType::kColour: return check_vector(key, node);
        case KeyType::kWhole: return check_whole(key, node);
        case KeyType::kSize: return check_size(key, node);
        default: break;
    }
    const toml::value<std::string>* text = node.as_string();
    if (text == nullptr) return bad_input(fmt::format("must be a string, not {}", type_name(node)));
    return check_text(key, text->get(), folders);
}

}  // namespace nullscope
