// The timeline above the status line: play, scrub, loop, speed, record, keys, and the film.
#pragma once
#include <optional>
#include <string>

#include "studio/film_export.h"
#include "studio/timeline.h"
#include "studio/view_state.h"

namespace nullscope::viewer {

class TimelinePanel {
public:
    // Between NewFrame and Render, from `left` to the window's right edge, above `bottom`. True when the scene changed. What the user asks for beyond
    // that is in the members below until it is taken.
    bool draw(ViewState& view, Timeline& timeline, FilmExport& film, float left, float bottom, bool escape);

    float height() const { return height_; }  // that it takes, 0: it is not there
    void forget() { height_ = 0.0f; }         // in a frame without it

    struct FilmWish {
        std::string output;
        int width = 0, height = 0;
    };
    bool record_pressed = false;
    std::optional<FilmWish> film_wish;
    std::string refusal;  // why a button did nothing

private:
    bool draw_slider(ViewState& view, Timeline& timeline);
    bool draw_buttons(ViewState& view, Timeline& timeline);
    void draw_film(const ViewState& view, FilmExport& film, bool escape);
    std::string name_;
    int size_ = 2;  // of kSizes
    bool frames_ = false;
    float height_ = 0.0f;
};

}  // namespace nullscope::viewer
