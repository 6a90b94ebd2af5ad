// Where words and windows of the panels are, and what is wrong with it, written to a file for tests: from Dear ImGui's own draw lists
// and window rectangles, so that nothing that is drawn is missed. The file is written anew whenever the viewer comes to rest:
//
//   key 284                            the last key that was pressed, as in viewer/loop_log.h
//   window ##side 9 30 285 537         name, left, top, width, height
//   text ##side 52 68 50 15 Camera     window, rectangle, words that follow each other on a line
//   fault ##side cut: Camera           letters that their clip rectangle cuts
//   fault ##side overlap: Camera       letters on other letters of the window
//   fault ##side outside               a window beyond the screen
//   fault ##status holds more than its width    without a way to scroll there
//
// Units: Dear ImGui's coordinates. Letters may be cut at the upper and lower edge of what scrolls.
#pragma once
#include <string>

#include "base/result.h"

namespace nullscope::viewer {

// Of the draw data of the frame before: after ImGui::Render(). Cost: some ms.
std::string panel_layout();

class LayoutLog {
public:
    void open(const std::string& path) { path_ = path; }
    bool is_open() const { return !path_.empty(); }
    void look();                // after ImGui::Render()
    Status rest(int last_key);  // what the last look has seen. Errors: a file that cannot be written

private:
    std::string path_, seen_, written_;
};

}  // namespace nullscope::viewer
