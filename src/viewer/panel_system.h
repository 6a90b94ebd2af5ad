// Owns Dear ImGui's context and backends; how panels look.
#pragma once
#include "viewer/window.h"

namespace nullscope::viewer {

inline constexpr const char* kSideWindow = "Panels##side";  // Dear ImGui lists the name before ##

class PanelSystem {
public:
    explicit PanelSystem(Window& window);
    ~PanelSystem();
    PanelSystem(const PanelSystem&) = delete;
    PanelSystem& operator=(const PanelSystem&) = delete;
    // Follows the window to a screen of another scale. light: the panels' palette. pressed: since the frame before.
    void begin_frame(double text_scale, bool light, const std::vector<KeyPress>& pressed);

    // Arrow keys, Enter and Space in the panels, beginning with the side panel; Dear ImGui then has the keyboard. Within a frame.
    void navigate(bool on);
    bool navigates() const;
    // A control was being edited or a list was open before this frame: Escape is theirs.
    bool had_control() const { return had_control_; }

private:
    Window& window_;
    double content_scale_ = 0.0, pixel_ratio_ = 0.0;
    bool light_ = false, had_control_ = false;
    bool enters_ = false;  // once Tab is up
};

}  // namespace nullscope::viewer
