// JSON that is written: keys in the order they were added, numbers with six digits, what is not finite as null.
#pragma once
#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "base/atomic_file.h"

namespace nullscope::cli {

using Json = nlohmann::ordered_json;

inline void round_numbers(Json& json) {
    if (json.is_number_float()) json = std::strtod(fmt::format("{:.6g}", json.get<double>()).c_str(), nullptr);
    if (json.is_structured())
        for (Json& inner : json) round_numbers(inner);
}

inline std::string json_text(Json json) {
    round_numbers(json);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Where no file is named, nothing.
inline Status write_json(const std::string& file, const Json& json) {
    return file.empty() ? Status(Done{}) : write_text_atomically(file, json_text(json));
}

}  // namespace nullscope::cli
