// Statements of a ray's march for one body, number i (shaders/object/march.glsl).
#pragma once
#include <fmt/format.h>

#include <string>

namespace nullscope {

// How far body i is, or that it is near.
inline std::string clear_statement(const std::string& away) {
    return fmt::format(
        "    next = {};\n    if (!(next >= near)) bodies = with_bit(i, bodies);\n"
        "    if (!bit_in(i, bodies)) away.x = min(away.x, next);\n    away.y = min(away.y, next);\n",
        away);
}

// Body i is added to a set unless it is farther than the way.
inline std::string list_statement(const std::string& away, const char* set) {
    return fmt::format("    if (!({0} > way)) {1} = with_bit(i, {1});\n", away, set);
}

}  // namespace nullscope
