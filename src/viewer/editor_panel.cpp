#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "viewer/panel_rows.h"

namespace nullscope::viewer {

const Panel kEditorPanel{
    .menu = "View",
    .name = "Scene editor",
    .keys = "Ctrl+E",
    .key = GLFW_KEY_E,
    .control = true,
    .words = "everything in the scene",
    .where = Panel::Where::kDocked,
    .draw =
        [](PanelPlace& place) {
            place.changed |= place.parts.editor.draw(place.view, place.open, place.top, place.bottom, place.escape);
            place.right -= place.parts.editor.width();
        },
    .forget = [](PanelParts& parts) { parts.editor.forget(); },
};

}  // namespace nullscope::viewer
