// The pictures that the viewer has to do with: the one on the screen, the one it has asked for, the one that is due.
#pragma once
#include <optional>
#include <string>
#include <utility>

#include "studio/method_choice.h"
#include "studio/view_state.h"
#include "viewer/frame_renderer.h"

namespace nullscope::viewer {

struct ShownPicture {
    Painting painting;
    ViewState view;  // of the last that could be prepared
    MethodChoice choice;
    std::pair<std::string, std::string> side_words;
    std::string zoom_words;             // of no zoom empty
    int number = 0;                     // pictures until now
    std::optional<double> news_due_at;  // until it is shown for the first time: when the input came that it follows

    bool is_there() const { return painting.texture != 0; }
    const Scene& scene() const { return painting.job.scene; }
    // Side A or B of a comparison; nullptr: there is no B.
    const PaintJob* side(std::size_t side) const { return side == 0 ? &painting.job : side_b(); }
    const PaintJob* side_b() const { return painting.texture_b != 0 ? painting.job.side_b.get() : nullptr; }
};

struct AskedPicture {
    ViewState view;  // as it was then
    MethodChoice choice;
    double at = 0.0, due_at = 0.0;  // s: when; when the input came that it follows
};

struct DuePicture {
    bool picture = true;       // the view has changed since the last was asked for
    bool coarse = true;        // soon rather than whole: the user moves it
    bool error_stays = false;  // the view's error is of the last change, which was undone: until the next one
    bool save = false;         // F12, while the picture was not whole
    bool bookmark = false;     // Ctrl+B, likewise
    double since = 0.0;        // s: when the input came that waited longest
};

}  // namespace nullscope::viewer
