// What lies over the picture, behind the panels, and belongs to it.
#pragma once
#include <algorithm>
#include <array>
#include <memory>

#include "viewer/divider.h"
#include "viewer/frame_accuracy.h"
#include "viewer/order_overlay.h"
#include "viewer/picture_marks.h"

namespace nullscope::viewer {

struct PictureCover {
    std::unique_ptr<FrameAccuracy> accuracy;
    std::array<OrderOverlay, 2> orders;  // of both sides
    PictureMarks marks;
    Divider divider;

    bool orders_at_work() const { return std::ranges::any_of(orders, &OrderOverlay::at_work); }
    // s until one of them has something to do of its own; infinite: nothing.
    double wait() const { return std::min({accuracy->wait(), orders[0].wait(), orders[1].wait()}); }
};

}  // namespace nullscope::viewer
