// What the panels keep between frames, and what they ask for.
#pragma once
#include <vector>

#include "studio/bookmarks.h"
#include "studio/user_files.h"
#include "viewer/bookmark_panel.h"
#include "viewer/probe.h"
#include "viewer/scene_editor.h"
#include "viewer/timeline_panel.h"
#include "viewer/tour_panel.h"

namespace nullscope::viewer {

struct PanelParts {
    Probe probe;
    SceneEditor editor;
    TimelinePanel timeline;
    Bookmarks bookmarks{state_folder().empty() ? state_folder() : state_folder() / "bookmarks"};
    BookmarkPanel bookmark_strip;
    TourPanel tour;
    std::vector<TourInfo> tours;  // that ship, once they were asked for
    float strips_top = 0.0f;      // of timeline, bookmarks and status line at the window's bottom, in the last frame
};

}  // namespace nullscope::viewer
