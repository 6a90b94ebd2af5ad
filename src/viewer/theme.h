// How panels look: fonts and colours of Dear ImGui.
#pragma once

namespace nullscope::viewer {

// Sets style and fonts anew. content_scale: how much larger than usual, in framebuffer pixels; pixel_ratio: framebuffer
// pixels a unit of ImGui's coordinates. Only between frames.
void apply_theme(double content_scale, double pixel_ratio);

inline constexpr float kFontSize = 15.0f;  // units of ImGui's coordinates at a content scale of 1

}  // namespace nullscope::viewer
