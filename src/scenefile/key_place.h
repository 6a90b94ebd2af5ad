// Finds the file and line of a key when an error is found only after the scene was read, for example while it is drawn.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "scenefile/scene_file.h"

namespace nullscope {

// With the file and the line of its key, or of its section where the file does not have it; of a key that the command line gave (overrides), these
// words instead. Errors that are not of a scene's key, and those of a file that is no scene (a picture that holds one), stay as they are. Cost: reads
// the file again.
Error placed_in_scene(Error error, const std::filesystem::path& file, const SceneOverrides& overrides = {});

// What a command says of a scene, by the name that it was given (open_scene()), and the words of its --set.
template <class T>
Result<T> of_scene(const std::string& file_or_name, const std::vector<std::string>& set, Result<T> result) {
    if (result) return result;
    const auto overrides = parse_overrides(set);
    return placed_in_scene(result.error(), scene_path(file_or_name), overrides ? *overrides : SceneOverrides());
}

}  // namespace nullscope
