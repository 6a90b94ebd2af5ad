// What telescopes measure of the picture on the screen, and the picture as they resolve it. Of a comparison: side A.
#pragma once
#include <optional>
#include <string>

#include "gl/gl.h"
#include "telescope/live_telescope.h"

namespace nullscope::viewer {

inline constexpr float kTelescopeWidth = 24.0f;  // of the font's size

struct PanelPlace;
struct Painting;

// In place of the one that was drawn, as a framebuffer has it (first row below); texture 0: there is none.
struct SeenPicture {
    unsigned texture = 0;
    int width = 0, height = 0;
};

class TelescopePanel {
public:
    void draw(PanelPlace& place);
    SeenPicture seen() const { return seen_; }

private:
    void look(const Painting& painting, int number);
    void show_through();  // makes the texture of seen()
    void draw_wishes(const PanelPlace& place);
    void draw_found(const PanelPlace& place);

    std::optional<LiveTelescope> telescope_;
    std::string refusal_;  // why there is nothing to see, or nothing
    int number_ = -1;      // of the painting that was looked at
    Scene scene_;          // whose light it is
    int shown_changes_ = -1;
    gl::Texture texture_, plane_;
    SeenPicture seen_;
};

}  // namespace nullscope::viewer
