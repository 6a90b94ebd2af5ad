#include "viewer/guides_overlay.h"

#include <imgui.h>

namespace nullscope::viewer {
namespace {

constexpr ImU32 kGuideColour = IM_COL32(255, 255, 255, 120), kGuideRim = IM_COL32(0, 0, 0, 90);
constexpr float kSafe = 0.05f;    // of width and height, at each edge
constexpr float kMiddle = 0.02f;  // half a line of the cross, of the height

// Of both sides of a comparison alike: each is clipped to its part.
void draw_guides(OverlayPlace&) {
    const float left = 0.0f, wide = ImGui::GetIO().DisplaySize.x, high = ImGui::GetIO().DisplaySize.y;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const auto line = [&](ImVec2 from, ImVec2 to) {
        draw.AddLine(from, to, kGuideRim, 3.0f);
        draw.AddLine(from, to, kGuideColour, 1.0f);
    };
    for (const float third : {1.0f / 3.0f, 2.0f / 3.0f}) {
        line({left + third * wide, 0.0f}, {left + third * wide, high});
        line({left, third * high}, {left + wide, third * high});
    }
    const float x = left + 0.5f * wide, y = 0.5f * high, arm = kMiddle * high;
    line({x - arm, y}, {x + arm, y});
    line({x, y - arm}, {x, y + arm});
    draw.AddRect({left + kSafe * wide, kSafe * high}, {left + (1.0f - kSafe) * wide, (1.0f - kSafe) * high},
                 kGuideColour);
}

}  // namespace

const Overlay kGuidesOverlay = {"Framing guides",
                                "",
                                0,
                                "",
                                "Framing guides: thirds, the middle, and the inner 90 % of width and height.",
                                nullptr,
                                Overlay::Where::kPicture,
                                draw_guides};

}  // namespace nullscope::viewer
