#include "viewer/widgets.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.h"
#include "scenefile/scene_keys.h"

namespace nullscope::viewer {
namespace {

constexpr double kWidgetDegree = std::numbers::pi / 180.0;
constexpr float kTooltipWidth = 22.0f;  // of the font's size
constexpr float kTooltipGap = 0.25f;    // likewise, to the item
constexpr float kNameColumn = 6.2f;     // of the font's size

std::string hidden_id(const char* name) { return std::string("##") + name; }

ImGuiSliderFlags flags_of(Scale scale) {
    return scale == Scale::kLogarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
}

bool accept(double edited, double low, double high, double& value) {
    if (!std::isfinite(edited)) return false;  // "nan" can be typed
    value = std::clamp(edited, low, high);     // and so can numbers beyond the ends
    return true;
}

// What is allowed that is next to a number: the slider's end where the range's own is not.
double nearest_allowed(double edited, const KeyRange& allowed, double low, double high) {
    if (allowed.contains(edited)) return edited;
    return edited <= allowed.low ? (allowed.open_low ? low : allowed.low) : (allowed.open_high ? high : allowed.high);
}

unsigned typed_number = 0;  // the last field of type_number() that had the keyboard

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

// Places of something that tall and wide, within the screen: below the row of the item before, above it where there is more room.
ImVec2 below_item(const ImVec2& size) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize, from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const float gap = ImGui::GetStyle().FramePadding.y + kTooltipGap * em();  // names are less tall than their rows
    const float below = to.y + gap, above = from.y - gap - size.y;
    const bool fits = below + size.y <= screen.y || above < 0.0f;
    return {std::clamp(from.x, 0.0f, std::max(screen.x - size.x, 0.0f)), fits ? below : above};
}

// Level with the item before, beside its window.
ImVec2 beside_window(const ImVec2& size) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize, at = ImGui::GetWindowPos();
    const float gap = kTooltipGap * em(), right = at.x + ImGui::GetWindowWidth() + gap, left = at.x - gap - size.x;
    const float y = std::clamp(ImGui::GetItemRectMin().y, 0.0f, std::max(screen.y - size.y, 0.0f));
    return {right + size.x <= screen.x || left < 0.0f ? right : left, y};
}

// Of a value that may be anything in `allowed`.
bool slide_within(const KeyRange& allowed, const char* name, double& value, double low, double high, const char* format,
                  const std::string& help, Scale scale, When when) {
    row(name, help);
    const std::string id = hidden_id(name);
    double edited = when == When::kOnRelease ? draft_or(id, value) : value;
    const bool moved =
        ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &edited, &low, &high, format, flags_of(scale));
    const bool take = when == When::kOnRelease ? settled(id, moved, edited) : moved;
    if (!take || !std::isfinite(edited)) return false;
    value = nearest_allowed(edited, allowed, low, high);
    return true;
}

}  // namespace

float em() { return ImGui::GetFontSize(); }

unsigned packed(const Colour& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour.red, colour.green, colour.blue, colour.opacity});
}

std::string wrapped(const std::string& text, float width) {
    std::string lines;
    for (const std::string& paragraph : split(text, '\n')) {
        std::string line;
        for (const std::string& word : split(paragraph, ' ')) {
            std::string longer = line;
            if (!line.empty()) longer += " ";
            longer += word;
            const bool fits = line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= width;
            if (!fits) lines.append(line).append("\n");
            line = fits ? longer : word;
        }
        lines.append(line).append("\n");
    }
    if (!lines.empty()) lines.pop_back();
    return lines;
}

bool has_words(const std::string& text, const std::string& search) {
    const std::string in = lower_case(text);
    return std::ranges::all_of(split(lower_case(search), ' '),
                               [&](const std::string& word) { return in.find(word) != std::string::npos; });
}

void row(const char* name, const std::string& help) {
    ImGui::AlignTextToFramePadding();
    text_row(name, help);
    ImGui::SetNextItemWidth(-1.0f);
}

void text_row(const char* name, const std::string& help) {
    ImGui::TextUnformatted(name);
    tooltip(help);
    ImGui::SameLine(kNameColumn * ImGui::GetFontSize());
}

void tooltip(const std::string& text, TooltipPlace place) {
    // A text field that is typed in takes the tooltips of nothing but itself away.
    const ImGuiHoveredFlags flags =
        ImGuiHoveredFlags_AllowWhenDisabled |
        (ImGui::GetIO().WantTextInput ? ImGuiHoveredFlags_AllowWhenBlockedByActiveItem : ImGuiHoveredFlags_None);
    if (text.empty() || !ImGui::IsItemHovered(flags)) return;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);  // of what is grey, too
    const std::string lines = wrapped(text, kTooltipWidth * em());
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 words = ImGui::CalcTextSize(lines.c_str());
    const ImVec2 size{words.x + 2.0f * style.WindowPadding.x, words.y + 2.0f * style.WindowPadding.y};
    ImGui::SetNextWindowPos(place == TooltipPlace::kBelow ? below_item(size) : beside_window(size));
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(lines.c_str());
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void wrapped_text(const std::string& text, float width) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width + 1.0f);  // a word that is longer
    ImGui::TextUnformatted(wrapped(text, width).c_str());
    ImGui::PopTextWrapPos();
}

void paragraph(const std::string& text, bool refusal) {
    ImGui::PushStyleColor(ImGuiCol_Text, packed(refusal ? palette().refusal : palette().dim));
    ImGui::TextUnformatted(wrapped(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
}

bool next_to(float width) {
    const float room = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - ImGui::GetItemRectMax().x;
    const bool fits = width + ImGui::GetStyle().ItemSpacing.x <= room;
    if (fits) ImGui::SameLine();
    return fits;
}

bool small_button(const char* name) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0.08f * em()});
    const bool pressed = ImGui::Button(name);
    ImGui::PopStyleVar();
    return pressed;
}

float button_width(const char* name) {
    return ImGui::CalcTextSize(name, nullptr, true).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

void scroll_into_view(float y) {
    constexpr float kEnough = 8.0f;  // of the font's size: a header and four rows
    const float end = ImGui::GetCursorScreenPos().y, top = ImGui::GetWindowPos().y, height = ImGui::GetWindowHeight();
    if (end <= top + height || top + height - y > kEnough * em()) return;
    const bool fits = end - y <= height;
    ImGui::SetScrollFromPosY((fits ? end : y) - top, fits ? 1.0f : 0.0f);
}

bool drag_number(const char* name, double& value, double speed, const KeyRange& allowed, double low, double high,
                 const char* format, const char* help) {
    row(name, help);
    double edited = value;
    if (!ImGui::DragScalar(hidden_id(name).c_str(), ImGuiDataType_Double, &edited, static_cast<float>(speed), &low,
                           &high, format) ||
        !std::isfinite(edited))
        return false;
    value = nearest_allowed(edited, allowed, low, high);
    return true;
}

bool drag_key_degrees(const char* key, const char* name, double& radians, const char* help) {
    constexpr double kShown = 0.005;  // less is shown as 0, not as -0
    const KeyRange range = key_range(key);
    double degrees = std::fabs(radians) < kShown * kWidgetDegree ? 0.0 : radians / kWidgetDegree;
    if (!drag_number(name, degrees, 0.25, range, range.low, range.high, "%.2f\xc2\xb0", help)) return false;
    radians = degrees * kWidgetDegree;
    return true;
}

bool slide(const char* name, double& value, double low, double high, const char* format, const std::string& help,
           Scale scale, When when) {
    return slide_within(closed(low, high), name, value, low, high, format, help, scale, when);
}

bool slide_key(const char* key, const char* name, double& value, double low, double high, const char* format,
               const std::string& help, Scale scale, When when) {
    const SceneKey row{"", key, KeyType::kNumber, "", "", key_range(key)};
    const std::string typed =
        fmt::format("{}\nCtrl and a click: type it in, allowed: {}. In scene files: {}.", help, allowed_text(row), key);
    return slide_within(row.range, name, value, low, high, format, typed, scale, when);
}

bool slide_key_degrees(const char* key, const char* name, double& radians, double low_deg, double high_deg,
                       const char* help, When when) {
    double degrees = radians / kWidgetDegree;
    if (!slide_key(key, name, degrees, low_deg, high_deg, "%.1f\xc2\xb0", help, Scale::kLinear, when)) return false;
    radians = degrees * kWidgetDegree;
    return true;
}

bool slide_as(const char* name, double& position, double low, double high, const std::string& text, const char* help,
              Scale scale) {
    row(name, help);
    double edited = position;
    // Text: no conversion in it.
    const ImGuiSliderFlags flags = flags_of(scale) | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat;
    return ImGui::SliderScalar(hidden_id(name).c_str(), ImGuiDataType_Double, &edited, &low, &high, text.c_str(),
                               flags) &&
           accept(edited, low, high, position);
}

bool type_number(const char* name, double& value, double low, double high, const char* format, const char* help) {
    row(name, help);
    const std::string id = hidden_id(name);
    double edited = draft_or(id, value);
    const bool changed = ImGui::InputDouble(id.c_str(), &edited, 0.0, 0.0, format, ImGuiInputTextFlags_CharsScientific);
    if (ImGui::IsItemActive()) typed_number = ImGui::GetItemID();
    return settled(id, changed, edited) && accept(edited, low, high, value);
}

bool types_number() {
    const unsigned active = ImGui::GetActiveID();
    return active != 0 && (active == typed_number || ImGui::TempInputIsActive(active));
}

bool input_text(const char* id, const char* hint, std::string& text) {
    return ImGui::InputTextWithHint(id, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue);
}

bool tick(const char* name, bool& value, const char* help) {
    row(name, help);
    return ImGui::Checkbox(hidden_id(name).c_str(), &value);
}

bool tick_if(bool meant, const char* name, bool& value, const char* help, const char* why_not) {
    ImGui::BeginDisabled(!meant);
    const bool changed = tick(name, value, meant ? help : why_not);
    ImGui::EndDisabled();
    return changed;
}

bool button_of_three(int place, const char* name, const std::string& help) {
    if (place > 0) ImGui::SameLine();
    const float behind = static_cast<float>(2 - place);  // buttons that follow
    const float room = ImGui::GetContentRegionAvail().x - behind * ImGui::GetStyle().ItemSpacing.x;
    const bool pressed = ImGui::Button(name, {room / (behind + 1.0f), 0.0f});
    tooltip(help);
    return pressed;
}

bool choice(const char* id, const std::string& shown, bool shut, const std::function<void()>& items) {
    if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLarge)) return false;
    if (shut) ImGui::CloseCurrentPopup();
    items();
    ImGui::EndCombo();
    return true;
}

bool choice_item(const std::string& text, bool chosen, const std::string& help) {
    const bool picked = ImGui::Selectable(text.c_str(), chosen);
    tooltip(help, TooltipPlace::kBesideWindow);
    if (chosen) ImGui::SetItemDefaultFocus();
    return picked;
}

void overlay(const char* id, float x, float y, float pivot_x, float pivot_y, float opacity,
             const std::function<void()>& content, OverlayLayer layer) {
    ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, {pivot_x, pivot_y});
    ImGui::SetNextWindowBgAlpha(opacity);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoInputs;
    if (ImGui::Begin(id, nullptr, layer == OverlayLayer::kTop ? kFlags | ImGuiWindowFlags_Tooltip : kFlags)) content();
    ImGui::End();
}

}  // namespace nullscope::viewer
