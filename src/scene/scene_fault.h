// What is wrong with a scene whose values are each within their range.
#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"

namespace nullscope {

struct SceneFault {
    std::string key;  // full name ("ball[2].radius"), or a section
    std::string what, allowed;
    std::string at{};  // the key or section that calls for `key`, where a file does not have that
};

// Of a key that names a file which cannot be used. wanted: what may stand there, where the error does not say so.
SceneFault file_fault(const std::string& key, const std::filesystem::path& file, const Error& error,
                      const std::string& wanted);

}  // namespace nullscope
