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
    void begin_frame(double text_scale);  // follows the window to a screen of another scale

private:
    Window& window_;
    double content_scale_ = 0.0, pixel_ratio_ = 0.0;
};

}  // namespace nullscope::viewer
