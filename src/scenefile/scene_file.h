// Scene files: TOML text to Scene. The keys, their units, defaults and ranges are the table in scenefile/scene_keys.h.
//
// Every error is one line, "FILE:LINE: section.key: what is wrong; allowed: ... (nearest known key: ...)", of kind
// kBadInput (without a line where there is none: a file that cannot be read). Of several faults the first in the file
// is reported. All input is taken as hostile: control characters of a file never reach a message.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scenefile/scene_folders.h"
#include "scenefile/scene_override.h"

namespace nullscope {

inline constexpr std::size_t kLargestSceneFile = 1u << 20;  // bytes

// Who is told what people should know of a file that is read.
using Note = std::function<void(const std::string& line)>;
void note_on_terminal(const std::string& line);

// A path, or the name of a scene that ships: assets_directory()/scenes/NAME.toml. A file of that name goes first. Of a picture (by what is in
// it: PNG, JPEG, EXR, FITS) the scene that it holds (scenefile/picture_scene.h).
// Errors: no such file or scene (nearest named), not a regular file, too large, a picture without a scene, and those of parse_scene.
struct OpenedScene {
    Scene scene;
    SceneFolders folders;                        // what its paths are relative to
    std::map<std::string, std::string> words{};  // of a picture: all that it says of itself
};
std::filesystem::path scene_path(const std::string& file_or_name);
// overrides: values in the place of the file's; files in them are looked for where the scene's are.
Result<OpenedScene> open_scene(const std::string& file_or_name, const Note& note = note_on_terminal,
                               const SceneOverrides& overrides = {});
Result<Scene> load_scene(const std::string& file_or_name, const Note& note = note_on_terminal,
                         const SceneOverrides& overrides = {});
// What the paths of that scene are relative to, whatever is in the file: its folder, else that of the scenes that ship, so that the text of one
// holds anywhere.
SceneFolders scene_folders(const std::string& file_or_name);

// file_label: named in errors, and its stem is the scene's name where the text gives none. base_directory, folders: what
// relative image paths are relative to; image files must exist but are not opened.
Result<Scene> parse_scene(std::string_view toml_text, const std::string& file_label,
                          const std::filesystem::path& base_directory);
Result<Scene> parse_scene_in(const SceneFolders& folders, std::string_view toml_text, const std::string& file_label,
                             const SceneOverrides& overrides = {});

// Of scene_line()'s text (scenefile/scene_writer.h); what follows the line is left out. is_scene_line: whether it begins like one.
bool is_scene_line(std::string_view text);
Result<Scene> scene_of_line(std::string_view line);

struct SceneInfo {
    std::string name;         // what load_scene takes
    std::string title;        // the scene's own name; of a broken file as `name`
    std::string description;  // one sentence; the error where the file is broken
    std::filesystem::path path;
};
// The scenes in assets_directory()/scenes, sorted by name; empty if there is no such directory.
std::vector<SceneInfo> shipped_scenes();

// These in the order and the groups of assets_directory()/gallery/groups.toml; those that are in no group come last, as "Others".
struct SceneGroup {
    std::string title;
    std::vector<SceneInfo> scenes;
};
std::vector<SceneGroup> in_gallery_groups(std::vector<SceneInfo> scenes);

}  // namespace nullscope
