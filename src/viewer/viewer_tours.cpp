// What the viewer does with guided tours.
#include <utility>

#include "viewer/panel_rows.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {

Status Viewer::start_tour(const std::filesystem::path& file) {
    TRY(tour, load_tour(file));
    if (Status loaded = load_step(view_, tour->steps.front()); !loaded) return loaded;
    panels_.tour.start(std::move(*tour));
    gallery_.close();
    // What lies over the picture is not what its text speaks of.
    close_for_tour(view_);
    view_.show_errors = view_.show_orders = view_.show_potential = false;
    view_.overlays.clear();
    return Done{};
}

bool Viewer::open_tour(const std::filesystem::path& file) {
    leave_scene();
    const Status started = start_tour(file);
    if (!started) say(started.error().message());
    view_.error.clear();
    return static_cast<bool>(started);
}

bool Viewer::step_tour(int ahead) {
    const TourStep* step = gallery_.is_open() ? nullptr : panels_.tour.at(ahead);
    if (step == nullptr) {
        if (ahead > 0 && !gallery_.is_open() && panels_.tour.at_last())
            say("This was the tour's last step. Escape closes it; Help has other tours");
        return false;
    }
    leave_scene();
    const Status loaded = load_step(view_, *step);
    if (loaded)
        panels_.tour.go(ahead);
    else
        say(std::exchange(view_.error, {}));
    return static_cast<bool>(loaded);
}

bool Viewer::tour_panels(float left, float bottom) {
    const int ahead = panels_.tour.draw(left, bottom);
    if (std::exchange(panels_.tour.others_pressed, false)) {
        set_open(view_, kToursPanel, true);
        pace_.want(kSettlingFrames);
    }
    return ahead != 0 && step_tour(ahead);
}

}  // namespace nullscope::viewer
