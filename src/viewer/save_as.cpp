#include "viewer/save_as.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/atomic_file.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {

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

bool may_be_replaced(const std::filesystem::path& file) {
    const auto text = read_text(file);
    return text && text->starts_with(kSavedMark) && text->find('#', 1) == std::string::npos;
}

void SaveAs::ask(const std::filesystem::path& proposed) {
    open_ = asked_now_ = true;
    path_ = proposed.string();
    refusal_.clear(), replaced_.clear();
}

std::string SaveAs::draw(bool escape) {
    if (!open_) return "";
    const float em = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    std::string chosen;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.4f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(1.0f);
    if (ImGui::Begin(
            "Save scene as", nullptr,
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize)) {
        if (std::exchange(asked_now_, false)) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(std::min(36.0f * em, 0.8f * screen.x));
        bool save = input_text("##path", "Path of the file, .toml", path_);
        save |= ImGui::Button("Save");
        next_to(button_width("Cancel"));
        if (ImGui::Button("Cancel") || escape) open_ = false;
        if (save && !path_.empty()) {
            std::filesystem::path path = std::filesystem::absolute(path_);
            if (path.extension() != ".toml") path += ".toml";
            std::error_code error;
            const std::string name = path.filename().string();
            if (!std::filesystem::exists(path, error) || replaced_ == path.string())
                open_ = false, chosen = path.string();
            else if (!may_be_replaced(path))
                refusal_ = fmt::format("{} exists and has contents of your own: choose another name.", name);
            else
                refusal_ = fmt::format("{} exists. Save once more to replace it.", name), replaced_ = path.string();
        }
        if (!refusal_.empty()) paragraph(refusal_, true);
    }
    ImGui::End();
    return chosen;
}

}  // namespace nullscope::viewer
