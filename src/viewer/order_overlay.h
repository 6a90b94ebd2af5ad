// Image orders in colours over the picture: n = floor(angle/pi) of the angle that a pixel's ray sweeps about the centre.
#pragma once
#include <string>

#include "gl/gl.h"
#include "viewer/resting_frame.h"

namespace nullscope::viewer {

inline constexpr const char* kOrdersHelp =
    "Colours sky and disc by the image order n: how many half turns about the hole their light has made.";
inline constexpr int kMostOrder = 3;  // that has a colour of its own; it stands for those above it

// Why there are none in this scene, or nothing. Cost: makes a spacetime.
std::string no_orders(const Scene& scene);

class OrderOverlay {
public:
    void frame_is(const Scene& scene, const Method& method) { frame_.frame_is(scene, method); }
    void update(bool wanted, bool moving) { frame_.update(wanted, moving); }
    bool asks_for_rays() const { return frame_.asks_for_rays(); }
    void take_rays(const Scene& scene, const RayFrame& rays);  // nothing if the frame is another by now
    double wait() const { return frame_.wait(); }
    bool at_work() const;
    void draw() const;  // between NewFrame and Render: below the panels; nothing until the frame rests

private:
    RestingFrame frame_;
    gl::Texture tint_;
};

// The colours and their orders, in the lower left corner of what lies between `left` and `right` above `bottom`; in
// lines, and nothing where that is too narrow.
void draw_order_legend(float left, float right, float bottom);

}  // namespace nullscope::viewer
