#include "observer/pose.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "numeric/one_minus_square.h"
#include "observer/observer.h"
#include "observer/spin_frame.h"

namespace nullscope {
namespace {

// The camera's axes along the frame that it is boosted from. A camera axis c becomes e = (w . c, c + w (w . c)/(1 + gamma)) with
// w = gamma v. Errors of c stay of their own size, those of the boost are multiplied by gamma^2: the boost is computed in long double.
using LongRows = std::array<std::array<long double, 4>, 4>;
LongRows rows_along_frame(const Mat3& axes, Vec3 v) {
    using Long3 = std::array<long double, 3>;
    const long double gamma = 1.0L / std::sqrt(one_minus_square(v.x, v.y, v.z));
    const Long3 w = {gamma * v.x, gamma * v.y, gamma * v.z};
    LongRows rows{};
    rows[0] = {gamma, w[0], w[1], w[2]};
    int i = 1;
    for (const Vec3 axis : {axes.a, axes.b, axes.c}) {
        const Long3 c = {axis.x, axis.y, axis.z};
        const long double along = w[0] * c[0] + w[1] * c[1] + w[2] * c[2];
        const long double push = along / (1.0L + gamma);
        rows[i++] = {along, c[0] + push * w[0], c[1] + push * w[1], c[2] + push * w[2]};
    }
    return rows;
}

TetradPair as_pair(const LongRows& rows) {
    TetradPair tetrad{};
    for (int i = 0; i < 4; ++i) {
        for (int mu = 0; mu < 4; ++mu) {
            tetrad.high[i][mu] = static_cast<double>(rows[i][mu]);
            tetrad.low[i][mu] = static_cast<double>(rows[i][mu] - tetrad.high[i][mu]);
        }
    }
    return tetrad;
}

Result<Done> check_speed(const CameraSpec& camera) {
    if (one_minus_square(camera.velocity.x, camera.velocity.y, camera.velocity.z) > 0.0L) return Done{};
    return bad_input(fmt::format("speed {} is not below that of light", length(camera.velocity)), "|velocity| < 1");
}

Result<Done> check_place(const CameraSpec& camera) {
    if (!(camera.theta >= 0.0 && camera.theta <= std::numbers::pi))
        return bad_input(fmt::format("theta = {} rad is out of range", camera.theta), "[0, pi]");
    if (std::sin(camera.theta) == 0.0) return bad_input("no coordinate tetrad on the axis", "0 < theta < pi");
    return check_speed(camera);
}

// e_0 to e_3 of observer/spin_frame.h, moved along e_3 by the azimuthal_velocity.
TetradPair axial_hat_pair(const AxialMetric& metric, const CameraSpec& camera, const Observer& observer) {
    const SpinPlace p = spin_place(metric, camera.r, camera.theta);
    const long double out = observer.frame.outward, in = p.delta / (p.sigma * out), v = observer.azimuthal_velocity;
    const long double root = std::sqrt(static_cast<long double>(p.sigma)),
                      gamma = 1.0L / std::sqrt((1.0L - v) * (1.0L + v)), drag = static_cast<long double>(p.a) * p.sine;
    LongRows rows = rows_along_frame(observer.turn * static_from_camera(camera), observer.velocity);
    for (auto& row : rows) {
        const long double t = gamma * (row[0] + v * row[3]), r = row[1], theta = row[2],
                          phi = gamma * (row[3] + v * row[0]);
        const long double l = (t + r) / (p.sigma * out);  // of (r^2 + a^2) d_v + a sin d_phi/sin + Delta/2 d_r
        row = {p.across * l + drag * phi / root, 0.5L * (out * (r - t) + in * (r + t)), theta / root,
               drag * l + phi / root};
    }
    return as_pair(rows);
}

}  // namespace

Mat3 world_from_static(double theta, double phi) {
    const double st = std::sin(theta), ct = std::cos(theta), sp = std::sin(phi), cp = std::cos(phi);
    return {{st * cp, st * sp, ct}, {ct * cp, ct * sp, -st}, {-sp, cp, 0.0}};
}

Mat3 static_from_camera(const CameraSpec& camera) {
    const double sy = std::sin(camera.yaw), cy = std::cos(camera.yaw);
    const double sp = std::sin(camera.pitch), cp = std::cos(camera.pitch);
    const double sr = std::sin(camera.roll), cr = std::cos(camera.roll);
    const Mat3 unrotated{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}};
    const Mat3 yaw{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}};    // forward = -z goes to (sin, 0, -cos)
    const Mat3 pitch{{1, 0, 0}, {0, cp, sp}, {0, -sp, cp}};  // forward goes to (0, sin, -cos)
    const Mat3 roll{{cr, -sr, 0}, {sr, cr, 0}, {0, 0, 1}};   // up = y goes to (sin, cos, 0)
    return unrotated * yaw * pitch * roll;
}

Mat3 world_from_camera(const CameraSpec& camera) {
    return world_from_static(camera.theta, camera.phi) * static_from_camera(camera);
}

void set_world_axes(CameraSpec& camera, const Mat3& world_axes) {
    set_axes(camera, transposed(world_from_static(camera.theta, camera.phi)) * world_axes);
}

Result<TetradPair> camera_rows_pair(const CameraSpec& camera) {
    if (Result<Done> ok = check_speed(camera); !ok) return ok.error();
    return as_pair(rows_along_frame(static_from_camera(camera), camera.velocity));
}

Result<TetradPair> ingoing_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera) {
    if (Result<Done> ok = check_place(camera); !ok) return ok.error();
    TRY(pair, ingoing_hat_pair(spacetime, camera));
    const long double sine = std::sin(camera.theta);
    for (std::size_t i = 0; i < 4; ++i) {
        const long double phi = (static_cast<long double>(pair->high[i][3]) + pair->low[i][3]) / sine;
        pair->high[i][3] = static_cast<double>(phi);
        pair->low[i][3] = static_cast<double>(phi - pair->high[i][3]);
    }
    return pair;
}

Result<TetradPair> ingoing_hat_pair(const Spacetime& spacetime, const CameraSpec& camera) {
    if (Result<Done> ok = check_speed(camera); !ok) return ok.error();
    TRY(observer, observer_of(spacetime, camera));
    if (const AxialMetric* metric = spacetime.axial()) return axial_hat_pair(*metric, camera, *observer);
    const long double o = observer->frame.outward, i = static_cast<long double>(spacetime.lapse_squared(camera.r)) / o;
    const long double across = spacetime.areal_radius(camera.r);
    LongRows rows = rows_along_frame(observer->turn * static_from_camera(camera), observer->velocity);
    for (auto& [t, r, theta, phi] : rows) {
        const long double v = (t + r) / o;
        r = 0.5L * (o * (r - t) + i * (r + t));  // -w t + eps r
        t = v;
        theta /= across;
        phi /= across;
    }
    return as_pair(rows);
}

// backward is (cos yaw cos pitch, sin pitch, -sin yaw cos pitch).
void set_direction(CameraSpec& camera, Vec3 backward) {
    camera.yaw = std::atan2(-backward.z, backward.x);
    camera.pitch = std::atan2(backward.y, std::hypot(backward.x, backward.z));
}

// Forward fixes yaw and pitch. Roll is what is left of the turn after both, not an angle of its own: where forward is
// along a pole of yaw, an arbitrary yaw is undone by it.
void set_axes(CameraSpec& camera, const Mat3& axes) {
    set_direction(camera, axes.c);
    camera.roll = 0.0;
    const Mat3 left = transposed(static_from_camera(camera)) * axes;
    camera.roll = std::atan2(left.b.x - left.a.y, left.a.x + left.b.y);
}

}  // namespace nullscope
