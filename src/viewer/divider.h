// The line between the two sides of a comparison, which the left button drags; with a handle, and a label on either side.
#pragma once
#include <string>
#include <utility>

#include "viewer/window.h"

namespace nullscope::viewer {

class Divider {
public:
    // width: of the picture, px of the framebuffer, in which it stays right of `least`. mouse_taken: by a panel or another drag.
    void follow(const Input& input, int width, double least, bool mouse_taken);
    void let_go() { over_ = held_ = has_mouse_ = false; }
    bool has_mouse() const { return has_mouse_; }  // in this turn of the loop: nothing else follows it
    int x() const { return x_; }                   // first column of side B, px of the framebuffer
    // Left and right of the line, behind the panels; between NewFrame and Render. top, bottom, left: of what no panel covers, units of
    // ImGui. unit: of a pixel of the framebuffer.
    void draw(const std::pair<std::string, std::string>& words, float left, float top, float bottom, float unit) const;
    bool under_pointer() const { return over_ || held_; }

private:
    double place_ = 0.5;    // share of the width
    double grabbed_ = 0.0;  // px from the line, when it was taken
    int x_ = 0;
    bool over_ = false, held_ = false, has_mouse_ = false;
};

}  // namespace nullscope::viewer
