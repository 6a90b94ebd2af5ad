// What the viewer does with scene files, the clipboard and its history.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/atomic_file.h"
#include "scenefile/scene_writer.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {
namespace {

// NAME.toml in the current folder, absolute; NAME-2, NAME-3 ... where that exists. Of the name its letters and digits.
std::filesystem::path fresh_scene_path(const std::string& name) {
    std::string stem;
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0)
            stem += static_cast<char>(std::tolower(letter));
        else if (!stem.empty() && stem.back() != '-')
            stem += '-';
    }
    while (!stem.empty() && stem.back() == '-') stem.pop_back();
    if (stem.empty()) stem = "scene";
    std::filesystem::path path = std::filesystem::absolute(stem + ".toml");
    for (int n = 2; std::filesystem::exists(path); ++n) path.replace_filename(fmt::format("{}-{}.toml", stem, n));
    return path;
}

}  // namespace

bool Viewer::handle_command(const KeyCommand& command) {
    switch (command.key) {
        case GLFW_KEY_Z: return step_history(!command.shift);
        case GLFW_KEY_Y: return step_history(false);
        case GLFW_KEY_V: return paste();
        case GLFW_KEY_S: save_scene(); return false;
        case GLFW_KEY_C:
            ImGui::SetClipboardText(view_line(view_.scene.camera).c_str());
            say("View copied: one line of text, for Ctrl + V here or for a scene file");
            return false;
        default: return false;
    }
}

bool Viewer::step_history(bool back) {
    std::string what;
    const bool done = back ? history_.undo(view_, what) : history_.redo(view_, what);
    say(!done ? (back ? "Nothing to undo" : "Nothing to redo")
              : fmt::format("{}: {}", back ? "Undone" : "Redone", what));
    return done;
}

bool Viewer::paste() {
    const char* text = ImGui::GetClipboardText();
    const Status pasted = paste_view(view_, text != nullptr ? text : "");
    say(pasted ? "View pasted" : pasted.error().message());
    return static_cast<bool>(pasted);
}

bool Viewer::open_dropped(const Input& input) {
    if (input.dropped.empty()) return false;
    const Status opened = load_into(view_, input.dropped.back());
    say(opened ? "Opened " + input.dropped.back() : opened.error().message());
    return static_cast<bool>(opened);
}

// A file that was opened is never written over: its comments would be lost.
void Viewer::save_scene() {
    const bool again = !saved_scene_.empty() && view_.source == saved_scene_;
    const std::filesystem::path path = again ? std::filesystem::path(saved_scene_) : fresh_scene_path(view_.scene.name);
    Scene scene = view_.scene;
    scene.camera.width = view_.loaded.camera.width, scene.camera.height = view_.loaded.camera.height;
    if (Status saved = write_text_atomically(path, scene_file_text(scene, path.parent_path())); !saved)
        return say(saved.error().message());
    saved_scene_ = view_.source = path.string();
    view_.loaded = scene;
    std::erase(view_.own, saved_scene_);
    view_.own.insert(view_.own.begin(), saved_scene_);
    say(fmt::format("Saved {}", saved_scene_));
}

}  // namespace nullscope::viewer
