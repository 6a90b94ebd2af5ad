// Camera, boost and lens: who looks.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/fly_camera.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFarSlider = 1000.0;  // r_s, end of the slider; more can be typed
constexpr double kFastest = 0.999999;  // of c
constexpr double kTurns = 3600.0;      // deg, as far as scene files go
constexpr double kDefaultSpeed = 0.5;  // of a preset where the spacetime suggests none

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

bool radius_rows(CameraSpec& camera, const FlightRange& range) {
    bool changed = false;
    if (range.throat > 0.0) {  // wormholes: through the throat, in equal steps of asinh(l/throat)
        row("Distance",
            "Proper distance l from the throat: 0 in it, negative on the far side. The wheel changes it too.");
        double place = std::asinh(camera.r / range.throat);
        const double end = std::asinh(kFarSlider);
        if (slide_as("##above", place, -end, end, 0, fmt::format("l = {:.4g}", camera.r))) {
            camera.r = range.throat * std::sinh(place);
            changed = true;
        }
        row("l", "The same, to be typed.");
        return type_number("##r", camera.r, -1e9, 1e9, "%.6f") || changed;
    }
    row("Distance",
        "Distance to the horizon, r - r_horizon (to the centre where there is no horizon), in equal factors. The wheel "
        "changes it too.");
    double above = camera.r - range.horizon;
    if (slide_as("##above", above, range.nearest - range.horizon, kFarSlider, ImGuiSliderFlags_Logarithmic,
                 fmt::format("{:.4g} r_s", above))) {
        camera.r = std::max(range.horizon + above, range.nearest);
        changed = true;
    }
    row("r", "The radial coordinate. The circumference of a circle about the hole is 2 pi r.");
    return type_number("##r", camera.r, range.nearest, 1e9, "%.6f r_s") || changed;
}

void set_velocity(ViewState& view, double speed) {
    view.scene.camera.velocity = std::min(speed, kFastest) * view.boost_direction;
}

// Turns the boost to a direction, at the speed that belongs to it where there is one.
void preset(ViewState& view, Vec3 direction, double speed) {
    view.boost_direction = direction;
    const double now = length(view.scene.camera.velocity);
    set_velocity(view, speed > 0.0 ? speed : now > 0.0 ? now : kDefaultSpeed);
}

bool preset_buttons(ViewState& view, const Spacetime& spacetime) {
    const double r = view.scene.camera.r;
    const double fall = free_fall_speed(spacetime, r);
    const auto orbit = circular_orbit_speed(spacetime, r);
    const float width = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    bool changed = true;
    const bool falls = ImGui::Button("Fall in", {width, 0.0f});
    tooltip(fmt::format("Towards the hole, as fast as what fell from rest at infinity: {:.4f} c here.", fall).c_str());
    ImGui::SameLine();
    const bool orbits = ImGui::Button("Orbit", {width, 0.0f});
    tooltip(orbit ? fmt::format("Eastward, at the speed of the circular orbit: {:.4f} c here.", *orbit).c_str()
                  : "Eastward. There is no circular orbit at this radius.");
    ImGui::SameLine();
    const bool rests = ImGui::Button("Rest", {width, 0.0f});
    tooltip("At rest in the static frame.");
    if (falls)
        preset(view, {-1, 0, 0}, fall);
    else if (orbits)
        preset(view, {0, 0, 1}, orbit.value_or(0.0));
    else if (rests)
        view.scene.camera.velocity = {};
    else
        changed = false;
    return changed;
}

bool direction_row(ViewState& view) {
    row("Direction", "Of the motion, in the static frame: outward, south, east. Brought to length 1.");
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
    bool changed = spacetime != nullptr && radius_rows(camera, flight_range(*spacetime));
    bool turned =
        drag_degrees("theta", camera.theta, 0.0, 180.0, "Polar angle: 0 above the north pole, 90 in the disc's plane.");
    turned = drag_degrees("phi", camera.phi, -kTurns, kTurns, "Azimuth.") || turned;
    turned = drag_degrees("Yaw", camera.yaw, -kTurns, kTurns,
                          "Turn to the right, away from the centre, which an unturned camera looks at.") ||
             turned;
    turned = drag_degrees("Pitch", camera.pitch, -kTurns, kTurns, "Turn up, after yaw.") || turned;
    turned = drag_degrees("Roll", camera.roll, -kTurns, kTurns, "Turn about the line of sight, after pitch.") || turned;
    if (turned)
        for (double* angle : {&camera.phi, &camera.yaw, &camera.pitch, &camera.roll}) *angle = wrapped(*angle);
    return changed || turned;
}

bool boost_section(ViewState& view) {
    CameraSpec& camera = view.scene.camera;
    double speed = length(camera.velocity);
    if (speed > 0.0) view.boost_direction = camera.velocity / speed;
    bool changed = false;
    row("Speed", "Of the camera in the static frame, in parts of the speed of light; the slider is even in rapidity.");
    double rapidity = std::atanh(std::min(speed, kFastest));
    const double gamma = 1.0 / std::sqrt((1.0 - speed) * (1.0 + speed));
    if (slide_as("##rapidity", rapidity, 0.0, std::atanh(kFastest), 0, fmt::format("gamma = {:.4g}", gamma))) {
        set_velocity(view, std::tanh(rapidity));
        changed = true;
    }
    row("beta", "v/c, to be typed.");
    speed = length(camera.velocity);
    if (type_number("##beta", speed, 0.0, kFastest, "%.6f c")) {
        set_velocity(view, speed);
        changed = true;
    }
    changed = direction_row(view) || changed;
    const auto spacetime = spacetime_of(view.scene);
    return (spacetime != nullptr && preset_buttons(view, *spacetime)) || changed;
}

bool lens_section(ViewState& view) {
    CameraSpec& camera = view.scene.camera;
    double fov = fov_of(camera) / kDegree;
    bool changed = false;
    if (slide("View", fov, 1.0, 170.0, Scale::kLinear, When::kNow, "%.1f\xc2\xb0",
              "Horizontal field of view. Shift and the wheel change it too.")) {
        set_fov(camera, fov * kDegree);
        changed = true;
    }
    return slide("Exposure", camera.exposure_ev, -10.0, 10.0, Scale::kLinear, When::kNow, "%+.2f EV",
                 "The picture's brightness is multiplied by 2^EV.") ||
           changed;
}

}  // namespace nullscope::viewer
