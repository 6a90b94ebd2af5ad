#include "scene/scene_fault.h"

#include <fmt/format.h>

#include "base/text.h"

namespace nullscope {

SceneFault file_fault(const std::string& key, const std::filesystem::path& file, const Error& error,
                      const std::string& wanted) {
    const std::string name = in_quotes(without_controls(file.filename().string()));
    const std::string at = error.line > 0 ? fmt::format("line {} of {}: ", error.line, name) : "";
    return {key, at + error.what, error.allowed.empty() ? wanted : error.allowed, key};
}

}  // namespace nullscope
