#include "viewer/tour_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "viewer/panel_rows.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kTourMargin = 0.6f;  // of the font's size, as what follows
constexpr float kWidest = 46.0f;     // lines that are easily read
constexpr float kNarrowest = 18.0f;  // else it lies over the side panel, too
constexpr float kListWidth = 34.0f;
constexpr float kTallest = 0.3f;  // of the window: longer texts scroll

// At the line's right end.
void align_right(float width) { ImGui::SameLine(std::max(ImGui::GetWindowContentRegionMax().x - width, 0.0f)); }

bool draw_entry(const TourInfo& tour) {
    const float width = ImGui::GetContentRegionAvail().x, gap = 0.2f * em();
    const std::string words = wrapped(tour.description, width), steps = fmt::format("{} steps", tour.steps);
    const float height = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, height + gap + ImGui::CalcTextSize(words.c_str()).y};
    const bool chosen = ImGui::InvisibleButton(tour.path.string().c_str(), size) && tour.steps > 0;
    const ImU32 title = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark : ImGuiCol_Text);
    const ImU32 dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(at, title, tour.title.c_str());
    if (tour.steps > 0) draw.AddText({at.x + width - ImGui::CalcTextSize(steps.c_str()).x, at.y}, dim, steps.c_str());
    draw.AddText({at.x, at.y + height + gap}, dim, words.c_str());
    ImGui::Dummy({0.0f, 0.3f * em()});
    return chosen;
}

}  // namespace

const TourStep* TourPanel::at(int ahead) const {
    const auto step = static_cast<std::ptrdiff_t>(step_) + ahead;
    return tour_ && step >= 0 && step < std::ssize(tour_->steps) ? &tour_->steps[static_cast<std::size_t>(step)]
                                                                 : nullptr;
}

void TourPanel::go(int ahead) { step_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step_) + ahead); }

int TourPanel::draw(float left, float bottom) {
    if (!tour_) return 0;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = kTourMargin * em();
    if (screen.x - left - 2.0f * margin < kNarrowest * em()) left = 0.0f;
    const float width = std::min(screen.x - left - 2.0f * margin, kWidest * em());
    ImGui::SetNextWindowPos({0.5f * (left + screen.x), bottom - margin}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.96f);
    int pressed = 0;
    if (ImGui::Begin("##tour", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav)) {
        const std::string place =
            fmt::format("{} of {}{}", step_ + 1, tour_->steps.size(), at_last() ? ": the last step" : "");
        const float room = ImGui::CalcTextSize(place.c_str()).x;
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s",
                           wrapped(tour_->title, ImGui::GetContentRegionAvail().x - room - em()).c_str());
        align_right(room);
        ImGui::TextDisabled("%s", place.c_str());
        tooltip("Page Up and Page Down go through the steps, from anywhere; R returns to the view of this one.");
        ImGui::PushID(static_cast<int>(step_));  // each text is scrolled by itself
        const float inside = ImGui::GetContentRegionAvail().x;
        const auto tall = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).y; };
        std::string text = wrapped(tour_->steps[step_].text, inside);
        const float most = kTallest * screen.y;
        if (tall(text) > most)
            text = wrapped(tour_->steps[step_].text, inside - 1.2f * ImGui::GetStyle().ScrollbarSize);
        if (ImGui::BeginChild("##text", {0.0f, std::min(tall(text) + 0.1f * em(), most)}))
            ImGui::TextUnformatted(text.c_str());
        ImGui::EndChild();
        ImGui::PopID();
        pressed = draw_buttons();
        height_ = ImGui::GetWindowHeight() + margin;
    }
    ImGui::End();
    return pressed;
}

int TourPanel::draw_buttons() {
    int pressed = 0;
    const auto button = [&](const char* name, int ahead, const char* help) {
        ImGui::BeginDisabled(at(ahead) == nullptr);
        if (ImGui::Button(name, {4.5f * em(), 0.0f})) pressed = ahead;
        ImGui::EndDisabled();
        tooltip(help);
    };
    button("Back", -1, "The step before (Page Up).");
    ImGui::SameLine();
    if (at_last()) {
        others_pressed |= ImGui::Button("Other tours...");
        tooltip("This tour has ended: start another one, or close it.");
    } else
        button("Next", 1, "The step after this one (Page Down).");
    align_right(button_width("Close"));
    if (ImGui::Button("Close")) close();
    tooltip("Ends the tour; the scene stays (Escape).");
    return pressed;
}

std::optional<std::filesystem::path> draw_tour_list(bool& shown, const std::vector<TourInfo>& tours) {
    std::optional<std::filesystem::path> chosen;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.45f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(kListWidth * em(), 0.9f * screen.x), 0.0f});
    ImGui::SetNextWindowBgAlpha(0.97f);
    if (ImGui::Begin("Guided tours", &shown,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoResize)) {
        for (const TourInfo& tour : tours)
            if (draw_entry(tour)) chosen = tour.path;
        if (tours.empty()) ImGui::TextDisabled("There is none in the folder of files that ship.");
        paragraph("A tour of your own: drop its file on the window (docs/tours.md).");
    }
    ImGui::End();
    if (chosen) shown = false;
    return chosen;
}

const Panel kToursPanel{
    .menu = "Help",
    .name = "Guided tours...",
    .words = "tours of scenes with a text for each view",
    .hides_picture = true,
    .draw = [](PanelPlace& place) { place.parts.tour_chosen = draw_tour_list(place.open, place.parts.all_tours()); },
};

}  // namespace nullscope::viewer
