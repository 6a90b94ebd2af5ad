// The viewer itself: window, panels, hands and renderer, and the loop that draws when there is something to draw.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "render/renderer.h"
#include "viewer/controls.h"
#include "viewer/frame_accuracy.h"
#include "viewer/method_choice.h"
#include "viewer/panels.h"
#include "viewer/view_state.h"
#include "viewer/window.h"

namespace nullscope::viewer {

struct ViewerOptions {
    std::string scene = "first-light";
    std::optional<PixelSize> size;  // the scene's, fitted to the screen
    std::string screenshot;         // written after after_frames frames, panels included; then the viewer ends
    int after_frames = 0;           // 0: run until closed
    bool hidden = false;
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
    Status run();

private:
    explicit Viewer(const ViewerOptions& options) : options_(options) {}
    bool step();               // one turn of the loop: true if a frame was drawn
    double wait_time() const;  // for events; 0: do not wait
    double elapsed();          // since the last step, for motion
    bool handle_keys(const Input& input);
    bool fit_to_window();  // true if the picture's size changed
    Status try_prepare();  // view_.scene with the method it wishes
    void prepare();        // shows view_.scene, or what was shown before and why
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
    std::unique_ptr<Renderer> renderer_;
    PixelSize size_;
    std::vector<MeasuredMethod> measured_;  // the frontier that ships
    std::string not_measured_;              // why it could not be read, or nothing
    MethodChoice choice_;                   // of the picture that is shown
    MethodWish shown_method_;
    std::unique_ptr<FrameAccuracy> accuracy_;
    std::string message_;
    double message_until_ = 0.0;
    int frames_ = 0, frames_due_ = 3;
    bool moving_ = false, waited_ = true;
    double stepped_at_ = 0.0, drawn_at_ = 0.0, rate_shown_at_ = 0.0;
    double picture_ms_ = 0.0, picture_ms_shown_ = 0.0, frame_s_ = 0.0, fps_shown_ = 0.0;
};

}  // namespace nullscope::viewer
