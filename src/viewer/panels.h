// What lies over the picture: side panel, status line, keys, messages.
#pragma once
#include <filesystem>
#include <string>

#include "viewer/sections.h"

namespace nullscope::viewer {

// Over a window that has no picture yet, or that of another scene: what is being done. Between NewFrame and Render.
void draw_wait(const std::string& scene, const PaintProgress& progress, bool over_picture);

float side_panel_right();  // where the picture begins that it does not cover
float status_height();     // of the line at the window's bottom

// How to begin, over the first picture that a user sees. Between NewFrame and Render, as what follows.
void draw_hints();
// From `left` to `right`, in the window's middle where those leave little room, and above `bottom`; in several lines if need be.
void draw_message(const std::string& message, float left, float right, float bottom);
// A scene that was changed and not saved, of a viewer that did not end as it should: what the user wants with it.
enum class LeftScene { kWaits, kRestored, kDiscarded };
LeftScene draw_left_scene(const std::filesystem::path& file);
// Version, driver and credits, to be copied. shown: false once it was closed.
void draw_about(bool& shown, const gl::Info& info);

// Between ImGui's NewFrame and Render. The list of keys begins at `top`; what explains the picture lies above
// `bottom`. True when the scene changed.
bool draw_panels(ViewState& view, const FrameFacts& facts, float top, float bottom, bool escape);

}  // namespace nullscope::viewer
