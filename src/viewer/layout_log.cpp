#include "viewer/layout_log.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "base/atomic_file.h"

namespace nullscope::viewer {
namespace {

constexpr float kSlack = 1.0f;        // of a unit: letters lie on whole pixels, rectangles need not
constexpr float kWordGap = 0.2f;      // of the font's size: a space
constexpr float kLineGap = 0.6f;      // likewise: other words
constexpr float kMostShared = 0.25f;  // of a letter's rectangle: neighbours in a word lean over each other

struct Letter {
    ImRect place, clip;
    unsigned code = 0;
    bool cut_at_side = false, cut_above = false;  // above or below
};

// Letters by where they are in the font's texture. Where Dear ImGui cuts one itself, a part of that rectangle is drawn.
class FontLetters {
public:
    FontLetters() {
        for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
            for (const ImFontGlyph& glyph : font->Glyphs)
                letters_.try_emplace({glyph.U0, glyph.V0, glyph.U1, glyph.V1}, glyph.Codepoint);
    }
    Letter letter(const ImDrawVert& first, const ImDrawVert& last, const ImRect& clip) const {
        Letter found{ImRect(first.pos, last.pos), clip, '?', true, true};
        const auto whole = letters_.find({first.uv.x, first.uv.y, last.uv.x, last.uv.y});
        if (whole != letters_.end()) return {found.place, clip, whole->second, false, false};
        for (const auto& [texels, code] : letters_) {
            const ImRect in(texels[0], texels[1], texels[2], texels[3]);
            if (!in.Contains(ImRect(first.uv, last.uv))) continue;
            found.code = code;
            const auto missing = [](float drawn, float part, float all) { return drawn * (all / part - 1.0f); };
            found.cut_at_side = missing(found.place.GetWidth(), last.uv.x - first.uv.x, in.GetWidth()) > kSlack;
            found.cut_above = missing(found.place.GetHeight(), last.uv.y - first.uv.y, in.GetHeight()) > kSlack;
        }
        return found;
    }

private:
    std::map<std::array<float, 4>, unsigned> letters_;
};

// Whether some of a window's content lies beyond its right edge, out of reach.
bool is_wider_inside(const ImGuiWindow& window) {
    const bool reached = window.ScrollbarX || (window.Flags & ImGuiWindowFlags_AlwaysAutoResize) != 0;
    return !reached && window.ContentSize.x > window.InnerRect.GetWidth() - 2.0f * window.WindowPadding.x + kSlack;
}

// Whether a window's content goes on above or below what is shown.
bool scrolls(std::string_view name) {
    const ImGuiWindow* window = ImGui::FindWindowByName(std::string(name).c_str());
    return window != nullptr && window->ScrollMax.y > 0.0f;
}

// Dear ImGui draws a letter as two triangles of four vertices.
std::vector<Letter> letters_in(const ImDrawList& list, const FontLetters& font) {
    std::vector<Letter> letters;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback != nullptr || command.GetTexID() != ImGui::GetIO().Fonts->TexID) continue;
        for (unsigned i = 0; i + 5 < command.ElemCount;) {
            const ImDrawIdx* at = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
            const auto vertex = [&](int k) -> const ImDrawVert& {
                return list.VtxBuffer[static_cast<int>(command.VtxOffset + at[k])];
            };
            const ImDrawVert &first = vertex(0), &last = vertex(2);
            const bool quad = at[3] == at[0] && at[4] == at[2] && first.pos.y == vertex(1).pos.y &&
                              last.pos.x == vertex(1).pos.x && first.uv.x < last.uv.x && first.uv.y < last.uv.y;
            i += quad ? 6 : 3;
            if (!quad || (first.col >> IM_COL32_A_SHIFT) == 0) continue;
            const ImVec4 clip = command.ClipRect;
            letters.push_back(font.letter(first, last, ImRect(clip.x, clip.y, clip.z, clip.w)));
        }
    }
    return letters;
}

// Letters above or below of what scrolls are out of sight.
bool out_of_sight(const Letter& letter) {
    return letter.place.Max.y <= letter.clip.Min.y || letter.place.Min.y >= letter.clip.Max.y;
}

bool is_cut(const Letter& letter, bool scrolled) {
    const ImRect &place = letter.place, &clip = letter.clip;
    const bool at_side = place.Min.x < clip.Min.x - kSlack || place.Max.x > clip.Max.x + kSlack;
    const bool above = place.Min.y < clip.Min.y - kSlack || place.Max.y > clip.Max.y + kSlack;
    return letter.cut_at_side || at_side || ((letter.cut_above || above) && !scrolled);
}

std::string utf8(unsigned code) {
    std::array<char, 5> bytes{};
    ImTextCharToUtf8(bytes.data(), code);
    return bytes.data();
}

struct LoggedWords {
    ImRect place;
    std::string text;
    bool cut = false, overlapped = false;
};

bool shares_much(const ImRect& a, const ImRect& b) {
    ImRect both = a;
    both.ClipWith(b);
    const auto area = [](const ImRect& r) { return std::max(r.GetWidth(), 0.0f) * std::max(r.GetHeight(), 0.0f); };
    return both.GetWidth() > kSlack && both.GetHeight() > kSlack &&
           area(both) > kMostShared * std::min(area(a), area(b));
}

std::vector<LoggedWords> logged_words(const std::vector<Letter>& letters, bool scrolled) {
    const float em = ImGui::GetFontSize();
    std::vector<LoggedWords> all;
    const Letter* before = nullptr;
    for (const Letter& letter : letters) {
        if (out_of_sight(letter)) continue;
        const float gap = before != nullptr ? letter.place.Min.x - before->place.Max.x : 0.0f;
        const bool goes_on = before != nullptr && std::fabs(gap) < kLineGap * em &&
                             std::fabs(letter.place.Max.y - before->place.Max.y) < em &&
                             letter.place.Min.x > before->place.Min.x;
        if (!goes_on) all.push_back({letter.place, "", false, false});
        LoggedWords& words = all.back();
        if (goes_on && gap > kWordGap * em) words.text += ' ';
        words.text += utf8(letter.code);
        words.place.Add(letter.place);
        words.cut |= is_cut(letter, scrolled);
        before = &letter;
    }
    return all;
}

// Words whose letters lie on letters of other words. Windows hold some hundred words: all pairs.
void find_overlaps(std::vector<LoggedWords>& all) {
    for (LoggedWords& one : all)
        for (const LoggedWords& other : all) one.overlapped |= &one != &other && shares_much(one.place, other.place);
}

std::string rectangle(const ImRect& r) {
    return fmt::format("{:.0f} {:.0f} {:.0f} {:.0f}", r.Min.x, r.Min.y, r.GetWidth(), r.GetHeight());
}

// From "##" on. Children's names hold their parents' after a slash, and numbers.
std::string name_of(const char* owner) {
    std::string name = owner != nullptr ? owner : "";
    if (const auto id = name.find("##"); id != std::string::npos) name.erase(0, id);
    std::ranges::replace(name, ' ', '_');
    return name;
}

}  // namespace

std::string panel_layout() {
    std::string text;
    const ImRect screen({0.0f, 0.0f}, ImGui::GetIO().DisplaySize);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (!window->Active || window->Hidden) continue;
        const std::string name = name_of(window->Name);
        if (is_wider_inside(*window)) text += fmt::format("fault {} holds more than its width\n", name);
        if ((window->Flags & ImGuiWindowFlags_ChildWindow) != 0) continue;
        text += fmt::format("window {} {}\n", name, rectangle(window->Rect()));
        ImRect shown = window->Rect();
        shown.Expand(-kSlack);
        if (!screen.Contains(shown)) text += fmt::format("fault {} outside\n", name);
    }
    const FontLetters font;
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        const ImDrawList& list = *drawn.CmdLists[i];
        const std::string name = name_of(list._OwnerName);
        auto all = logged_words(letters_in(list, font), scrolls(list._OwnerName != nullptr ? list._OwnerName : ""));
        find_overlaps(all);
        for (const LoggedWords& words : all) {
            text += fmt::format("text {} {} {}\n", name, rectangle(words.place), words.text);
            if (words.cut) text += fmt::format("fault {} cut: {}\n", name, words.text);
            if (words.overlapped) text += fmt::format("fault {} overlap: {}\n", name, words.text);
        }
    }
    return text;
}

void LayoutLog::look() {
    if (is_open()) seen_ = panel_layout();
}

Status LayoutLog::rest(int last_key) {
    std::string text = fmt::format("key {}\n", last_key) + seen_;
    if (!is_open() || text == written_) return Done{};
    written_ = std::move(text);
    return write_text_atomically(path_, written_);
}

}  // namespace nullscope::viewer
