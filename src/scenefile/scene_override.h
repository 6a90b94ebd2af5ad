// Values in the place of a scene file's, as a command line gives them: camera.theta=30, ball[2].radius=3, disc.emission=thermal; what has no value is
// left out: spacetime.spin=, disc=, ball[2]=.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

struct SceneOverride {
    std::string key;  // with its section; number i of several: ball[i].radius
    std::string
        value;  // as in a scene file; what is no TOML value is a text, whose quotes may be left out; empty: no value
    std::string words() const { return key + "=" + value; }
};
using SceneOverrides = std::vector<SceneOverride>;

// Of "KEY=VALUE" or "KEY=". Errors (bad input): no key, no "=".
Result<SceneOverride> parse_override(const std::string& words);
Result<SceneOverrides> parse_overrides(const std::vector<std::string>& words);

}  // namespace nullscope
