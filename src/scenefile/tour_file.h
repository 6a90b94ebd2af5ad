// Tour files: TOML text to Tour, a list of views with words about each (docs/tours.md).
//
// Errors are those of scene files (scenefile/scene_file.h): one line, "FILE:LINE: step[2].view: what is wrong; allowed: ...". Of several
// faults the first in the file is reported. All input is taken as hostile: control characters never reach a message or a step's text.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plan/effects.h"
#include "scene/scene.h"

namespace nullscope {

inline constexpr std::size_t kMostTourSteps = 100;
inline constexpr std::size_t kLongestTourText = 2000;  // bytes, of a step

struct TourStep {
    std::string scene;               // what load_scene takes
    std::optional<CameraSpec> view;  // else the scene's camera; without a size
    EffectSet off;                   // switched off; the scene calls for each
    std::string text;                // paragraphs, one a line
};

struct Tour {
    std::string title, description;
    std::vector<TourStep> steps;  // 1 to kMostTourSteps
};

// Whether a file is a tour and no scene: TOML with `step` or `title` at its top level. False for what cannot be read.
bool is_tour_file(const std::filesystem::path& file);

// Every step is checked: its scene is loaded, its view is a camera there. Cost: that of load_scene for each scene.
// Errors: kBadInput; the file cannot be read or is larger than kLargestSceneFile, and those of parse_tour.
Result<Tour> load_tour(const std::filesystem::path& file);

// file_label: named in errors. base_directory: what scene files are relative to.
Result<Tour> parse_tour(std::string_view toml_text, const std::string& file_label,
                        const std::filesystem::path& base_directory);

struct TourInfo {
    std::filesystem::path path;
    std::string title, description;  // of a broken file its name, and the error
    std::size_t steps = 0;           // 0: broken
};
// Those in assets_directory()/tours, sorted by file name; empty if there is no such directory.
std::vector<TourInfo> shipped_tours();

}  // namespace nullscope
