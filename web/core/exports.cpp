#include "core/exports.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace nullscope::web {

std::string& answer() {
    static std::string text;
    return text;
}
bool answer(std::string text) { return answer() = std::move(text), true; }
bool answer(const Status& status) {
    answer() = status ? "" : status.error().message();
    return static_cast<bool>(status);
}

std::string in_json(std::string_view text) {
    std::string json = "\"";
    for (const char c : text)
        if (c == '"' || c == '\\')
            json += {'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20)
            json += fmt::format("\\u{:04x}", c);
        else
            json += c;
    return json + "\"";
}

NULLSCOPE_EXPORT(answer_data) const char* answer_data() { return answer().data(); }
NULLSCOPE_EXPORT(answer_size) std::size_t answer_size() { return answer().size(); }
NULLSCOPE_EXPORT(allocate) void* allocate(std::size_t bytes) { return std::malloc(bytes); }
NULLSCOPE_EXPORT(release) void release(void* bytes) { std::free(bytes); }

}  // namespace nullscope::web
