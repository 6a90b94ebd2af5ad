// Values in the place of a scene file's, as a command line gives them: camera.theta=30, ball[2].radius=3, disc.emission=thermal.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

struct SceneOverride {
    std::string key;    // with its section; number i of several: ball[i].radius
    std::string value;  // as in a scene file; what is no TOML value is a text, whose quotes may be left out
    std::string words() const { return key + "=" + value; }
};
using SceneOverrides = std::vector<SceneOverride>;

// Of "KEY=VALUE". Errors (bad input): no key, no value.
Result<SceneOverride> parse_override(const std::string& words);
Result<SceneOverrides> parse_overrides(const std::vector<std::string>& words);

}  // namespace nullscope
