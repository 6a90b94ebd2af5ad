// What the panels keep between frames, and what they ask for.
#pragma once
#include <any>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "studio/bookmarks.h"
#include "studio/loop_watch.h"
#include "studio/user_files.h"
#include "viewer/bookmark_panel.h"
#include "viewer/change_watch.h"
#include "viewer/probe.h"
#include "viewer/scene_editor.h"
#include "viewer/telescope_panel.h"
#include "viewer/timeline_panel.h"
#include "viewer/tour_panel.h"

namespace nullscope::viewer {

struct Panel;

struct PanelParts {
    Probe probe;
    SceneEditor editor;
    TimelinePanel timeline;
    Bookmarks bookmarks{state_folder().empty() ? state_folder() : state_folder() / "bookmarks"};
    BookmarkPanel bookmark_strip;
    TourPanel tour;
    LoopWatch loop;
    TelescopePanel telescope;
    ChangeWatch changes;
    const std::vector<TourInfo>& all_tours() {  // that ship, read once
        if (tours.empty()) tours = shipped_tours();
        return tours;
    }
    std::vector<TourInfo> tours;
    float strips_top = 0.0f;  // of timeline, bookmarks and status line at the window's bottom, in the last frame
    std::map<const Panel*, std::any> kept;  // PanelPlace::kept

    // For the viewer to take.
    BookmarkPanel::Chosen bookmark;
    std::optional<std::filesystem::path> tour_chosen;
};

}  // namespace nullscope::viewer
