// Finds the file and line of a key when an error is found only after the scene was read, for example while it is drawn.
#pragma once
#include <filesystem>
#include <string>
#include <utility>

#include "base/result.h"
#include "scenefile/scene_file.h"

namespace nullscope {

// With the file and the line of its key, or of its section where the file does not have it. Errors that are not of a scene's key, and those
// of a file that is no scene (a picture that holds one), stay as they are. Cost: reads the file again.
Error placed_in_scene(Error error, const std::filesystem::path& file);

// What a command says of a scene, by the name that it was given (open_scene()).
template <class T>
Result<T> of_scene(const std::string& file_or_name, Result<T> result) {
    return result ? std::move(result) : Result<T>(placed_in_scene(result.error(), scene_path(file_or_name)));
}

}  // namespace nullscope
