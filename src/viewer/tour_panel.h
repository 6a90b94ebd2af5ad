// Guided tours: the panel above the status line that leads through one, and the list of those that ship.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "scenefile/tour_file.h"

namespace nullscope::viewer {

class TourPanel {
public:
    void start(Tour tour) { tour_ = std::move(tour), step_ = 0; }
    void close() { tour_.reset(); }
    bool is_open() const { return tour_.has_value(); }
    float height() const { return is_open() ? height_ : 0.0f; }  // that it takes, margin included

    // The step by so many before or after the one that is shown; nullptr: there is none, or no tour.
    const TourStep* at(int ahead) const;
    void go(int ahead);  // where at(ahead) is one
    bool at_last() const { return tour_ && at(1) == nullptr; }

    // Between NewFrame and Render, in the middle between `left` and the window's right edge, above `bottom`. -1: Back was pressed, 1:
    // Next, else 0.
    int draw(float left, float bottom);
    bool others_pressed = false;  // of the last step: the list of tours is asked for

private:
    int draw_buttons();
    std::optional<Tour> tour_;
    std::size_t step_ = 0;
    float height_ = 0.0f;
};

// A window with these tours, shown: false once it was closed. The tour that was clicked, or nothing.
std::optional<std::filesystem::path> draw_tour_list(bool& shown, const std::vector<TourInfo>& tours);

}  // namespace nullscope::viewer
