#include "studio/fly_camera.h"

#include "spacetime/circular_orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observer/pose.h"

namespace nullscope::viewer {
namespace {

constexpr double kNearest = 5e-4;      // r/horizon - 1: the picture is a small disc of sky, and floats still resolve it
constexpr double kNearestFlat = 0.01;  // where there is no horizon the centre is a point without a radial direction
constexpr double kFarthest = 1e4;      // the shadow is a fifth of a pixel at 1280 px and 60 degrees
constexpr double kNearestPole = 0.01;  // rad, in orbit(): phi has no direction at a pole
constexpr double kLongestStep = 0.01;  // of one Euler step in fly()

// The smallest rotation that takes unit vector a to unit vector b; not for a = -b.
Mat3 rotation_between(Vec3 a, Vec3 b) {
    const Vec3 v = cross(a, b);
    const double c = dot(a, b), k = 1.0 / (1.0 + c);
    return {{c + k * v.x * v.x, k * v.x * v.y + v.z, k * v.x * v.z - v.y},
            {k * v.x * v.y - v.z, c + k * v.y * v.y, k * v.y * v.z + v.x},
            {k * v.x * v.z + v.y, k * v.y * v.z - v.x, c + k * v.z * v.z}};
}

void fly_short(FlyCamera& camera, Vec3 step, const Spacetime& spacetime, const FlightRange& range) {
    const Vec3 along = camera.world_from_camera * step;
    const double outward = dot(along, camera.place);
    const Vec3 across = along - outward * camera.place;
    const double lapse2 = spacetime.lapse_squared(camera.r),
                 lapse = lapse2 > 0.0 ? std::sqrt(lapse2) : 1.0;  // inside a horizon nobody rests
    const double angle = length(across) * range.unit(camera.r) / (lapse * spacetime.areal_radius(camera.r));
    if (angle > 0.0) {
        const Vec3 next = normalized(std::cos(angle) * camera.place + std::sin(angle) * normalized(across));
        camera.velocity = rotation_between(camera.place, next) * camera.velocity;
        camera.place = next;
    }
    camera.r = scaled_radius(camera.r, outward, range);
}

}  // namespace

FlyCamera fly_camera(const CameraSpec& spec) {
    const Mat3 world = world_from_static(spec.theta, spec.phi);
    return {spec.r, world.a, world * static_from_camera(spec), world * spec.velocity};
}

void write_spec(const FlyCamera& camera, CameraSpec& spec) {
    spec.r = camera.r;
    spec.theta = std::atan2(std::hypot(camera.place.x, camera.place.y), camera.place.z);
    spec.phi = std::atan2(camera.place.y, camera.place.x);
    const Mat3 static_from_world = transposed(world_from_static(spec.theta, spec.phi));
    spec.velocity = static_from_world * camera.velocity;
    set_axes(spec, static_from_world * camera.world_from_camera);
}

Mat3 dragged(const Mat3& world_from_camera, Vec3 grabbed, Vec3 now) {
    return world_from_camera * rotation_between(normalized(now), normalized(grabbed));
}

Mat3 rolled(const Mat3& world_from_camera, double angle) {
    const double s = std::sin(angle), c = std::cos(angle);
    return world_from_camera * Mat3{{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

void orbit(CameraSpec& camera, double right, double down) {
    const Mat3 axes = static_from_camera(camera);
    // A camera that looks outward has its right in the west, one upside down its top in the south.
    const double east = axes.a.z < 0.0 ? -1.0 : 1.0, north = axes.b.y > 0.0 ? -1.0 : 1.0;
    const double least = std::min(camera.theta, kNearestPole);
    const double most = std::max(camera.theta, std::numbers::pi - kNearestPole);
    camera.phi = std::remainder(camera.phi - east * right, 2.0 * std::numbers::pi);
    camera.theta = std::clamp(camera.theta - north * down, least, most);
}

FlightRange flight_range(const Spacetime& spacetime) {
    const double low = spacetime.camera_range().low;
    if (low < 0.0) {
        const double throat = spacetime.areal_radius(0.0);
        return {0.0, -kFarthest * throat, kFarthest * throat, throat};
    }
    return {low, low > 0.0 ? low * (1.0 + kNearest) : kNearestFlat, kFarthest};
}

double FlightRange::unit(double r) const { return throat > 0.0 ? std::hypot(r, throat) : r - horizon; }

double FlightRange::pace(double r) const {
    const double away = std::fabs(r - horizon);
    return horizon > 0.0 ? (away + horizon) / (away + 3.0 * horizon) : 1.0;
}

double scaled_radius(double r, double change, const FlightRange& range) {
    const double wanted = range.throat > 0.0 ? range.throat * std::sinh(std::asinh(r / range.throat) + change)
                                             : range.horizon + (r - range.horizon) * std::exp(change);
    // A camera that is outside of the range already is not pulled in.
    return std::clamp(wanted, std::min(range.nearest, r), std::max(range.farthest, r));
}

void fly(FlyCamera& camera, Vec3 step, const Spacetime& spacetime) {
    const FlightRange range = flight_range(spacetime);
    const int parts = std::max(1, static_cast<int>(std::ceil(length(step) / kLongestStep)));
    for (int i = 0; i < parts; ++i) fly_short(camera, step / parts, spacetime, range);
}

double free_fall_speed(const Spacetime& spacetime, double r) {
    return std::sqrt(std::max(0.0, 1.0 - spacetime.lapse_squared(r)));
}

// As a camera without angular momentum sees it: its gamma v is L over the circumference's radius.
std::optional<double> circular_orbit_speed(const Spacetime& spacetime, double r) {
    const auto orbit = circular_orbit(spacetime, r);
    if (!orbit || !(orbit->momentum > 0.0)) return std::nullopt;  // wormholes, flat space: nothing is drawn anywhere
    return orbit->momentum / (orbit->u_t * std::sqrt(spacetime.equator(r)->across2));
}

}  // namespace nullscope::viewer
