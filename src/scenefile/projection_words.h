// What the key table says of all projections, from their rows, joined when it is compiled.
#pragma once
#include <array>
#include <string_view>

#include "scene/projection_table.h"

namespace nullscope {

struct ProjectionWords {
    std::array<char, 1000> text{};
    std::size_t size = 0;
    constexpr void add(std::string_view words) {
        for (const char c : words) text[size++] = c;
    }
    constexpr void add_degrees(double angle) {
        int degrees = 0;  // rounded: std::lround is not constexpr
        while (degrees + 0.5 <= angle * 180.0 / M_PI) ++degrees;
        for (int place = degrees >= 100 ? 100 : degrees >= 10 ? 10 : 1; place > 0; place /= 10)
            text[size++] = static_cast<char>('0' + degrees / place % 10);
    }
    constexpr void add_range(const FieldOfView& field) {
        add(field.least > 0.0 ? "[" : "(");
        add_degrees(field.least), add(", "), add_degrees(field.most);
        add(field.below ? ")" : "]");
    }
    constexpr std::string_view view() const { return {text.data(), size}; }
};

// "pinhole fisheye ..."
inline constexpr ProjectionWords kProjectionChoices = [] {
    ProjectionWords words;
    for (const ProjectionRow* row : kProjectionRows) words.add(words.size > 0 ? " " : ""), words.add(row->name);
    return words;
}();

// Help of camera.projection: "... pinhole; fisheye (azimuthal equidistant, ...); ..."
inline constexpr ProjectionWords kProjectionHelp = [] {
    ProjectionWords words;
    words.add("How directions are laid out: ");
    for (const ProjectionRow* row : kProjectionRows) {
        words.add(row == kProjectionRows[0] ? "" : "; "), words.add(row->name);
        if (!row->is.empty()) words.add(" ("), words.add(row->is), words.add(")");
    }
    words.add(".");
    return words;
}();

// Help of camera.fov: of each projection its range and default.
inline constexpr ProjectionWords kFieldOfViewHelp = [] {
    ProjectionWords words;
    words.add("Horizontal field of view, of a fisheye across the smaller side of the picture. Range and default: ");
    for (const ProjectionRow* row : kProjectionRows) {
        if (row->faces) continue;
        words.add(row == kProjectionRows[0] ? "" : "; "), words.add(row->name), words.add(" ");
        words.add_range(row->field), words.add(", "), words.add_degrees(row->field.usual);
    }
    words.add(".");
    return words;
}();

}  // namespace nullscope
