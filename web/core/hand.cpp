// What input does to the camera, and the fall after it was let go. Places are pixels of the picture, from its top left corner.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/exports.h"
#include "core/session.h"
#include "observer/pose.h"
#include "scene/projection.h"
#include "spacetime/registry.h"
#include "studio/fly_camera.h"

namespace nullscope::web {
namespace {

using viewer::FlyCamera;

constexpr double kFlight = 0.7;  // 1/s: a second of flight leaves exp(-0.7), a half, of the distance to the horizon
constexpr double kNarrowest = 1.0 * std::numbers::pi / 180.0, kWidest = 170.0 * std::numbers::pi / 180.0;

struct Grabbed {
    Vec3 direction;
    Mat3 axes;
} grabbed;

CameraSpec& camera() { return session().scene.camera; }

std::shared_ptr<const Spacetime> spacetime() {
    auto made = make_spacetime(session().scene.spacetime.metric, session().scene.spacetime.parameters);
    return made ? *made : nullptr;
}

void turn(const Mat3& world_from_camera) {
    set_axes(camera(), transposed(world_from_static(camera().theta, camera().phi)) * world_from_camera);
}

}  // namespace

NULLSCOPE_EXPORT(grab) void grab(double x, double y) {
    grabbed = {pixel_direction(camera(), x, y), viewer::fly_camera(camera()).world_from_camera};
}
// What was grabbed is seen there now.
NULLSCOPE_EXPORT(look) void look(double x, double y) {
    turn(viewer::dragged(grabbed.axes, grabbed.direction, pixel_direction(camera(), x, y)));
}
NULLSCOPE_EXPORT(roll) void roll(double angle) {
    turn(viewer::rolled(viewer::fly_camera(camera()).world_from_camera, angle));
}

NULLSCOPE_EXPORT(orbit) void orbit(double right_px, double down_px) {
    const double angle = std::numbers::pi / camera().height;  // of a pixel: half a turn for the picture's height
    viewer::orbit(camera(), angle * right_px, angle * down_px);
}
// Along the camera's axes, each -1 to 1, for so many seconds.
NULLSCOPE_EXPORT(fly) void fly(double right, double up, double backward, double seconds) {
    const auto about = spacetime();
    if (about == nullptr) return;
    FlyCamera flying = viewer::fly_camera(camera());
    const double pace = kFlight * viewer::flight_range(*about).pace(camera().r) * seconds;
    viewer::fly(flying, pace * Vec3{right, up, backward}, *about);
    viewer::write_spec(flying, camera());
}
// The distance to the horizon becomes exp(change) times as large.
NULLSCOPE_EXPORT(approach) void approach(double change) {
    if (const auto about = spacetime())
        camera().r = viewer::scaled_radius(camera().r, change, viewer::flight_range(*about));
}
// The picture's half width becomes so many times as wide.
NULLSCOPE_EXPORT(zoom) void zoom(double factor) {
    CameraSpec& lens = camera();
    if (lens.projection != Projection::kPinhole) return;
    const double half = std::atan(std::tan(0.5 * field_of_view(lens)) * factor);
    lens.plane_width = 2.0 * lens.focal_distance * std::tan(std::clamp(half, 0.5 * kNarrowest, 0.5 * kWidest));
}

// Lets the camera go, or stops its fall. false: the answer says why not.
NULLSCOPE_EXPORT(let_go) bool let_go() {
    if (session().fall.active()) return session().fall.stop(), answer(std::string());
    return answer(session().fall.let_go(session().scene));
}
NULLSCOPE_EXPORT(falls) bool falls() { return session().fall.active() && session().fall.runs(); }
// Whether something moved. clock: r_s/c a second of the scene's own clock while nobody falls.
NULLSCOPE_EXPORT(step) bool step(double seconds, double clock) {
    if (falls()) return session().fall.step(session().scene, seconds);
    session().scene.time += clock * seconds;
    return clock != 0.0;
}
// r, theta, phi (rad), time (r_s/c), proper time of a fall (r_s/c)
NULLSCOPE_EXPORT(place) double place(int which) {
    const double all[] = {camera().r, camera().theta, camera().phi, session().scene.time, session().fall.tau()};
    return which >= 0 && which < 5 ? all[which] : 0.0;
}

}  // namespace nullscope::web
