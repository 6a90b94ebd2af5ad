// What is said of one key of a scene file, in one row: its place, type, range, default, help, and when it has a meaning.
#pragma once
#include <string>
#include <string_view>

#include "scene/key_member.h"
#include "scene/scene.h"

namespace nullscope {

// kVelocity, kPoint, kColour: an array of 3 numbers. kSize: an array of 2 integers. kWhole: an integer. kFile: a file, relative
// to the scene file. kFormula: an expression (docs/expressions.md) of the variables in SceneKey::choices. kNumbers: a number, or an array
// of up to kMostNumbers, in ascending order unless SceneKey::any_order.
enum class KeyType {
    kNumber,
    kVelocity,
    kPoint,
    kColour,
    kSize,
    kWhole,
    kChoice,
    kText,
    kFile,
    kMetric,
    kFormula,
    kNumbers
};
inline constexpr std::size_t kMostNumbers = 16;

struct KeyRange {
    double low = 0, high = 0;
    bool open_low = false, open_high = false;  // the end itself is not allowed
    bool contains(double value) const {        // false for NaN
        return (open_low ? value > low : value >= low) && (open_high ? value < high : value <= high);
    }
};

constexpr KeyRange closed(double low, double high) { return {low, high, false, false}; }
constexpr KeyRange open(double low, double high) { return {low, high, true, true}; }
inline constexpr KeyRange kPositive{0.0, 1e6, true, false};     // of lengths and times
inline constexpr KeyRange kAnyAngle = closed(-3600.0, 3600.0);  // ten turns: digits are left after reduction
inline constexpr KeyRange kBrightness = closed(0.0, 1e6);
inline constexpr KeyRange kNoRange{};
inline constexpr std::string_view kOrbitSenses = "eastward westward prograde retrograde";  // as OrbitSense

struct SceneKey {
    std::string_view section;  // "" for the top level
    std::string_view key;
    KeyType type;
    std::string_view unit = {};      // of the file: "deg", "r_s", ...; degrees become radians in Scene
    std::string_view fallback = {};  // default, as it would be written in a file; "" for none
    KeyRange range = {};             // kNumber, kNumbers, in the file's unit; arrays: of every number
    std::string_view choices =
        {};  // kChoice: words separated by one blank; kFormula: variables; kFile: what the file is, "" an image
    std::string_view help = {};             // one sentence
    KeyMember member = {};                  // of what a scene may have several of: of the last
    bool (*meant)(const Scene&) = nullptr;  // whether the key means anything in this scene; null: in every one ...
    std::string_view with = {};             // ... and else with what, for the message: "kind = \"image\""
    bool needed = false;                    // and whether it must be there then
    bool series = false;     // kFile: a placeholder for a number in the name stands for several (base/numbered_files.h)
    bool any_order = false;  // kNumbers
};

// A row of a key that is on or off: fallback says which by default.
constexpr SceneKey on_off_key(std::string_view section, std::string_view key, std::string_view fallback,
                              std::string_view help, KeyMember member, bool (*meant)(const Scene&) = nullptr,
                              std::string_view with = {}) {
    return {section, key, KeyType::kChoice, "", fallback, {}, "off on", help, member, meant, with};
}

inline constexpr double kFastestCamera = 1.0 - 1e-12;  // so that 1 - v^2 keeps digits
inline constexpr std::size_t kLongestText = 200;       // bytes of name and description

std::string full_name(const SceneKey& key);     // "camera.r", "name"
std::string allowed_text(const SceneKey& key);  // "(0, 180)", "stars, image or black", ...

}  // namespace nullscope
