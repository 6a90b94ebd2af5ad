// The sections of the side panel. Each edits what it shows and returns true when the scene changed.
#pragma once
#include <string>
#include <vector>

#include "studio/method_choice.h"
#include "studio/view_state.h"
#include "viewer/frame_accuracy.h"
#include "viewer/painter.h"
#include "viewer/polarisation_numbers.h"

namespace nullscope::viewer {

// escape: the key was just pressed; an open list takes it.
void scene_section(ViewState& view, bool escape);  // what is to be opened: view.wanted
bool camera_section(ViewState& view);
bool boost_section(ViewState& view);
bool fall_section(ViewState& view);
Status release(ViewState& view);                 // the camera falls freely from here
std::string end_of_fall(const ViewState& view);  // where a fall that has ended did, in words
bool clock_section(ViewState& view);
inline constexpr double kClockStep_s = 0.1;
bool step_clock(ViewState& view, double dt_s);  // the scene's clock goes on; true if anything moved
bool lens_section(ViewState& view);
bool disc_section(ViewState& view, bool escape);
bool sky_section(ViewState& view, bool escape);
bool light_section(ViewState& view, bool escape);
bool spacetime_section(ViewState& view, bool escape);
// The metric and its parameters; id: of the list of metrics.
bool spacetime_rows(SpacetimeSpec& spec, const char* label, const char* id, bool escape);

// What the panels show and do not edit.
struct FrameFacts {
    const Painting& painting;  // that is shown; without a texture there is none yet
    int number = 0;            // of it, another for each picture
    double picture_ms = 0.0;   // of the last picture, without panels
    double fps = 0.0;          // while frames follow each other; 0: drawn on demand
    PixelSize size;
    const gl::Info& info;
    PaintProgress progress;  // of the one that is on its way, if it takes long
    bool background;         // programs are compiled while the last picture stays
    const std::vector<MeasuredMethod>& measured;
    const std::string& not_measured;  // why there are no rows, or nothing
    const MethodChoice& choice;
    std::string stage_words;  // which shaders traced it, and why
    AccuracyFacts accuracy;
    const EffectTimes& times;  // of the painting
    const PolarisationNumbers*
        polarisation;  // of it, or while they are measured of one before; nullptr: there are none
};

// What each method errs and costs, which is chosen and why, and what this frame truly errs. True: another wish for a method.
bool accuracy_section(ViewState& view, const FrameFacts& facts, bool escape);

// Error against cost of every measured method, for the frame on the screen. Takes its place in the window's column; a
// point under the pointer says its name and its numbers.
void draw_frontier_plot(const ViewState& view, const FrameFacts& facts);

// Of the spacetime, the camera and the picture's polarisation; changes nothing.
bool numbers_section(ViewState& view, const FrameFacts& facts);

// What the scene calls for and why, what each effect costs in this frame, and a switch for each.
bool effects_section(ViewState& view, const FrameFacts& facts);

}  // namespace nullscope::viewer
