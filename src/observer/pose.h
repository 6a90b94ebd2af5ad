// The observer: position, orthonormal tetrad, boost.
//
// Local static frame at (r, theta, phi): e_r, e_theta, e_phi. World axes: the flat Cartesian directions that these have
// at that (theta, phi): by spherical symmetry a ray's plane and its sky direction are vectors in world axes.
#pragma once
#include "base/result.h"
#include "base/vec.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// Columns are e_r, e_theta, e_phi in world axes.
Mat3 world_from_static(double theta, double phi);

// Columns are the camera's right, up and backward (= -forward) axes in (e_r, e_theta, e_phi) for the given yaw, pitch,
// roll. Unrotated: right = e_phi, up = -e_theta, backward = e_r. Intrinsic turns in the order yaw, pitch, roll, about
// the axes as they then are: yaw takes forward towards right, pitch takes forward towards up, roll takes up towards
// right.
Mat3 static_from_camera(const CameraSpec& camera);
// The same in world axes.
Mat3 world_from_camera(const CameraSpec& camera);
// Yaw, pitch and roll that give these axes, by theta and phi of the camera.
void set_world_axes(CameraSpec& camera, const Mat3& world_axes);
// The inverse of static_from_camera: yaw, pitch and roll that give these axes.
void set_axes(CameraSpec& camera, const Mat3& axes);
// Yaw and pitch that give this backward axis; roll stays.
void set_direction(CameraSpec& camera, Vec3 backward);

// The camera's tetrad: rows e_0 (4-velocity), e_1 right, e_2 up, e_3 backward, each component as an unevaluated sum high + low of two
// doubles. A double holds a component of size gamma only to gamma 2^-53, so the products that are summed for g(e_i, e_j) = eta_ij leave
// 2^-53 gamma^2 however it is computed: 6e-11 at 0.999999 c. Pairs leave 1e-12 absolute for all speeds to 0.999999 c (measured:
// 1.7e-13). Needs a long double of 64 bits or more.
struct TetradPair {
    Matrix4 high, low;
};
// Along the orthonormal tetrad of the camera at rest there, whatever the metric: the boost is the pure one (no rotation). Errors:
// |velocity| >= 1.
Result<TetradPair> camera_rows_pair(const CameraSpec& camera);

// The same of any observer (observer/observer.h), also on and inside the horizon, in ingoing coordinates (v, r, theta, phi), v = t + r_*:
//     ds^2 = -A dv^2 + 2 dv dr + R^2 dOmega^2,
// which every metric here has (B = 1/A); about a rotating hole those of observer/spin_frame.h. Orthonormal within 1e-12 for velocities to
// 0.999999 c in the observer's frame. Errors: theta outside [0, pi], or on the axis, where the coordinate phi gives no direction.
Result<TetradPair> ingoing_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera);
// The same with components along d_phi/sin(theta): on the axis too.
Result<TetradPair> ingoing_hat_pair(const Spacetime& spacetime, const CameraSpec& camera);

}  // namespace nullscope
