#include "viewer/scene_editor.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/text.h"
#include "scene/projection.h"
#include "scenefile/sections.h"
#include "viewer/panels.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kWidth = 24.0f;       // of the font's size
constexpr float kLeastWidth = 18.0f;  // likewise: below that it lies over the side panel
constexpr float kMargin = 0.6f;       // likewise
constexpr float kNameShare = 0.42f;   // of a row, that names take at most
constexpr double kPerPixel = 0.005;   // of a number, that a drag over one pixel changes it by
constexpr double kUnbounded = 1e12;
constexpr double kDegree = std::numbers::pi / 180.0;

double unit_of(const SceneKey& key) { return key.unit == "deg" ? kDegree : 1.0; }

// camera.fov has no value of its own: it is the plane's width at distance 1.
bool is_fov(const SceneKey& key) { return full_name(key) == "camera.fov"; }

std::optional<KeyValue> value_of(const SceneKey& key, const Scene& scene) {
    if (key.member.readable()) return key.member.get(scene);
    if (!is_fov(key)) return std::nullopt;
    KeyValue value;
    value.number = field_of_view(scene.camera);
    return value;
}

// As it is on the screen, to compare: what differs by less than a rounding is the same.
std::string shown(const SceneKey& key, const KeyValue& value) {
    if (!value.there) return "";
    switch (key.type) {
        case KeyType::kNumber: return fmt::format("{:.12g}", value.number / unit_of(key));
        case KeyType::kNumbers: return typed_numbers(value.numbers);
        case KeyType::kVelocity:
        case KeyType::kPoint:
        case KeyType::kColour:
            return fmt::format("{:.12g} {:.12g} {:.12g}", value.vector.x, value.vector.y, value.vector.z);
        case KeyType::kWhole: return fmt::format("{}", value.width);
        case KeyType::kSize: return fmt::format("{} {}", value.width, value.height);
        case KeyType::kChoice: return fmt::format("{}", value.choice);
        case KeyType::kFile: return value.path.string();
        default: return value.text;
    }
}

// The line that is being typed; only one is at a time.
struct Line {
    ImGuiID id = 0;
    std::string text;
};
Line line;

// True, with the text, when it was typed to its end.
bool text_field(const char* id, std::string& text) {
    const ImGuiID own = ImGui::GetID(id);
    std::string edited = line.id == own ? line.text : text;
    ImGui::InputText(id, &edited);
    if (ImGui::IsItemActive()) line = {own, edited};
    if (line.id != own || ImGui::IsItemActive()) return false;
    text = line.text;
    line = {};
    return ImGui::IsItemDeactivatedAfterEdit();
}

// Numbers that are being typed; only one field is at a time.
struct Typed {
    ImGuiID id = 0;
    std::array<double, 3> values{};
};
Typed typed;

// One number, or three side by side; those of a point with the names of their axes.
bool drag_numbers(const SceneKey& key, std::array<double, 3>& values, int count, float speed, double low, double high,
                  const std::string& format) {
    constexpr std::array kAxes = {"x ", "y ", "z "};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x,
                width = (ImGui::CalcItemWidth() - static_cast<float>(count - 1) * gap) / static_cast<float>(count);
    bool changed = false;
    ImGui::BeginGroup();
    for (int i = 0; i < count; ++i) {
        const auto part = static_cast<std::size_t>(i);
        const std::string shown = (key.type == KeyType::kPoint ? kAxes[part] : "") + format;
        if (i > 0) ImGui::SameLine(0.0f, gap);
        ImGui::PushID(i);
        ImGui::SetNextItemWidth(width);
        changed |= ImGui::DragScalar("##part", ImGuiDataType_Double, &values[part], speed, &low, &high, shown.c_str());
        ImGui::PopID();
    }
    ImGui::EndGroup();
    return changed;
}

// Lengths in the unit that is chosen for numbers, where files have another: "= 6 M". Else empty.
std::string other_unit(const SceneKey& key, const KeyValue& value, const NumberStyle& style) {
    if (key.unit != "r_s" || !value.there || length_scale(style).one == 1.0) return "";
    constexpr int kDigits = 4;
    if (key.type != KeyType::kPoint) return "= " + length_words(value.number, style, kDigits);
    const auto words = [&](double length) { return length_words(length, style, kDigits); };
    return fmt::format("= {}, {}, {}", words(value.vector.x), words(value.vector.y), words(value.vector.z));
}

// True when the numbers changed: at once while the pointer drags them, at the end while they are typed. note: behind one number, where
// there is room.
bool number_field(const SceneKey& key, std::array<double, 3>& values, int count, const std::string& note) {
    const bool bounded = key.range.high > key.range.low;
    const double low = bounded ? key.range.low : -kUnbounded, high = bounded ? key.range.high : kUnbounded;
    double size = 0.0;
    for (int i = 0; i < count; ++i) size = std::max(size, std::fabs(values[static_cast<std::size_t>(i)]));
    const auto speed = static_cast<float>(std::max(size, std::min(0.1, 0.01 * (high - low))) * kPerPixel);
    const std::string unit = key.unit.empty() ? "" : key.unit == "deg" ? "\xc2\xb0" : fmt::format(" {}", key.unit);
    const ImGuiID own = ImGui::GetID("##value");
    if (typed.id == own) values = typed.values;
    std::string format = count == 1 ? "%.7g" + unit : "%.4g";
    const std::string longer = fmt::format("{:.7g}{} {}", values[0], unit, note);
    const float room = ImGui::CalcItemWidth() - 2.0f * ImGui::GetStyle().FramePadding.x;
    if (count == 1 && !note.empty() && ImGui::CalcTextSize(longer.c_str()).x <= room) format += ' ' + note;
    const bool changed = drag_numbers(key, values, count, speed, low, high, format);
    const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    if (changed && ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) return finite;
    if (changed) typed = {own, values};
    if (typed.id != own || ImGui::IsItemActive()) return false;
    values = typed.values;
    typed = {};
    return finite;
}

// Dear ImGui does so by itself only while panels are used by keyboard. id: the colour's.
void shut_picker(const char* id) {
    ImGui::PushID(id);
    if (ImGui::BeginPopup("picker")) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

// The control of a key: true when the value changed.
bool field(const SceneKey& key, KeyValue& value, bool escape, const std::string& note) {
    switch (key.type) {
        case KeyType::kNumber: {
            std::array<double, 3> v = {value.number / unit_of(key)};
            if (!number_field(key, v, 1, note)) return false;
            value.number = v[0] * unit_of(key);
            return true;
        }
        case KeyType::kVelocity:
        case KeyType::kPoint: {
            std::array<double, 3> v = {value.vector.x, value.vector.y, value.vector.z};
            if (!number_field(key, v, 3, note)) return false;
            value.vector = {v[0], v[1], v[2]};
            return true;
        }
        case KeyType::kColour: {
            std::array<float, 3> c = {static_cast<float>(value.vector.x), static_cast<float>(value.vector.y),
                                      static_cast<float>(value.vector.z)};
            const bool picked =
                ImGui::ColorEdit3("##value", c.data(), ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
            if (escape) shut_picker("##value");
            if (!picked) return false;
            value.vector = {c[0], c[1], c[2]};
            return true;
        }
        case KeyType::kWhole: {
            const int low = static_cast<int>(key.range.low), high = static_cast<int>(key.range.high);
            return ImGui::DragScalar("##value", ImGuiDataType_S32, &value.width, 0.2f, &low, &high);
        }
        case KeyType::kChoice: {
            const auto words = split(key.choices, ' ');
            const int before = value.choice;
            choice("##value", words[static_cast<std::size_t>(before)], escape, [&] {
                for (std::size_t i = 0; i < words.size(); ++i)
                    if (choice_item(words[i], static_cast<int>(i) == before)) value.choice = static_cast<int>(i);
            });
            return value.choice != before;
        }
        case KeyType::kText:
        case KeyType::kFormula: {
            if (!text_field("##value", value.text)) return false;
            if (key.key == "name" && !key.section.empty()) std::ranges::replace(value.text, ' ', '-');  // of a body
            return true;
        }
        case KeyType::kFile: {
            std::string path = value.path.string();
            if (!text_field("##value", path)) return false;
            value.path = path.empty() ? std::filesystem::path() : std::filesystem::absolute(path);
            return true;
        }
        case KeyType::kNumbers: {
            std::string text = typed_numbers(value.numbers);
            return text_field("##value", text) && take_typed_numbers(text, value.numbers);
        }
        case KeyType::kSize:
        case KeyType::kMetric: break;
    }
    return false;
}

std::string help_of(const SceneKey& key) {
    const std::string allowed = allowed_text(key), fallback(key.fallback);
    return fmt::format("{}\n\n{}{}{}", key.help, full_name(key),
                       allowed.empty() ? "" : fmt::format("\nallowed: {}", allowed),
                       fallback.empty() ? "" : fmt::format("\ndefault: {}", fallback));
}

// Keys that are edited elsewhere: the window decides on the size, the metric has rows of its own.
bool is_edited(const SceneKey& key) { return key.type != KeyType::kSize && key.type != KeyType::kMetric; }

// "ball: Terra" where the body has a name of its own.
std::string heading(const SectionRef& at, const Scene& holder) {
    if (at.label.empty()) return "Scene";
    for (const SceneKey& key : keys_of(at.section))
        if (key.key == "name")
            if (const auto value = value_of(key, holder); value && !value->text.empty())
                return fmt::format("{}: {}", at.label, value->text);
    return at.label;
}

// All of the screen's where there is too little room beside the side panel.
float window_width() {
    const float margin = kMargin * em(), screen = ImGui::GetIO().DisplaySize.x;
    const float beside = screen - side_panel_right() - 2.0f * margin;
    return std::min(kWidth * em(), beside >= kLeastWidth * em() ? beside : screen - 2.0f * margin);
}

}  // namespace

FreePart SceneEditor::free_part(float top, float bottom) {
    constexpr double kLeast = 0.15;  // of the screen
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    FreePart part;
    part.left = side_panel_right() / screen.x, part.right = 1.0 - (window_width() + kMargin * em()) / screen.x;
    part.top = top / screen.y, part.bottom = bottom / screen.y;
    return part.right - part.left > kLeast && part.bottom - part.top > kLeast ? part : FreePart();
}

bool SceneEditor::draw(ViewState& view, bool& open, float top, float bottom, bool escape) {
    const auto spacetime = spacetime_of(view.scene);
    style_ = spacetime != nullptr ? style_in(view.scene, *spacetime, view.numbers) : NumberStyle();
    const float margin = kMargin * em(), screen = ImGui::GetIO().DisplaySize.x, width = window_width();
    width_ = width + margin;
    ImGui::SetNextWindowPos({screen - width - margin, top + margin});
    ImGui::SetNextWindowSize({width, std::max(bottom - top - 2.0f * margin, 4.0f * em())});
    bool changed = false;
    if (ImGui::Begin("Scene", &open,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoResize)) {
        ImGui::SetNextItemWidth(0.62f * ImGui::GetContentRegionAvail().x);
        input_text("##words", "Search keys", words_);
        if (words_.empty()) tooltip("Words of a key's name or help: \"brightness\", \"disc temperature\".");
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1.0f);
        const bool adds = choice("##add", "Add...", escape, [&] {
            for (const Section& section : sections())
                if (can_be_added(view.scene, section.name) &&
                    choice_item(std::string(section.name), false, std::string(section.help)))
                    changed |= take(view, with_addition(view.scene, section.name, free_part(top, bottom)));
        });
        if (!adds) tooltip("A body, a disc, a path or a split screen that the scene does not have yet.");
        if (!fault_.empty()) paragraph(fault_, true);
        ImGui::Separator();
        if (ImGui::BeginChild("##sections")) {
            const float height = ImGui::GetScrollMaxY() + ImGui::GetWindowHeight();
            const float start = ImGui::GetCursorPosY();
            Scene holder = view.scene;  // of each section in turn
            const auto sections = scene_sections(view.scene);
            for (const SectionRef& at : sections) {
                exchange_with_last(holder, at);
                ImGui::PushID(at.label.c_str());
                const bool edited = draw_section(view, at, holder, escape);
                ImGui::PopID();
                changed |= edited;
                if (edited && !std::ranges::equal(sections, scene_sections(view.scene), {}, &SectionRef::label,
                                                  &SectionRef::label)) {
                    ImGui::Dummy({0.0f, height});  // what is left out in this frame: else it would be scrolled
                    break;
                }
                if (edited)
                    holder = view.scene;
                else
                    exchange_with_last(holder, at);
            }
            if (ImGui::GetCursorPosY() == start) paragraph("No key of this scene has these words.");
        }
        ImGui::EndChild();
    }
    ImGui::End();
    return changed;
}

bool SceneEditor::draw_section(ViewState& view, const SectionRef& at, const Scene& holder, bool escape) {
    std::vector<const SceneKey*> keys;
    for (const SceneKey& key : keys_of(at.section))
        if (is_edited(key) && matches(key) && (key.meant == nullptr || key.meant(holder)) && value_of(key, holder))
            keys.push_back(&key);
    const SpacetimePart metric = find_section(at.section)->spacetime;
    if (keys.empty() && !(metric && words_.empty())) return false;
    const ImGuiTreeNodeFlags open = words_.empty() ? ImGuiTreeNodeFlags_None : ImGuiTreeNodeFlags_DefaultOpen;
    ImGui::PushID(words_.empty() ? "all" : "found");  // which sections are open without a search stays as it was
    const bool revealed = !reveal_.empty() && reveal_ == at.label;
    if (revealed) {
        ImGui::SetNextItemOpen(true);
        ImGui::SetScrollHereY(0.0f);
        reveal_.clear();
    }
    const bool hidden = view.hidden.has(at);
    const Colour ink = hidden ? palette().dim : marked_ == at.label ? palette().accent : palette().text;
    ImGui::PushStyleColor(ImGuiCol_Text, packed(ink));
    const std::string words = heading(at, holder) + (hidden ? " (hidden)" : "");
    const bool is_open = ImGui::CollapsingHeader(fmt::format("{}###{}", words, at.label).c_str(), open);
    if (!hidden) ImGui::PopStyleColor();
    const bool opened = ImGui::IsItemToggledOpen();
    const float start = ImGui::GetItemRectMin().y;
    bool changed = false;
    if (is_open) {
        const bool others = changed = draw_buttons(view, at);
        if (metric && !others && words_.empty()) {
            SpacetimeSpec spec = metric.of(std::as_const(view.scene));
            if (spacetime_rows(spec, "metric", "##metric", escape)) {
                Scene edited = view.scene;
                metric.of(edited) = spec;
                keep_outside_horizon(edited);
                changed |= take(view, edited);
            }
        }
        const Scene defaults = section_defaults(holder, at.section);
        for (const SceneKey* key : keys) {
            if (others) break;
            ImGui::PushID(key->key.data());
            changed |= draw_key(view, at, holder, defaults, *key, escape);
            ImGui::PopID();
        }
        if (opened) scroll_into_view(start);
    }
    if (hidden) ImGui::PopStyleColor();
    ImGui::PopID();
    return changed;
}

// One of them changes what the others stand for: they are left out then.
bool SceneEditor::draw_buttons(ViewState& view, const SectionRef& at) {
    if (!find_section(at.section)->optional()) return false;
    const auto button = [](const char* name) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(palette().text));
        const bool pressed = small_button(name);
        ImGui::PopStyleColor();
        return pressed;
    };
    if (button("Remove")) {
        if (!take(view, without_section(view.scene, at))) return false;
        view.hidden.removed(at);
        marked_.clear();
        return true;
    }
    if (!is_of_several(at.section)) return false;
    ImGui::SameLine();
    if (button("Duplicate")) {
        if (!take(view, with_copy(view.scene, at))) return false;
        view.hidden.copied(at);
        marked_.clear();
        return true;
    }
    if (!HiddenBodies::is_body(at)) return false;
    ImGui::SameLine();
    const bool pressed = button(view.hidden.has(at) ? "Show###hide" : "Hide###hide");
    if (pressed) view.hidden.toggle(at);
    tooltip("A hidden body stays in the scene and in its file, but is not drawn, nor in films.");
    return pressed;
}

bool SceneEditor::draw_key(ViewState& view, const SectionRef& at, const Scene& holder, const Scene& defaults,
                           const SceneKey& key, bool escape) {
    KeyValue value = *value_of(key, holder), usual = *value_of(key, defaults);
    if (key.type == KeyType::kChoice) {
        const auto words = split(key.choices, ' ');
        usual.choice = static_cast<int>(std::ranges::find(words, key.fallback) - words.begin());
    }
    const bool differs = shown(key, value) != shown(key, usual);
    const float room = ImGui::GetContentRegionAvail().x, column = kNameShare * room, left = ImGui::GetCursorPosX();
    const std::string name(key.key);
    ImGui::AlignTextToFramePadding();
    if (differs)
        ImGui::TextUnformatted(name.c_str());
    else
        ImGui::TextDisabled("%s", name.c_str());
    const std::string note = other_unit(key, value, style_);
    tooltip(help_of(key) + (note.empty() ? "" : "\nvalue " + note));
    if (ImGui::CalcTextSize(name.c_str()).x < column)
        ImGui::SameLine(left + column);
    else
        ImGui::SetCursorPosX(left + column);
    const float button = ImGui::GetFrameHeight();
    if (!value.there) {
        if (!ImGui::Button("set")) return false;
        tooltip("Not set.");
        value.there = true;
        value.number = key.range.contains(1.0) ? 1.0 : 0.5 * (key.range.low + key.range.high);
        return take(view, with_value(view.scene, at, key, value));
    }
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemInnerSpacing.x);
    bool changed = field(key, value, escape, note);
    if (differs) {
        ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
        if (ImGui::Button("x", {button, 0.0f})) value = usual, changed = true;
        tooltip(key.fallback.empty() ? "Back to the default." : fmt::format("Back to the default, {}.", key.fallback));
    }
    return changed && take(view, with_value(view.scene, at, key, value));
}

bool SceneEditor::matches(const SceneKey& key) const {
    return has_words(full_name(key) + ' ' + std::string(key.help), words_);
}

bool SceneEditor::take(ViewState& view, Result<Scene> edited) {
    fault_ = edited ? "" : edited.error().message();
    if (!edited) return false;
    view.scene = std::move(*edited);
    if (view.scene.disc) view.hidden_disc = *view.scene.disc;
    return true;
}

}  // namespace nullscope::viewer
