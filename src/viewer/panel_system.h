// Owns Dear ImGui's context and backends; how panels look.
#pragma once
#include "viewer/window.h"

namespace nullscope::viewer {

class PanelSystem {
public:
    explicit PanelSystem(Window& window);
    ~PanelSystem();
    PanelSystem(const PanelSystem&) = delete;
    PanelSystem& operator=(const PanelSystem&) = delete;
    // Follows the window to a screen of another scale. light: the panels' palette.
    void begin_frame(double text_scale, bool light);

private:
    Window& window_;
    double content_scale_ = 0.0, pixel_ratio_ = 0.0;
    bool light_ = false;
};

}  // namespace nullscope::viewer
