#include "viewer/controls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observer/pose.h"
#include "scene/projection.h"
#include "studio/fly_camera.h"
#include "viewer/ring_zoom.h"

namespace nullscope::viewer {
namespace {

constexpr double kClick_px = 3.0;  // that the pointer of a click may move
constexpr double kFlight = 0.7;  // 1/s: far away a second of W leaves exp(-0.7), a half, of the distance to the horizon
constexpr double kTurn = 0.8;    // rad/s of Q and E
constexpr double kLook = 1.2;    // 1/s, of the field of view: a gamepad's stick
constexpr double kWidestLook = 1.2;   // rad: no faster than in this
constexpr double kWheelStep = 0.15;   // of log(r - horizon) a notch
constexpr double kWheelRate = 12.0;   // 1/s: how fast that is worked off
constexpr double kWheelRest = 1e-3;   // below this the rest is done at once
constexpr double kDiveStep = 0.35;    // of zoom.depth a notch
constexpr double kZoomStep = 0.08;    // of log tan(fov/2) a notch
constexpr double kRollRadius = 12.0;  // px about the picture's middle where the angle of the pointer says nothing

double axis(const Input& input, int plus, int minus) {
    return (input.down(plus) ? 1.0 : 0.0) - (input.down(minus) ? 1.0 : 0.0);
}

void store_orientation(const Mat3& world_from_camera, CameraSpec& camera) {
    set_axes(camera, transposed(world_from_static(camera.theta, camera.phi)) * world_from_camera);
}

// By a factor on the picture's width: of a pinhole that is a tangent's, of others the field of view.
void zoom_lens(CameraSpec& camera, double factor) {
    const double fov = field_of_view(camera);
    const ProjectionRow& row = projection_of(camera);
    set_fov(camera, row.width != nullptr ? row.field_of_width(row.width(fov) * factor) : factor * fov);
}

}  // namespace

bool Controls::apply(const Input& input, ViewState& view, double dt_s, bool panel_has_mouse, bool panel_has_keys) {
    in_motion_ = false;
    click_.reset();
    start_drag(input, view.scene.camera, panel_has_mouse);
    bool changed = drag(input, view.scene);
    changed |= wheel(input, view, dt_s, panel_has_mouse);
    if (!panel_has_keys) changed |= keys(input, view, dt_s);
    return changed;
}

void Controls::start_drag(const Input& input, const CameraSpec& camera, bool panel_has_mouse) {
    if (panel_has_mouse || drag_ != Drag::kNone) return;
    if (input.left.pressed)
        drag_ = input.left.alt ? Drag::kOrbit : Drag::kLook, button_ = &Input::left;
    else if (input.right.pressed)
        drag_ = Drag::kRoll, button_ = &Input::right;
    else if (input.middle.pressed)
        drag_ = Drag::kOrbit, button_ = &Input::middle;
    else
        return;
    const Button& button = input.*button_;
    x_ = button.pressed_x, y_ = button.pressed_y;
    farthest_ = 0.0;
    grabbed_ = pixel_direction(camera, x_, y_);
    grabbed_from_ = fly_camera(camera).world_from_camera;
}

// The view follows from where it was grabbed, not from the last frame: a hand that comes back brings the picture back.
bool Controls::drag(const Input& input, Scene& scene) {
    CameraSpec& camera = scene.camera;
    if (drag_ == Drag::kNone) return false;
    const Drag kind = drag_;
    const Button& button = input.*button_;
    if (!button.held) drag_ = Drag::kNone;
    const double x = button.held ? input.x : button.released_x, y = button.held ? input.y : button.released_y;
    farthest_ = std::max(farthest_, std::hypot(x - button.pressed_x, y - button.pressed_y));
    if (!button.held && kind == Drag::kLook && farthest_ < kClick_px) click_ = {{x, y}};
    if (x == x_ && y == y_) return false;
    if (kind == Drag::kLook && camera.zoom) {
        zoom_along(scene, x - x_, y_ - y);
    } else if (kind == Drag::kLook) {
        store_orientation(dragged(grabbed_from_, grabbed_, pixel_direction(camera, x, y)), camera);
    } else if (kind == Drag::kOrbit) {
        const double angle = std::numbers::pi / camera.height;  // of a pixel: half a turn for the picture's height
        orbit(camera, angle * (x - x_), angle * (y - y_));
    } else {
        const double ax = x_ - 0.5 * camera.width, ay = 0.5 * camera.height - y_;
        const double bx = x - 0.5 * camera.width, by = 0.5 * camera.height - y;
        const bool far = std::min(std::hypot(ax, ay), std::hypot(bx, by)) > kRollRadius;
        const double turned = far ? std::atan2(ax * by - ay * bx, ax * bx + ay * by) : 0.0;
        store_orientation(rolled(fly_camera(camera).world_from_camera, turned), camera);
    }
    x_ = x, y_ = y;
    return true;
}

bool Controls::wheel(const Input& input, ViewState& view, double dt_s, bool panel_has_mouse) {
    bool changed = false;
    // Some systems turn the wheel sideways while shift is down.
    const double notches = input.wheel + (input.shift ? input.wheel_sideways : 0.0);
    if (!panel_has_mouse && notches != 0.0) {
        CameraSpec& camera = view.scene.camera;
        if (input.down(GLFW_KEY_Z)) {
            dive_ += kDiveStep * notches;
        } else if (input.shift) {
            zoom_lens(camera, std::exp(-kZoomStep * notches));
            changed = true;
        } else {
            approach_ -= kWheelStep * notches;
        }
    }
    const auto worked_off = [dt_s](double& left) {
        const double part = std::fabs(left) < kWheelRest ? left : left * (1.0 - std::exp(-kWheelRate * dt_s));
        left -= part;
        return part;
    };
    if (dive_ != 0.0) changed |= zoom_by(view.scene, worked_off(dive_), view.error);
    if (!view.error.empty()) dive_ = 0.0;
    in_motion_ |= dive_ != 0.0;
    if (approach_ == 0.0) return changed;
    const double part = worked_off(approach_);
    in_motion_ |= approach_ != 0.0;
    if (const auto spacetime = spacetime_of(view.scene))
        view.scene.camera.r = scaled_radius(view.scene.camera.r, part, flight_range(*spacetime));
    return true;
}

bool Controls::keys(const Input& input, ViewState& view, double dt_s) {
    Vec3 move{axis(input, GLFW_KEY_D, GLFW_KEY_A), axis(input, GLFW_KEY_SPACE, GLFW_KEY_C),
              axis(input, GLFW_KEY_S, GLFW_KEY_W)};
    move = length(move) > 0.0 ? normalized(move) : input.pad.fly;
    const double keys_roll = axis(input, GLFW_KEY_E, GLFW_KEY_Q), roll = keys_roll != 0.0 ? keys_roll : input.pad.roll;
    const bool moves = length(move) > 0.0, turns = input.pad.right != 0.0 || input.pad.up != 0.0;
    if (!moves && !turns && roll == 0.0) return false;
    in_motion_ = true;
    const auto spacetime = spacetime_of(view.scene);
    if (spacetime == nullptr) return false;
    CameraSpec& camera = view.scene.camera;
    if (roll != 0.0) {
        store_orientation(rolled(fly_camera(camera).world_from_camera, roll * kTurn * dt_s), camera);
        drag_ = Drag::kNone;  // what was grabbed is not under the pointer any more
    }
    if (turns) {
        const double look = kLook * std::min(field_of_view(camera), kWidestLook) * dt_s;
        const double right = look * input.pad.right, up = look * input.pad.up;
        const Vec3 towards{std::sin(right) * std::cos(up), std::sin(up), -std::cos(right) * std::cos(up)};
        store_orientation(dragged(fly_camera(camera).world_from_camera, towards, {0, 0, -1}), camera);
        drag_ = Drag::kNone;
    }
    if (moves) {
        FlyCamera flying = fly_camera(camera);
        fly(flying, kFlight * flight_range(*spacetime).pace(camera.r) * dt_s * move, *spacetime);
        write_spec(flying, camera);
    }
    return true;
}

}  // namespace nullscope::viewer
