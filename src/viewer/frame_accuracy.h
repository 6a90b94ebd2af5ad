// The accuracy of the frame on the screen: when it is measured, and the heat map over the picture.
#pragma once
#include <atomic>
#include <string>

#include "gl/gl.h"
#include "studio/error_watch.h"
#include "viewer/resting_frame.h"
#include "viewer/window.h"

namespace nullscope::viewer {

// What panel and legend show.
struct AccuracyFacts {
    ErrorSummary errors;  // of the last frame that was measured
    bool of_this_frame = false;
    std::string error;  // why nothing can be measured, or nothing
};

// Measures only what is looked at, and only a frame that rests: one read-back a frame then, none in flight.
class FrameAccuracy {
public:
    FrameAccuracy();

    // What is drawn from now on. Stops what is being measured if the rays are other ones.
    void frame_is(const Scene& scene, const Method& method);
    // Starts, stops and takes over what was found. True if there is something new to draw.
    bool update(bool wanted, bool moving);
    bool asks_for_rays() const { return frame_.asks_for_rays(); }  // of the frame that rests; until they come
    void take_rays(const Scene& scene, RayFrame rays);             // nothing if the frame is another by now
    double wait() const { return frame_.wait(); }  // s until update() has something to do of its own; infinite: nothing
    bool at_work() const;                          // there will be more to show, without a hand
    void draw_overlay();                           // between NewFrame and Render: below the panels
    AccuracyFacts facts() const;

private:
    std::string error_;
    std::atomic<bool> news_ = false;
    RestingFrame frame_;  // with rays: it is or was measured, or cannot be
    Image<unsigned char> heat_;
    gl::Texture overlay_;
    ErrorWatch watch_;  // last: its threads end before the rest
};

// Bar, ticks and words of the overlay's colours. bottom: of the place it may take.
void draw_error_legend(const AccuracyFacts& facts, float bottom);

}  // namespace nullscope::viewer
