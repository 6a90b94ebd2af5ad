// The little of JSON that is written: objects, lists of them, and both inside objects (raw).
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace nullscope::cli {

inline std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", c);
        else
            out += c;
    }
    return out + "\"";
}

// Keys in the order they were added.
class JsonObject {
public:
    JsonObject& add(std::string_view key, double value) {
        return raw(key, std::isfinite(value) ? fmt::format("{:.6g}", value) : "null");
    }
    JsonObject& add(std::string_view key, long long value) { return raw(key, fmt::format("{}", value)); }
    JsonObject& add(std::string_view key, int value) { return add(key, static_cast<long long>(value)); }
    JsonObject& add(std::string_view key, std::string_view value) { return raw(key, json_text(value)); }
    JsonObject& raw(std::string_view key, const std::string& json) {
        body_ += fmt::format("{}{}: {}", body_.empty() ? "" : ", ", json_text(key), json);
        return *this;
    }
    std::string text() const { return "{" + body_ + "}"; }

private:
    std::string body_;
};

// In one line, to stand inside an object.
inline std::string json_array(const std::vector<JsonObject>& objects) {
    std::string out = "[";
    for (std::size_t i = 0; i < objects.size(); ++i) out += (i == 0 ? "" : ", ") + objects[i].text();
    return out + "]";
}

// A whole file, one object a line.
inline std::string json_list(const std::vector<JsonObject>& objects) {
    std::string out = "[";
    for (std::size_t i = 0; i < objects.size(); ++i) out += (i == 0 ? "\n  " : ",\n  ") + objects[i].text();
    return out + "\n]\n";
}

}  // namespace nullscope::cli
