// The observer: position, orthonormal tetrad, boost, and the pinhole's rays.
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
// Its inverse: yaw, pitch and roll that give these axes.
void set_axes(CameraSpec& camera, const Mat3& axes);

// The camera's tetrad as vectors of (t, r, theta, phi): rows e_0 (4-velocity), e_1 right, e_2 up, e_3 backward. The
// boost is the pure one from the static frame (no rotation). Orthonormality g(e_i, e_j) = eta_ij: a double holds a
// component of size gamma only to gamma 2^-53, so the products that are summed, of size gamma^2, leave 2^-53 gamma^2
// however the vectors are computed: 6e-11 at 0.999999 c. Hence two precisions:
//   camera_tetrad       rounded to double: within 1e-15 gamma^2 (measured: 5.0e-16 gamma^2);
//   camera_tetrad_pair  each component as an unevaluated sum high + low of two doubles: within 1e-12 absolute for all
//                       speeds to 0.999999 c (measured: 1.7e-13). Needs a long double of 64 bits or more.
// Both against Spacetime::metric as it is rounded to double. Of a static camera (about a rotating hole: without angular momentum); observer is not looked at. Errors: r at or below the horizon,
// |velocity| >= 1, theta outside [0, pi], or on the axis, where the coordinate phi gives no direction
// (world_from_static and static_from_camera have no such exception).
struct TetradPair {
    Matrix4 high, low;
};
// The same rows along the orthonormal tetrad of the camera at rest there, whatever the metric. Errors: |velocity| >= 1.
Result<TetradPair> camera_rows_pair(const CameraSpec& camera);
Result<TetradPair> camera_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera);
Result<Matrix4> camera_tetrad(const Spacetime& spacetime, const CameraSpec& camera);

// The same of any observer (scene/observer.h), also on and inside the horizon, in ingoing coordinates (v, r, theta, phi), v = t + r_*:
//     ds^2 = -A dv^2 + 2 dv dr + R^2 dOmega^2,
// which every metric here has (B = 1/A); about a rotating hole those of spacetime/spin_frame.h. Orthonormal within 1e-12 for velocities to
// 0.999999 c in the observer's frame.
Matrix4 ingoing_metric(const Spacetime& spacetime, double r, double theta);
Result<TetradPair> ingoing_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera);
// The same with components along d_phi/sin(theta): on the axis too.
Result<TetradPair> ingoing_hat_pair(const Spacetime& spacetime, const CameraSpec& camera);
Matrix4 ingoing_hat_metric(const Spacetime& spacetime, double r, double theta);

// Pixel position on the projection plane: column x, row y from the top, pixel centres at +0.5. View direction in camera
// axes (right, up, backward), not normalised: (X, Y, -1).
Vec3 pixel_direction(const CameraSpec& camera, double x, double y);

// A unit view direction seen in the camera's rest frame, as the static observer at the same place sees it, and the
// ratio D = (frequency in the camera) / (frequency in the static frame) = gamma (1 + v . n_static). n_camera along the
// static axes (already rotated by static_from_camera). The motion bunches the sky forward: the static angle from the
// motion is larger, tan(theta_static / 2) = sqrt((1 + v)/(1 - v)) tan(theta_camera / 2). Product form: exact to
// rounding for rays along and against the motion. velocity: |v| < 1.
struct Aberrated {
    Vec3 n;
    double doppler;
};
Aberrated aberrate_to_static(Vec3 n_camera, Vec3 velocity);

}  // namespace nullscope
