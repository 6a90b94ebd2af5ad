// What the viewer does with guided tours.
#include <utility>

#include "viewer/viewer.h"

namespace nullscope::viewer {

Status Viewer::start_tour(const std::filesystem::path& file) {
    TRY(tour, load_tour(file));
    if (Status loaded = load_step(view_, tour->steps.front()); !loaded) return loaded;
    panels_.tour.start(std::move(*tour));
    gallery_.close();
    // What lies over the picture is not what its text speaks of.
    for (bool ViewState::*overlay : {&ViewState::show_tours, &ViewState::show_errors, &ViewState::show_orders,
                                     &ViewState::show_probe, &ViewState::show_potential})
        view_.*overlay = false;
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

const std::vector<TourInfo>& Viewer::tours() {
    if (panels_.tours.empty()) panels_.tours = shipped_tours();
    return panels_.tours;
}

bool Viewer::tour_panels(float left, float bottom) {
    bool changed = false;
    if (view_.show_tours) {
        if (const auto chosen = draw_tour_list(view_.show_tours, tours())) changed = open_tour(*chosen);
    }
    const int ahead = panels_.tour.draw(left, bottom);
    if (std::exchange(panels_.tour.others_pressed, false)) view_.show_tours = true, pace_.want(kSettlingFrames);
    return (ahead != 0 && step_tour(ahead)) || changed;
}

}  // namespace nullscope::viewer
