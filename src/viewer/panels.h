// What lies over the picture besides panels (viewer/panel.h): status line, messages, what is asked once.
#pragma once
#include <imgui.h>

#include <filesystem>
#include <string>

#include "viewer/sections.h"

namespace nullscope::viewer {

// Over a window that has no picture yet, or that of another scene: what is being done. Between NewFrame and Render.
void draw_wait(const std::string& scene, const PaintProgress& progress, bool over_picture);

// Of windows that are not moved; their distance from the window's edge, and that between strips, of the font's size.
inline constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                           ImGuiWindowFlags_NoNav;
inline constexpr float kPanelMargin = 0.6f, kStripGap = 0.6f;

float side_panel_right();  // where the picture begins that it does not cover
float status_height();     // of the line at the window's bottom

// How to begin, over the first picture that a user sees. Between NewFrame and Render, as what follows.
void draw_hints();
// From `left` to `right`, in the window's middle where those leave little room, and above `bottom`; in several lines if need be.
void draw_message(const std::string& message, float left, float right, float bottom);
// A scene that was changed and not saved, of a viewer that did not end as it should: what the user wants with it.
enum class LeftScene { kWaits, kRestored, kDiscarded };
LeftScene draw_left_scene(const std::filesystem::path& file);
// The status line, where it is there, and what explains the colours of errors, above `bottom`.
void draw_frame_facts(const ViewState& view, const FrameFacts& facts, float bottom);

}  // namespace nullscope::viewer
