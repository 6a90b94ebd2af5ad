// Where scenes are found: files, and those that ship by their name.
#include <fmt/format.h>

#include <algorithm>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/text.h"
#include "image/picture_texts.h"
#include "scenefile/picture_scene.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_value.h"
#include "scenefile/toml_text.h"

namespace nullscope {

namespace fs = std::filesystem;

namespace {

fs::path scenes_directory() { return assets_directory() / "scenes"; }

std::vector<fs::path> scene_files() {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator i(scenes_directory(), error), end; !error && i != end; i.increment(error)) {
        if (i->path().extension() == ".toml") files.push_back(i->path());
    }
    std::sort(files.begin(), files.end(),
              [](const fs::path& a, const fs::path& b) { return a.stem() < b.stem(); });  // by the name that is shown
    return files;
}

// Titles and names of scenes; nothing where the file is missing or broken.
std::vector<std::pair<std::string, std::vector<std::string>>> gallery_groups() {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups;
    const Result<std::string> text = read_text(assets_directory() / "gallery" / "groups.toml", kLargestSceneFile);
    if (!text) return groups;
    const Result<toml::table> root = toml_of(*text, "groups.toml");
    const toml::array* tables = root ? (*root)["group"].as_array() : nullptr;
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
        const toml::table* table = (*tables)[i].as_table();
        if (table == nullptr) continue;
        groups.emplace_back((*table)["title"].value_or(std::string()), std::vector<std::string>());
        if (const toml::array* names = (*table)["scenes"].as_array())
            for (const toml::node& name : *names) groups.back().second.push_back(name.value_or(std::string()));
    }
    return groups;
}

Error no_such_scene(const std::string& name) {
    std::vector<std::string> names;
    for (const fs::path& file : scene_files()) names.push_back(file.stem().string());
    const std::string nearest = nearest_word(name, names);
    const std::string hint = nearest.empty() ? "" : fmt::format("nearest: {}; ", nearest);
    return bad_input(without_controls(fmt::format(
        "{}: no such file, and no scene of this name ships ({}see: nullscope scenes)", in_quotes(name), hint)));
}

}  // namespace

fs::path scene_path(const std::string& file_or_name) {
    std::error_code error;
    const fs::path shipped = scenes_directory() / (file_or_name + ".toml");
    const bool is_name = !fs::is_regular_file(file_or_name, error) && file_or_name.find('/') == std::string::npos;
    return is_name && fs::is_regular_file(shipped, error) ? shipped : fs::path(file_or_name);
}

SceneFolders scene_folders(const std::string& file_or_name) {
    return {scene_path(file_or_name).parent_path(), scenes_directory()};
}

Result<OpenedScene> open_scene(const std::string& file_or_name, const Note& note, const SceneOverrides& overrides) {
    std::error_code error;
    const fs::path path = scene_path(file_or_name);
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return no_such_scene(file_or_name);
    if (!fs::is_regular_file(status)) {
        const char* what = fs::is_directory(status) ? "a folder" : "not a regular file";
        return bad_input(without_controls(fmt::format("{}: {}, not a scene file", in_quotes(file_or_name), what)));
    }
    if (is_picture_file(path)) return open_picture(path.string(), note, overrides);
    const Result<std::string> text = read_text(path, kLargestSceneFile);
    if (!text) return bad_input(without_controls(text.error().message()));
    SceneFolders folders = scene_folders(file_or_name);
    TRY(scene, parse_scene_in(folders, *text, path.string(), overrides));
    return OpenedScene{std::move(*scene), std::move(folders)};
}

Result<Scene> load_scene(const std::string& file_or_name, const Note& note, const SceneOverrides& overrides) {
    TRY(opened, open_scene(file_or_name, note, overrides));
    return std::move(opened->scene);
}

std::vector<SceneInfo> shipped_scenes() {
    std::vector<SceneInfo> scenes;
    for (const fs::path& file : scene_files()) {
        const Result<Scene> scene = load_scene(file.string());
        const std::string name = file.stem().string();
        scenes.push_back(
            {name, scene ? scene->name : name, scene ? scene->description : scene.error().message(), file});
    }
    return scenes;
}

std::vector<SceneGroup> in_gallery_groups(std::vector<SceneInfo> scenes) {
    std::vector<SceneGroup> groups;
    for (const auto& [title, names] : gallery_groups()) {
        SceneGroup group{title, {}};
        for (const std::string& name : names) {
            const auto found = std::ranges::find(scenes, name, &SceneInfo::name);
            if (found == scenes.end()) continue;
            group.scenes.push_back(std::move(*found));
            scenes.erase(found);
        }
        if (!group.scenes.empty()) groups.push_back(std::move(group));
    }
    if (!scenes.empty()) groups.push_back({"Others", std::move(scenes)});
    return groups;
}

}  // namespace nullscope
