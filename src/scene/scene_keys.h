// The keys of a scene file: the one table that the reader checks against, that errors quote and that docs/scenes.md
// shows. A key is added by one row (and its line in docs/scenes.md, which a test asks for). The parameters of a metric
// are not here: they come from the registry of spacetimes and are keys of [spacetime] too.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace nullscope {

// kVelocity, kPoint, kColour: an array of 3 numbers. kSize: an array of 2 integers. kWhole: an integer. kImage: a file, relative
// to the scene file. kFormula: an expression (docs/expressions.md) of the variables in SceneKey::choices.
enum class KeyType { kNumber, kVelocity, kPoint, kColour, kSize, kWhole, kChoice, kText, kImage, kMetric, kFormula };

struct KeyRange {
    double low = 0, high = 0;
    bool open_low = false, open_high = false;  // the end itself is not allowed
    bool contains(double value) const {        // false for NaN
        return (open_low ? value > low : value >= low) && (open_high ? value < high : value <= high);
    }
};

// A checked value, in the units of Scene.
struct KeyValue {
    double number = 0;
    Vec3 vector;
    int width = 0, height = 0;  // kSize; kWhole: width
    int choice = 0;             // index in SceneKey::choices
    std::string text;
    std::filesystem::path path;  // resolved against the scene file's folder
};

struct SceneKey {
    std::string_view section;  // "" for the top level
    std::string_view key;
    KeyType type;
    std::string_view unit;      // of the file: "deg", "r_s", ...; degrees become radians in Scene
    std::string_view fallback;  // default, as it would be written in a file; "" for none
    KeyRange range;             // kNumber, in the file's unit; arrays: of every number
    std::string_view choices;   // kChoice: words separated by one blank; kFormula: variables
    std::string_view help;      // one sentence
    void (*apply)(Scene&, const KeyValue&);
};

inline constexpr double kFastestCamera = 1.0 - 1e-12;  // so that 1 - v^2 keeps digits
inline constexpr std::size_t kLongestText = 200;       // bytes of name and description

std::span<const SceneKey> scene_keys();
KeyRange key_range(std::string_view full_name);  // of a key that the program names
std::string full_name(const SceneKey& key);      // "camera.r", "name"
std::string allowed_text(const SceneKey& key);   // "(0, 180)", "stars, image or black", ...

}  // namespace nullscope
