// Scenes that pictures hold: the words that a picture says of how it was drawn, written and read.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "base/result.h"
#include "scene/scene.h"
#include "scenefile/scene_file.h"

namespace nullscope {

// What a picture was drawn from. "Whatever changes the picture is in its metadata": what is new here and changes one belongs here.
struct PictureOrigin {
    Scene scene;  // with the size and the time that were drawn
    SceneFolders folders;
    std::optional<Scene> split{};  // beside it, where the scene itself does not say it
    SceneFolders split_folders{};
    std::string options{};       // of capture, those that change the picture and are not in the scene
    std::string renderer{};      // the driver, or the reference tracer
    std::optional<int> frame{};  // of a sequence or film
    std::string version{};       // of the program
    std::vector<double>
        times{};  // of the moments that it shows, where they are not the scene's alone; of a film's pictures
};

// The list that every writer of pictures uses, by keyword: docs/command-line.md, "What a picture says". It has neither dates nor names of machines,
// and no path but those that the scene names, as it names them. Reads the scene's files (base/sha256.h). Errors: a file cannot be read.
Result<std::map<std::string, std::string>> picture_words(const PictureOrigin& origin);

// The same of a displayed picture, with the XMP of a panorama (scenefile/photo_sphere.h).
Result<std::map<std::string, std::string>> displayed_picture_words(const PictureOrigin& origin);

// The scene of a picture's words under that keyword. file: the picture. Files are looked for beside the picture, in the current folder, and beside the scenes
// that ship; one whose hash is not the one in the words is said to note. Errors (bad input): the picture holds no scene, those of parse_scene.
Result<Scene> scene_of_words(const std::map<std::string, std::string>& words, const std::string& keyword,
                             const std::string& file, const Note& note, const SceneOverrides& overrides = {});
SceneFolders picture_folders(const std::filesystem::path& file);

// The scene of a picture. Errors: those of scene_of_words and load_texts (image/picture_texts.h).
Result<OpenedScene> open_picture(const std::string& file, const Note& note, const SceneOverrides& overrides = {});

inline constexpr const char* kSceneWord = "nullscope.scene_text";
inline constexpr const char* kSplitWord = "nullscope.split_text";
inline constexpr const char* kOptionsWord = "nullscope.options";
inline constexpr const char* kFrameWord = "nullscope.frame";
inline constexpr const char* kFilesWord = "nullscope.files";

}  // namespace nullscope
