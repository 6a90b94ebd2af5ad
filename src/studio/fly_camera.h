// The camera in the hand: a place and an orientation in world axes, which know no poles, and what a hand does to them.
// Pure mathematics: no window, no OpenGL. World and camera axes are those of observer/pose.h.
#pragma once
#include <optional>

#include "base/vec.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::viewer {

struct FlyCamera {
    double r = 15.0;
    Vec3 place{1, 0, 0};     // unit vector from the centre to the camera, world axes
    Mat3 world_from_camera;  // columns: right, up, backward
    Vec3 velocity;           // in the static frame, along the world axes
};

FlyCamera fly_camera(const CameraSpec& spec);
// Writes r, theta, phi, yaw, pitch, roll and velocity; angles in (-pi, pi], pitch in [-pi/2, pi/2]. The orientation
// comes back within 1e-15 for every input, also where the angles themselves are not unique.
void write_spec(const FlyCamera& camera, CameraSpec& spec);

// The orientation in which the view direction `grabbed` of this one is seen along `now` (both in camera axes, any
// length, less than a half turn apart): what was grabbed follows the hand.
Mat3 dragged(const Mat3& world_from_camera, Vec3 grabbed, Vec3 now);
// Turned about the line of sight: the camera's top goes to its right.
Mat3 rolled(const Mat3& world_from_camera, double angle);

// Moves the camera about the centre at constant r, so that what is between the two follows a hand that goes by these angles (rad) to the
// right and down in the picture: phi and theta change. Seen from the centre it looks and moves as before: yaw, pitch, roll and velocity
// stay. theta comes no nearer to a pole than 0.01, or than it was.
void orbit(CameraSpec& camera, double right, double down);

// Radii between which one flies, from the metric's own range of cameras. One outside of them (from a scene file) may stay there, or
// come back. throat: of a wormhole, through which one flies to negative radii; 0 elsewhere.
struct FlightRange {
    double horizon, nearest, farthest;  // horizon: the metric's least radius, or 0
    double throat = 0.0;
    double unit(double r) const;  // of flight at r: r - horizon, in a wormhole sqrt(r^2 + throat^2)
    // How fast a hand flies in such units: 1 far away and where there is no horizon, a third near one.
    double pace(double r) const;
};
FlightRange flight_range(const Spacetime& spacetime);

// The radius whose distance to the horizon is exp(change) times that of r, within the range; in a wormhole asinh(r/throat) grows by change.
double scaled_radius(double r, double change, const FlightRange& range);

// A step along camera axes (right, up, backward), length in units of FlightRange::unit: a radial one scales r - horizon by
// its exponential, one across keeps the proper ratio of lengths in the static frame. Orientation stays in world axes;
// the velocity is carried parallel on the sphere, so that its outward part stays outward and nothing jumps at a pole.
void fly(FlyCamera& camera, Vec3 step, const Spacetime& spacetime);

// Speeds in the static frame at r: of a fall from rest at infinity, and of the circular orbit if there is one.
double free_fall_speed(const Spacetime& spacetime, double r);
std::optional<double> circular_orbit_speed(const Spacetime& spacetime, double r);

}  // namespace nullscope::viewer
