#include "viewer/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.h"

namespace nullscope::viewer {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr float kNameColumn = 6.2f;  // of the font's size

std::string hidden_id(const char* name) { return std::string("##") + name; }

bool accept(double edited, double low, double high, double& value) {
    if (!std::isfinite(edited)) return false;  // "nan" can be typed
    value = std::clamp(edited, low, high);     // and so can numbers beyond the ends
    return true;
}

// What the item before shows while it is being edited; only one is at a time.
struct Draft {
    ImGuiID id = 0;
    double value = 0.0;
};
Draft draft;

double draft_or(const std::string& id, double value) {
    return draft.id == ImGui::GetID(id.c_str()) ? draft.value : value;
}

// Keeps the draft of the item before while it is active. True, with the last draft, when it was let go. Which frame tells of
// an edit, the last active one or the one after it, differs between Dear ImGui's versions.
bool settled(const std::string& id, bool changed, double& edited) {
    const ImGuiID own = ImGui::GetID(id.c_str());
    if (changed || ImGui::IsItemActive()) draft = {own, edited};
    if (draft.id != own || ImGui::IsItemActive()) return false;
    edited = draft.value;
    draft = {};
    return ImGui::IsItemDeactivatedAfterEdit();
}

}  // namespace

void row(const char* name, const char* help) {
    ImGui::AlignTextToFramePadding();
    text_row(name, help);
    ImGui::SetNextItemWidth(-1.0f);
}

void text_row(const char* name, const char* help) {
    ImGui::TextUnformatted(name);
    if (help != nullptr) tooltip(help);
    ImGui::SameLine(kNameColumn * ImGui::GetFontSize());
}

void tooltip(const char* text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void paragraph(const std::string& text, int colour) {
    const float width = ImGui::GetContentRegionAvail().x;
    std::string line, lines;
    for (const std::string& word : split(text, ' ')) {
        std::string longer = line;
        if (!line.empty()) longer += " ";
        longer += word;
        const bool fits = line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= width;
        if (!fits) lines += line + "\n";
        line = fits ? longer : word;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(colour));
    ImGui::TextUnformatted((lines + line).c_str());
    ImGui::PopStyleColor();
}

bool drag_number(const char* name, double& value, double speed, double low, double high, const char* format,
                 const char* help) {
    row(name, help);
    double edited = value;
    return ImGui::DragScalar(hidden_id(name).c_str(), ImGuiDataType_Double, &edited, static_cast<float>(speed), &low,
                             &high, format) &&
           accept(edited, low, high, value);
}

bool drag_degrees(const char* name, double& radians, double low_deg, double high_deg, const char* help) {
    constexpr double kShown = 0.005;  // less is shown as 0, not as -0
    double degrees = std::fabs(radians) < kShown * kDegree ? 0.0 : radians / kDegree;
    if (!drag_number(name, degrees, 0.25, low_deg, high_deg, "%.2f\xc2\xb0", help)) return false;
    radians = degrees * kDegree;
    return true;
}

bool slide(const char* name, double& value, double low, double high, Scale scale, When when, const char* format,
           const char* help) {
    row(name, help);
    const std::string id = hidden_id(name);
    double edited = when == When::kOnRelease ? draft_or(id, value) : value;
    const ImGuiSliderFlags flags = scale == Scale::kLogarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const bool moved = ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &edited, &low, &high, format, flags);
    const bool take = when == When::kOnRelease ? settled(id, moved, edited) : moved;
    return take && accept(edited, low, high, value);
}

bool slide_as(const char* id, double& position, double low, double high, int flags, const std::string& text) {
    double edited = position;
    if (!ImGui::SliderScalar(id, ImGuiDataType_Double, &edited, &low, &high,
                             text.c_str(),  // no conversion: shown as it is
                             flags | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat))
        return false;
    position = std::clamp(edited, low, high);
    return true;
}

bool type_number(const char* id, double& value, double low, double high, const char* format) {
    double edited = draft_or(id, value);
    const bool changed = ImGui::InputDouble(id, &edited, 0.0, 0.0, format, ImGuiInputTextFlags_CharsScientific);
    return settled(id, changed, edited) && accept(edited, low, high, value);
}

bool tick(const char* name, bool& value, const char* help) {
    row(name, help);
    return ImGui::Checkbox((std::string("##") + name).c_str(), &value);
}

bool begin_choice(const char* id, const std::string& shown, bool shut) {
    if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLarge)) return false;
    if (shut) ImGui::CloseCurrentPopup();
    return true;
}

void end_choice() { ImGui::EndCombo(); }

bool choice_item(const std::string& text, bool chosen, const std::string& help) {
    const bool picked = ImGui::Selectable(text.c_str(), chosen);
    if (!help.empty()) tooltip(help.c_str());
    if (chosen) ImGui::SetItemDefaultFocus();
    return picked;
}

}  // namespace nullscope::viewer
