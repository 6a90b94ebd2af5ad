#include "viewer/save_as.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <utility>

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

void SaveAs::ask(const std::filesystem::path& proposed) {
    open_ = asked_now_ = true;
    path_ = proposed.string();
    refusal_.clear();
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
            if (std::filesystem::exists(path, error))
                refusal_ = fmt::format("{} exists: choose another name.", path.filename().string());
            else
                open_ = false, chosen = path.string();
        }
        if (!refusal_.empty()) paragraph(refusal_, true);
    }
    ImGui::End();
    return chosen;
}

}  // namespace nullscope::viewer
