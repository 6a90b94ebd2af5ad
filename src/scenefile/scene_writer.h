// Scene to the text of a scene file: what parse_scene makes the same Scene of (scenefile/scene_text.h), with only what differs from the
// defaults. Comments of a file that the scene came from are not in it.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "scenefile/scene_folders.h"

namespace nullscope {

// base_directory: of the file that will hold it; images within it are written relative to it. Numbers have as many digits as it takes to
// read the same ones; angles that no number of degrees gives exactly are the next one, off by a rounding.
std::string scene_file_text(const Scene& scene, const std::filesystem::path& base_directory);

// The same, every number exact: angles that no number of degrees gives as "1.0471975511965976 rad".
std::string exact_scene_text(const Scene& scene, const std::filesystem::path& base_directory);

// The same as a picture holds it: exact too, and paths as path_in() has them.
struct WrittenScene {
    std::string text;
    std::vector<std::pair<std::string, std::filesystem::path>>
        files;  // that it names: as written, and where they are; each once
};
WrittenScene written_scene(const Scene& scene, const SceneFolders& folders);

// The whole scene as one line, "scene = { camera = { r = 15 }, ... }", that scene_of_line() reads (scenefile/scene_file.h). Images are
// named by their absolute paths.
std::string scene_line(const Scene& scene);

// A number of degrees, and a camera's field of view in degrees, as they are written.
std::string degrees_text(double radians);
std::string field_of_view_text(const CameraSpec& camera);

// A camera as one line of a scene file, "camera = { r = 15, fov = 60 }", with what differs from the defaults. The picture's size is not in it.
std::string view_line(const CameraSpec& camera);

}  // namespace nullscope
