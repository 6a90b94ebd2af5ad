#include "viewer/bookmark_panel.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/text.h"
#include "viewer/panel_rows.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kBookmarkWidth = 11.0f;  // of the font's size
constexpr float kTallestPanel = 0.25f;   // of the window's height: a card's picture
constexpr float kEdge = 2.0f;            // px about a card, for its bright edge

void take(const Status& done, const std::string& words, std::string& message) {
    message = done ? words : done.error().message();
}

// What is broken, by its files.
void draw_broken(const std::vector<Bookmark>& all) {
    std::string first, errors;
    int more = -1;
    for (const Bookmark& bookmark : all) {
        if (bookmark.error.empty()) continue;
        if (++more == 0) first = without_controls(bookmark.stem) + ".toml";
        errors += (errors.empty() ? "" : "\n") + bookmark.error;
    }
    if (more < 0) return;
    paragraph("Not shown: " + first + (more > 0 ? fmt::format(" (and {} more)", more) : ""), true);
    tooltip(errors);
}

}  // namespace

BookmarkPanel::Chosen BookmarkPanel::draw(bool& open, Bookmarks& bookmarks, float left, float right, float bottom,
                                          bool all, bool escape) {
    height_ = 0.0f;
    loading_ = false;
    if (!std::exchange(shown_, true)) bookmarks.list();
    pictures_.begin_frame();
    read_one(bookmarks, all);
    const float margin = 0.6f * em();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float card = std::min(kBookmarkWidth * em(), kTallestPanel * screen.y / CardPicture::kShape);
    if (right - left < card + 4.0f * margin) right = screen.x;
    if (right - left < card + 4.0f * margin) left = margin;
    ImGui::SetNextWindowPos({left, bottom - margin}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSize({right - left - margin, 0.0f});
    Chosen chosen;
    if (ImGui::Begin("##bookmarks", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize)) {
        draw_buttons(open, bookmarks);
        draw_broken(bookmarks.all());
        chosen = draw_cards(bookmarks, card, all, escape);
        height_ = ImGui::GetWindowHeight() + margin;
    }
    ImGui::End();
    loading_ |= pictures_.loading();
    return chosen;
}

void BookmarkPanel::forget() {
    height_ = 0.0f;
    loading_ = shown_ = false;
    renamed_.clear();
}

void BookmarkPanel::read_one(Bookmarks& bookmarks, bool all) {
    for (const Bookmark& bookmark : bookmarks.all()) {
        if (!bookmarks.read(bookmark.stem) || all) continue;
        loading_ = true;
        return;
    }
}

void BookmarkPanel::draw_buttons(bool& open, Bookmarks& bookmarks) {
    if (ImGui::Button("Add this view")) add_pressed = true;
    tooltip("Keeps the scene as it is now, with the camera and a picture (Ctrl + B).");
    next_to(button_width("Close"));
    if (ImGui::Button("Close")) open = false;
    tooltip("B shows the bookmarks again.");
    const std::string removed = bookmarks.last_removed();
    if (removed.empty()) return;
    next_to(button_width("Restore"));
    if (ImGui::Button("Restore")) take(bookmarks.restore(), "Restored " + removed, message);
    tooltip(fmt::format("Brings back {}, which was deleted last.", removed));
}

BookmarkPanel::Chosen BookmarkPanel::draw_cards(Bookmarks& bookmarks, float width, bool all, bool escape) {
    std::vector<Bookmark> cards;
    for (const Bookmark& bookmark : bookmarks.all())
        if (bookmark.error.empty()) cards.push_back(bookmark);
    if (cards.empty()) {
        paragraph("No bookmarks yet.");
        return {};
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
    const bool scrolls = static_cast<float>(cards.size()) * (width + gap) - gap + 2.0f * kEdge > room;
    const float height = CardPicture::kShape * width + style.ItemSpacing.y + ImGui::GetFrameHeight() + 2.0f * kEdge +
                         (scrolls ? style.ScrollbarSize : 0.0f);
    Chosen chosen;
    if (ImGui::BeginChild("##cards", {0.0f, height}, false, ImGuiWindowFlags_HorizontalScrollbar)) {
        if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0.0f)
            ImGui::SetScrollX(ImGui::GetScrollX() - 0.5f * width * ImGui::GetIO().MouseWheel);
        if (std::exchange(first_, cards.front().stem) != cards.front().stem) ImGui::SetScrollX(0.0f);
        ImGui::SetCursorPos({kEdge, kEdge});
        for (const Bookmark& card : cards) {
            if (&card != &cards.front()) ImGui::SameLine(0.0f, gap);
            if (Chosen of_card = draw_card(bookmarks, card, width, all, escape); !of_card.file.empty())
                chosen = std::move(of_card);
        }
    }
    ImGui::EndChild();
    if (const std::string stem = std::exchange(deleted_, {}); !stem.empty()) {
        const Status gone = bookmarks.remove(stem);
        take(gone, fmt::format("Deleted {}: Restore brings it back until the viewer ends", bookmarks.last_removed()),
             message);
    }
    return chosen;
}

BookmarkPanel::Chosen BookmarkPanel::draw_card(Bookmarks& bookmarks, const Bookmark& bookmark, float width, bool all,
                                               bool escape) {
    ImGui::PushID(bookmark.stem.c_str());
    ImGui::BeginGroup();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    bool chosen = ImGui::InvisibleButton("##picture", {width, CardPicture::kShape * width});
    const bool over = ImGui::IsItemHovered();
    if (ImGui::IsItemVisible())
        draw_card_picture(pictures_.find(bookmarks.picture_file(bookmark.stem), all), at, width, over);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("##what");
    if (!ImGui::IsPopupOpen("##what"))
        tooltip(bookmark.name + "\nClick: open. Shift and click: the camera only. Right click: rename, delete.");
    chosen |= draw_name(bookmarks, bookmark, width);
    bool camera_only = chosen && ImGui::GetIO().KeyShift;
    if (ImGui::BeginPopup("##what")) {
        if (escape) ImGui::CloseCurrentPopup();
        chosen |= ImGui::MenuItem("Open");
        camera_only |= ImGui::MenuItem("Camera only");
        if (ImGui::MenuItem("Rename")) renamed_ = bookmark.stem, new_name_ = bookmark.name, rename_begins_ = true;
        if (ImGui::MenuItem("Delete")) deleted_ = bookmark.stem;
        ImGui::EndPopup();
    }
    ImGui::EndGroup();
    ImGui::PopID();
    if (!chosen && !camera_only) return {};
    return {bookmarks.scene_file(bookmark.stem).string(), camera_only};
}

// The name, or a field for another; true if it was clicked on.
bool BookmarkPanel::draw_name(Bookmarks& bookmarks, const Bookmark& bookmark, float width) {
    if (renamed_ == bookmark.stem) {
        if (std::exchange(rename_begins_, false)) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(width);
        const bool entered = ImGui::InputText("##name", &new_name_,
                                              ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        if (entered || ImGui::IsItemDeactivated()) rename(bookmarks, bookmark.stem);  // Escape puts the old name back
        return false;
    }
    const float dots = button_width("..."), gap = ImGui::GetStyle().ItemInnerSpacing.x, room = width - dots - gap;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    const bool chosen = ImGui::InvisibleButton("##name", {room, height});
    const ImVec4 clip{at.x, at.y, at.x + room, at.y + height};
    const std::string& name = bookmark.name.empty() ? bookmark.stem : bookmark.name;
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), em(), {at.x, at.y + ImGui::GetStyle().FramePadding.y},
                                        ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark : ImGuiCol_Text),
                                        name.c_str(), nullptr, 0.0f, &clip);
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button("...")) ImGui::OpenPopup("##what");
    tooltip("Open, take its camera only, rename, delete.");
    return chosen;
}

void BookmarkPanel::rename(Bookmarks& bookmarks, const std::string& stem) {
    renamed_.clear();
    const auto old = std::ranges::find(bookmarks.all(), stem, &Bookmark::stem);
    if (old == bookmarks.all().end() || old->name == new_name_) return;
    take(bookmarks.rename(stem, new_name_), "Renamed to " + new_name_, message);
}

namespace {

void draw_bookmarks(PanelPlace& place) {
    BookmarkPanel& strip = place.parts.bookmark_strip;
    const float right = place.right - (is_open(place.view, kProbePanel) ? place.parts.probe.width() : 0.0f);
    place.parts.bookmark = strip.draw(place.open, place.parts.bookmarks, place.left, right, place.bottom - place.gap,
                                      place.all, place.escape);
    if (strip.height() > 0.0f) place.bottom -= place.gap + strip.height();
}

}  // namespace

const Panel kBookmarksPanel{
    .menu = "View",
    .name = "Bookmarks",
    .keys = "B",
    .key = GLFW_KEY_B,
    .words = "views that were kept",
    .where = Panel::Where::kDocked,
    .draw = draw_bookmarks,
    .forget = [](PanelParts& parts) { parts.bookmark_strip.forget(); },
};

}  // namespace nullscope::viewer
