#include "viewer/gallery.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "base/assets.h"
#include "studio/autosave.h"
#include "viewer/file_dialog.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kCardWidth = 18.0f;   // of the font's size, at least
constexpr float kFieldWidth = 20.0f;  // likewise

}  // namespace

void Gallery::open(const std::vector<SceneInfo>& scenes, const std::vector<TourInfo>& tours) {
    if (groups_.empty()) groups_ = in_gallery_groups(scenes);
    tours_ = tours;
    open_ = opened_now_ = true;
    words_.clear();
}

std::string Gallery::draw(float top, float bottom, const std::vector<std::string>& recent, bool all, bool escape) {
    if (!open_) return "";
    pictures_.begin_frame();
    const float width = ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos({0.0f, top});
    ImGui::SetNextWindowSize({width, std::max(bottom - top, 4.0f * em())});
    ImGui::SetNextWindowBgAlpha(1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.2f * em(), 0.8f * em()});
    std::string chosen;
    if (ImGui::Begin("##gallery", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
        chosen = draw_head(recent, escape);
        if (ImGui::BeginChild("##cards"))
            for (const SceneGroup& group : groups_)
                if (std::string card = draw_cards(group, all); !card.empty()) chosen = std::move(card);
        if (!std::ranges::any_of(groups_, [this](const SceneGroup& group) {
                return std::ranges::any_of(group.scenes, [&](const SceneInfo& scene) { return matches(scene, group); });
            }))
            ImGui::TextDisabled("Nothing found.");
        ImGui::EndChild();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    opened_now_ = false;
    return chosen;
}

// Words that find, a path that is typed, files of one's own.
std::string Gallery::draw_head(const std::vector<std::string>& recent, bool escape) {
    std::string chosen;
    if (opened_now_) ImGui::SetKeyboardFocusHere();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - button_width("Close") -
                       (FileDialog::available() ? button_width("Browse...") + gap : 0.0f) - 2.0f * gap;
    const float field = std::min(kFieldWidth * em(), 0.5f * room);
    ImGui::SetNextItemWidth(field);
    if (input_text("##words", "Search", words_)) {
        for (const SceneGroup& group : groups_)
            for (const SceneInfo& scene : group.scenes)
                if (chosen.empty() && !words_.empty() && matches(scene, group)) chosen = scene.name;
    }
    if (words_.empty()) tooltip("Words of a scene's name, description or group. Enter opens the first that is found.");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(field);
    if (input_text("##path", "File to open: path, or drop it here", path_) && !path_.empty()) chosen = path_;
    if (path_.empty()) tooltip("A scene or a tour (.toml). Enter opens it.");
    ImGui::SameLine();
    if (FileDialog::available()) {
        if (ImGui::Button("Browse...")) browse_pressed = true;
        tooltip("Choose a scene file in the desktop's dialog.");
        ImGui::SameLine();
    }
    if (ImGui::Button("Close") || escape) close();
    tooltip("Back to the picture (Escape). Ctrl + O opens the gallery again.");
    if (std::string tour = draw_tours(); !tour.empty()) chosen = std::move(tour);
    if (!recent.empty()) {
        ImGui::TextDisabled("Recent:");
        ImGui::SameLine();
    }
    const auto stem = [](const std::string& file) { return std::filesystem::path(file).stem().string(); };
    for (const std::string& file : recent) {
        const std::filesystem::path path(file);
        const std::string own = std::ranges::count(recent, stem(file), stem) == 1
                                    ? stem(file)
                                    : path.parent_path().filename().string() + '/' + stem(file);
        const std::string name = path == last_session()     ? "Last session"
                                 : path == last_recording() ? "Last recording"
                                                            : own;
        if (&file != &recent.front()) next_to(button_width(name.c_str()));
        ImGui::PushID(file.c_str());
        if (small_button(name.c_str())) chosen = file;
        tooltip(file);
        ImGui::PopID();
    }
    ImGui::Spacing();
    return chosen;
}

std::string Gallery::draw_tours() {
    std::string chosen;
    if (tours_.empty()) return chosen;
    ImGui::TextDisabled("Tours:");
    ImGui::SameLine();
    for (const TourInfo& tour : tours_) {
        if (&tour != &tours_.front()) next_to(button_width(tour.title.c_str()));
        ImGui::PushID(tour.path.string().c_str());
        if (small_button(tour.title.c_str())) chosen = tour.path.string();
        tooltip(tour.description);
        ImGui::PopID();
    }
    return chosen;
}

bool Gallery::matches(const SceneInfo& scene, const SceneGroup& group) const {
    return has_words(scene.name + ' ' + scene.title + ' ' + scene.description + ' ' + group.title, words_);
}

std::string Gallery::draw_cards(const SceneGroup& group, bool all) {
    std::vector<const SceneInfo*> found;
    for (const SceneInfo& scene : group.scenes)
        if (matches(scene, group)) found.push_back(&scene);
    if (found.empty()) return "";
    std::string chosen;
    ImGui::TextDisabled("%s", group.title.c_str());
    const float gap = ImGui::GetStyle().ItemSpacing.x + 0.4f * em();
    const float room = ImGui::GetContentRegionAvail().x;
    const auto columns = static_cast<std::size_t>(std::max(1.0f, (room + gap) / (kCardWidth * em() + gap)));
    const float width = (room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i % columns > 0) ImGui::SameLine(0.0f, gap);
        if (draw_card(*found[i], width, all)) chosen = found[i]->name;
    }
    ImGui::Dummy({0.0f, 0.6f * em()});
    return chosen;
}

bool Gallery::draw_card(const SceneInfo& scene, float width, bool all) {
    const float margin = 0.4f * em(), wrap = width - 2.0f * margin, line = ImGui::GetTextLineHeight();
    const float shape = CardPicture::kShape;
    const float words = ImGui::CalcTextSize(scene.description.c_str(), nullptr, false, wrap).y;
    const ImVec2 at = ImGui::GetCursorScreenPos(), size{width, shape * width + line + words + 3.0f * margin};
    const bool chosen = ImGui::InvisibleButton(scene.name.c_str(), size);
    if (!ImGui::IsItemVisible()) return chosen;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner{at.x + width, at.y + shape * width};
    const bool over = ImGui::IsItemHovered();
    draw_card_picture(pictures_.find(assets_directory() / "gallery" / (scene.name + ".jpg"), all), at, width, over);
    const ImVec2 text{at.x + margin, corner.y + margin};
    draw.AddText(text, ImGui::GetColorU32(over ? ImGuiCol_CheckMark : ImGuiCol_Text), scene.title.c_str());
    draw.AddText(ImGui::GetFont(), em(), {text.x, text.y + line + 0.3f * margin},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), scene.description.c_str(), nullptr, wrap);
    return chosen;
}

}  // namespace nullscope::viewer
