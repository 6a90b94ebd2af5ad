// Words of the command line that several subcommands, or the fuzz targets, read.
#pragma once
#include <fmt/format.h>

#include <string>

#include "base/result.h"
#include "base/text.h"
#include "scene/picture_size.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {

struct Size {
    int width, height;
};
// "1280x720"; each side 1 ... 65536.
inline Result<Size> parse_size(const std::string& text) {
    if (const auto size = two_whole_numbers(text, 'x', 1, 65536)) return Size{size->first, size->second};
    return bad_input(fmt::format("--size {}: not a size", text), "WIDTHxHEIGHT, whole numbers from 1x1 to 65536x65536");
}
// The scene, of this picture size where one is given.
inline Result<Scene> sized(Scene scene, const std::string& size_text) {
    if (size_text.empty()) return scene;
    TRY(size, parse_size(size_text));
    if (projection_of(scene.camera).faces && !holds_cube(size->width, size->height))
        return bad_input(
            fmt::format("--size {}: {} x {} px do not hold a cube's faces", size_text, size->width, size->height),
            fmt::format("{}, {}", cube_size_words(size->width, size->height, "x"), kCubeSizes));
    set_size(scene, size->width, size->height);
    return scene;
}
// By its file or name.
inline Result<Scene> load_scene_sized(const std::string& name, const std::string& size_text) {
    TRY(scene, load_scene(name));
    return sized(std::move(*scene), size_text);
}

// "A:B", the half-open range of frame numbers; 0 <= A < B.
struct Frames {
    int first = 0, end = 1;
};
inline Result<Frames> parse_frames(const std::string& text) {
    const auto range = two_whole_numbers(text, ':', 0, 1e8);
    if (range && range->first < range->second) return Frames{range->first, range->second};
    return bad_input(fmt::format("--frames {}: not a range", text), "A:B, whole numbers with 0 <= A < B");
}

}  // namespace nullscope::cli
