// Camera, boost and lens: who looks.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/projection.h"
#include "scenefile/scene_keys.h"
#include "studio/boost_words.h"
#include "studio/fly_camera.h"
#include "viewer/length_fields.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kFarSlider = 1000.0;  // r_s, end of the slider; more can be typed
constexpr double kFastest = 0.999999;  // of c, likewise
constexpr double kDefaultSpeed = 0.5;  // of a preset where the spacetime suggests none

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

bool radius_rows(CameraSpec& camera, const FlightRange& range, const NumberStyle& style) {
    const KeyRange files = key_range("camera.r");
    if (range.throat > 0.0) {  // wormholes: through the throat, in equal steps of asinh(l/throat)
        double place = std::asinh(camera.r / range.throat);
        const double end = std::asinh(kFarSlider);
        const bool slid = slide_as(
            "Distance", place, -end, end, fmt::format("l = {:.4g}", camera.r),
            "Proper distance l from the throat: 0 at the throat, negative on the far side. The wheel changes it too.");
        if (slid) camera.r = range.throat * std::sinh(place);
        return type_number("l", camera.r, files.low, files.high, "%.6f", "The same as a number to type.") || slid;
    }
    double above = camera.r - range.horizon;
    const bool slid =
        slide_as("Distance", above, range.nearest - range.horizon, kFarSlider, length_words(above, style, 4),
                 "Distance to the horizon, r - r_horizon (to the centre if there is no horizon), on a logarithmic "
                 "scale. The wheel changes it too.",
                 Scale::kLogarithmic);
    if (slid) camera.r = std::max(range.horizon + above, range.nearest);
    return type_length("r", camera.r, range.nearest, files.high, style,
                       "The radial coordinate. The circumference of a circle about the hole is 2 pi r. The section "
                       "Numbers chooses the unit.") ||
           slid;
}

void set_velocity(ViewState& view, double speed) {
    view.scene.camera.velocity = std::min(speed, kFastestCamera) * view.boost_direction;
}

// Turns the boost to a direction, at the speed that belongs to it where there is one.
void preset(ViewState& view, Vec3 direction, double speed) {
    view.boost_direction = direction;
    const double now = length(view.scene.camera.velocity);
    set_velocity(view, speed > 0.0 ? speed : now > 0.0 ? now : kDefaultSpeed);
}

bool preset_buttons(ViewState& view, const Spacetime& spacetime) {
    const double r = view.scene.camera.r, fall = free_fall_speed(spacetime, r);
    const auto orbit = circular_orbit_speed(spacetime, r);
    const bool falls = button_of_three(
        0, "Inward",
        fmt::format("Towards the hole, at the speed of a fall from rest at infinity: {:.4f} c here.", fall));
    const bool orbits =
        button_of_three(1, "Eastward",
                        orbit ? fmt::format("At the speed of the circular orbit: {:.4f} c here.", *orbit)
                              : "There is no circular orbit at this radius: the speed stays.");
    const bool rests = button_of_three(2, "Rest", "At rest in the frame of the observer.");
    if (falls) preset(view, {-1, 0, 0}, fall);
    if (orbits) preset(view, {0, 0, 1}, orbit.value_or(0.0));
    if (rests) view.scene.camera.velocity = {};
    return falls || orbits || rests;
}

bool direction_row(ViewState& view) {
    row("Direction",
        "Direction of the camera's speed in the frame of the observer (camera.observer): outward, south, east. "
        "Normalised to "
        "length 1.");
    double parts[3] = {view.boost_direction.x, view.boost_direction.y, view.boost_direction.z};
    if (!ImGui::DragScalarN("##direction", ImGuiDataType_Double, parts, 3, 0.01f, nullptr, nullptr, "%.2f"))
        return false;
    const Vec3 wanted{parts[0], parts[1], parts[2]};
    const double size = length(wanted);
    if (!std::isfinite(size) || size < 1e-6) return false;
    const double speed = length(view.scene.camera.velocity);
    view.boost_direction = wanted / size;
    set_velocity(view, speed);
    return speed > 0.0;
}

}  // namespace

bool camera_section(ViewState& view) {
    CameraSpec& camera = view.scene.camera;
    const auto spacetime = spacetime_of(view.scene);
    const bool changed = spacetime != nullptr &&
                         radius_rows(camera, flight_range(*spacetime), style_in(view.scene, *spacetime, view.numbers));
    bool turned = drag_key_degrees("camera.theta", "Polar angle", camera.theta,
                                   "theta: 0 above the north pole, 90 in the disc's plane.");
    turned |= drag_key_degrees("camera.phi", "Azimuth", camera.phi, "phi: about the axis of the poles.");
    turned |= drag_key_degrees("camera.yaw", "Yaw", camera.yaw,
                               "Rotation to the right; at 0 the camera looks at the centre.");
    turned |= drag_key_degrees("camera.pitch", "Pitch", camera.pitch, "Rotation upward, after yaw.");
    turned |= drag_key_degrees("camera.roll", "Roll", camera.roll, "Rotation about the line of sight, after pitch.");
    if (turned)
        for (double* angle : {&camera.phi, &camera.yaw, &camera.pitch, &camera.roll}) *angle = wrapped(*angle);
    return changed || turned;
}

bool boost_section(ViewState& view) {
    CameraSpec& camera = view.scene.camera;
    double speed = length(camera.velocity);
    if (speed > 0.0) view.boost_direction = camera.velocity / speed;
    double rapidity = std::atanh(std::min(speed, kFastest));
    const double gamma = 1.0 / std::sqrt((1.0 - speed) * (1.0 + speed));
    bool changed = slide_as("Speed", rapidity, 0.0, std::atanh(kFastest), fmt::format("gamma = {:.4g}", gamma),
                            "Speed of the camera in the frame of the observer, as a fraction of the speed of light; "
                            "the slider is linear in "
                            "rapidity.");
    if (changed) set_velocity(view, std::tanh(rapidity));
    speed = length(camera.velocity);
    const bool typed = type_number("beta", speed, 0.0, kFastestCamera, "%.12g c", "v/c as a number to type.");
    if (typed) set_velocity(view, speed);
    changed |= direction_row(view) || typed;
    const auto spacetime = spacetime_of(view.scene);
    changed |= spacetime != nullptr && preset_buttons(view, *spacetime);
    if (length(camera.velocity) > 0.0 || falls(camera)) paragraph(boost_words(camera));
    return changed;
}

bool lens_section(ViewState& view) {
    CameraSpec& camera = view.scene.camera;
    double fov = field_of_view(camera);
    constexpr double kDegrees = 180.0 / M_PI;
    const FieldOfView& field = projection_of(camera).field;
    const bool zoomed = slide_key_degrees(
        "camera.fov", "View", fov, field.steered_least * kDegrees, field.steered_most * kDegrees,
        "Horizontal field of view, of a pinhole below 180 degrees. Shift and the wheel change it too.");
    if (zoomed) set_exact_fov(camera, fov);
    return slide_key("camera.exposure", "Exposure", camera.exposure_ev, -10.0, 10.0, "%+.2f EV",
                     "The picture's brightness is multiplied by 2^EV.") ||
           zoomed;
}

}  // namespace nullscope::viewer
