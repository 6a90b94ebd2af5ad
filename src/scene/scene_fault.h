// What is wrong with a scene whose values are each within their range.
#pragma once
#include <string>

namespace nullscope {

struct SceneFault {
    std::string key;  // full name ("ball[2].radius"), or a section
    std::string what, allowed;
    std::string at{};  // the key or section that calls for `key`, where a file does not have that
};

}  // namespace nullscope
