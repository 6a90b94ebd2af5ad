// A window with every key of the scene: unit, range and help from the key table, reset to the default, search; sections that can be added,
// copied and removed.
#pragma once
#include <string>

#include "scenefile/scene_edit.h"
#include "studio/additions.h"
#include "studio/view_state.h"

namespace nullscope::viewer {

class SceneEditor {
public:
    // Between NewFrame and Render, at the right of what lies between top and bottom. True when the scene changed; what cannot be is said in
    // the window, and changes nothing. open: false once it was closed. escape: the key was pressed, and shuts an open list.
    bool draw(ViewState& view, bool& open, float top, float bottom, bool escape);

    void forget() { width_ = 0.0f; }        // in a frame without it
    float width() const { return width_; }  // that it takes of the window's right in this frame, with the gap beside it

    // What of the window is free between top and bottom, beside the side panel and the editor, open or not; all of it where little is left.
    static FreePart free_part(float top, float bottom);

    // Opens this section, scrolls to it and marks it, until another one is or sections are removed or copied.
    void reveal(const std::string& label) { reveal_ = marked_ = label, words_.clear(); }

private:
    bool draw_section(ViewState& view, const SectionRef& at, const Scene& holder, bool escape);
    bool draw_buttons(ViewState& view, const SectionRef& at);
    bool draw_key(ViewState& view, const SectionRef& at, const Scene& holder, const Scene& defaults,
                  const SceneKey& key, bool escape);
    bool take(ViewState& view, Result<Scene> edited);
    bool matches(const SceneKey& key) const;

    std::string words_, fault_, reveal_, marked_;
    float width_ = 0.0f;
    NumberStyle style_;  // of the scene that is drawn
};

}  // namespace nullscope::viewer
