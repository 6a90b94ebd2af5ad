// The plots of the panel "Telescope". Each takes its place in the window's column.
#pragma once
#include <imgui.h>

#include "gl/gl.h"
#include "studio/number_words.h"
#include "telescope/live_telescope.h"

namespace nullscope::viewer {

// |V| against the baseline, its first minimum marked.
void draw_amplitudes(const LiveTelescope& telescope, const NumberStyle& style, ImVec2 size);
// |V| of the plane in grey, the array's tracks over it, those of the chosen triangle in another colour. North up, east left.
void draw_tracks(const LiveTelescope& telescope, const gl::Texture& plane, float side);
// The chosen triangle's closure phase against the hours of a day, or of the scene's clock.
void draw_closure(const LiveTelescope& telescope, const NumberStyle& style, ImVec2 size);

// The plane's grey levels: the root of |V| over the largest.
Image<unsigned char> plane_picture(const Image<float>& plane);  // RGBA

// The beam as a disc or an ellipse, its middle there; per_rad: ImGui's units.
void draw_beam(ImDrawList& draw, ImVec2 middle, const Beam& beam, double per_rad);

}  // namespace nullscope::viewer
