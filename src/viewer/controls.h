// Input to camera: drags, wheel, flight keys and gamepad.
#pragma once
#include <array>
#include <optional>

#include "base/vec.h"
#include "studio/view_state.h"
#include "viewer/window.h"

namespace nullscope::viewer {

class Controls {
public:
    // Moves view.scene.camera by the input of the last dt_s seconds; true if anything moved. Mouse and keys
    // are left alone where a panel has them.
    bool apply(const Input& input, ViewState& view, double dt_s, bool panel_has_mouse, bool panel_has_keys);
    // A key or a stick is held or the wheel's motion has not run out: another frame is due without waiting for events.
    bool in_motion() const { return in_motion_; }
    bool dragging() const { return drag_ != Drag::kNone; }
    // Where the left button went down and up again in this turn of the loop or those before, with the pointer at rest; px.
    std::optional<std::array<double, 2>> click() const { return click_; }

private:
    enum class Drag { kNone, kLook, kRoll, kOrbit };
    void start_drag(const Input& input, const CameraSpec& camera, bool panel_has_mouse);
    bool drag(const Input& input, Scene& scene);
    bool wheel(const Input& input, ViewState& view, double dt_s, bool panel_has_mouse);
    bool keys(const Input& input, ViewState& view, double dt_s);

    Drag drag_ = Drag::kNone;
    Button Input::*button_ = &Input::left;  // that drags
    double farthest_ = 0.0;                 // px that the pointer was from where the drag began
    std::optional<std::array<double, 2>> click_;
    double x_ = 0.0, y_ = 0.0;  // the pointer when the picture was last moved
    Vec3 grabbed_;              // camera axes, in the orientation grabbed_from_
    Mat3 grabbed_from_;
    double approach_ = 0.0;  // of log(r - horizon), still to go
    double dive_ = 0.0;      // of zoom.depth, still to go
    bool in_motion_ = false;
};

}  // namespace nullscope::viewer
