// The viewer itself: window, panels, hands and renderer, and the loop that draws when there is something to draw.
#pragma once
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "gl/gl.h"
#include "viewer/controls.h"
#include "viewer/frame_accuracy.h"
#include "viewer/method_choice.h"
#include "viewer/painter.h"
#include "viewer/panels.h"
#include "viewer/probe.h"
#include "viewer/view_state.h"
#include "viewer/window.h"

namespace nullscope::viewer {

struct ViewerOptions {
    std::string scene = "first-light";
    std::optional<PixelSize> size;  // the scene's, fitted to the screen
    std::string screenshot;         // written after after_frames frames, panels included; then the viewer ends
    int after_frames = 0;           // 0: run until closed
    bool hidden = false;
    bool one_context = false;  // draws where the panels are drawn, as where a second context cannot be had
    std::string turns;         // file for a line a turn of the loop, or nothing
};

// Owns Dear ImGui's context and backends.
class PanelSystem {
public:
    explicit PanelSystem(Window& window);
    ~PanelSystem();
    PanelSystem(const PanelSystem&) = delete;
    PanelSystem& operator=(const PanelSystem&) = delete;
    void begin_frame();  // follows the window to a screen of another scale

private:
    Window& window_;
    double content_scale_ = 0.0, pixel_ratio_ = 0.0;
};

class Viewer {
public:
    // Errors: bad scene, no display, no OpenGL 3.3. throws gl::GlError.
    static Result<std::unique_ptr<Viewer>> open(const ViewerOptions& options);
    ~Viewer();
    Status run();

private:
    explicit Viewer(const ViewerOptions& options) : options_(options) {}
    Status start();
    bool step();               // one turn of the loop: true if a frame was drawn
    double wait_time() const;  // for events; 0: do not wait
    double elapsed();          // since the last step, for motion
    bool handle_keys(const Input& input);
    bool fit_to_window();  // true if the picture's size changed
    void ask();            // for what is due: a picture of view_, ray data or the effects' times
    bool take(double patience_s);   // what was asked for if it comes in time: true if there is something new to show
    void adopt(Painting painting);
    void refuse(const Painting& painting);
    void measure_effects(bool still);
    void probe(const Input& input);
    double adaptation(const Scene& scene);   // what share of its way exposure goes in the next picture
    void log_turn(double since);
    void draw(unsigned framebuffer);
    void present();
    void measure_rate();
    void save_picture();
    void say(const std::string& message);
    FrameFacts facts() const;

    ViewerOptions options_;
    ViewState view_;
    Scene shown_, shown_loaded_;  // the last that could be prepared, and its file
    Controls controls_;
    std::unique_ptr<Window> window_;  // the context: outlives what is below
    std::unique_ptr<PanelSystem> panel_system_;
    std::unique_ptr<Painter> painter_;
    Painting picture_;                 // that is shown
    bool picture_due_ = true;          // view_ has changed since the last was asked for
    gl::Info info_;
    EffectTimes effect_times_;
    double changed_at_ = 0.0;          // what the effects' times depend on
    bool times_asked_ = false;
    std::FILE* turns_ = nullptr;
    PixelSize size_;
    std::vector<MeasuredMethod> measured_;  // the frontier that ships
    std::string not_measured_;              // why it could not be read, or nothing
    MethodChoice choice_, asked_choice_;    // of the picture that is shown, of the one asked for
    ViewState asked_;
    MethodWish shown_method_;
    EffectSet shown_off_;
    std::unique_ptr<FrameAccuracy> accuracy_;
    Probe probe_;
    double adapted_at_ = 0.0, adapting_until_ = 0.0;   // s: automatic exposure follows like an eye
    std::string message_;
    double message_until_ = 0.0;
    int frames_ = 0, frames_due_ = 3;
    bool moving_ = false, waited_ = true;
    double stepped_at_ = 0.0, drawn_at_ = 0.0, rate_shown_at_ = 0.0;
    double picture_ms_shown_ = 0.0, frame_s_ = 0.0, fps_shown_ = 0.0;
};

}  // namespace nullscope::viewer
