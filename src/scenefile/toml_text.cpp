#include "scenefile/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "scenefile/scene_file.h"

namespace nullscope {
namespace {

// Dotted keys nest one table a dot, and toml++ frees tables recursively: 50 000 levels overflow the stack. It limits
// arrays and inline tables to 256 levels by itself.
constexpr std::ptrdiff_t kMostDots = 4096;

}  // namespace

Result<toml::table> toml_of(std::string_view text, const std::string& file_label) {
    const auto refuse = [&](const std::string& what, int line) {
        return Error{ErrorKind::kBadInput, without_controls(what), "", "", without_controls(file_label), line};
    };
    if (text.size() > kLargestSceneFile) return refuse(fmt::format("larger than {} bytes", kLargestSceneFile), 0);
    if (std::ranges::count(text, '.') > kMostDots)
        return refuse(fmt::format("more than {} dots: keys could nest too deeply", kMostDots), 1);
    const auto fault = [&](const toml::parse_error& error) {
        return refuse(std::string(error.description()), static_cast<int>(error.source().begin.line));
    };
#if TOML_EXCEPTIONS
    try {
        return toml::table(toml::parse(text));
    } catch (const toml::parse_error& error) {
        return fault(error);
    }
#else
    toml::parse_result parsed = toml::parse(text);
    if (!parsed) return fault(parsed.error());
    return std::move(parsed).table();
#endif
}

Error without_controls(Error error) {
    for (std::string* part : {&error.what, &error.allowed, &error.key, &error.file}) *part = without_controls(*part);
    return error;
}

}  // namespace nullscope
