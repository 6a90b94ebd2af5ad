#include "camera/pose.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/observer.h"
#include "spacetime/spin_frame.h"

namespace nullscope {
namespace {

// 1 - |v|^2 to rounding of the result: the squares are exact sums of two doubles (fma), and so are the differences
// (Knuth).
long double one_minus_square(Vec3 v) {
    double sum = 1.0, tail = 0.0;
    for (const double x : {v.x, v.y, v.z}) {
        const double square = x * x;
        const double next = sum - square;
        const double taken = sum - next;
        tail += (sum - (next + taken)) + (taken - square) - std::fma(x, x, -square);
        sum = next;
    }
    return static_cast<long double>(sum) + tail;
}

// a b - c d within 1.5 units in the last place (Kahan).
double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

Vec3 exact_cross(Vec3 a, Vec3 b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

// The camera's axes along the frame that it is boosted from. A camera axis c becomes e = (w . c, c + w (w . c)/(1 + gamma)) with
// w = gamma v. Errors of c stay of their own size, those of the boost are multiplied by gamma^2: the boost is computed in long double.
using LongRows = std::array<std::array<long double, 4>, 4>;
LongRows rows_along_frame(const Mat3& axes, Vec3 v) {
    using Long3 = std::array<long double, 3>;
    const long double gamma = 1.0L / std::sqrt(one_minus_square(v));
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
    if (one_minus_square(camera.velocity) > 0.0L) return Done{};
    return bad_input(
        fmt::format("speed {} is not below that of light; allowed: |velocity| < 1", length(camera.velocity)));
}

Result<Done> check_place(const CameraSpec& camera) {
    if (!(camera.theta >= 0.0 && camera.theta <= std::numbers::pi))
        return bad_input(fmt::format("theta = {} rad is out of range; allowed: [0, pi]", camera.theta));
    if (std::sin(camera.theta) == 0.0) return bad_input("no coordinate tetrad on the axis; allowed: 0 < theta < pi");
    return check_speed(camera);
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

Result<TetradPair> camera_rows_pair(const CameraSpec& camera) {
    if (Result<Done> ok = check_speed(camera); !ok) return ok.error();
    return as_pair(rows_along_frame(static_from_camera(camera), camera.velocity));
}

Result<TetradPair> camera_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera) {
    if (!camera_can_rest(spacetime, camera.r))
        return bad_input(fmt::format("no static frame at r = {}; allowed: {}", camera.r, allowed_radii(spacetime)));
    if (Result<Done> ok = check_place(camera); !ok) return ok.error();
    const Matrix4 g = spacetime.metric(camera.r, camera.theta),
                  inverse = spacetime.inverse_metric(camera.r, camera.theta);
    const long double drag =
        static_cast<long double>(inverse[0][3]) / inverse[0][0];  // of a camera without angular momentum
    LongRows rows = rows_along_frame(static_from_camera(camera), camera.velocity);
    for (auto& row : rows) {
        const long double t = row[0];
        for (int mu = 0; mu < 4; ++mu)
            row[mu] /= std::sqrt(mu == 0 && drag != 0 ? -1.0L / inverse[0][0]
                                                      : std::fabs(static_cast<long double>(g[mu][mu])));
        if (drag != 0) row[3] += drag * t * std::sqrt(-static_cast<long double>(inverse[0][0]));
    }
    return as_pair(rows);
}

Matrix4 ingoing_hat_metric(const Spacetime& spacetime, double r, double theta) {
    Matrix4 g{};
    g[0][1] = g[1][0] = 1.0;
    if (const AxialMetric* metric = spacetime.axial()) {
        const SpinPlace p = spin_place(*metric, r, theta);
        const double drag = p.a * p.sine, pull = p.two_mass * r / p.sigma;
        g[0][0] = pull - 1.0;
        g[0][3] = g[3][0] = -drag * pull;
        g[1][3] = g[3][1] = -drag;
        g[2][2] = p.sigma;
        g[3][3] = p.across + drag * drag * pull;
        return g;
    }
    const double across = spacetime.areal_radius(r);
    g[0][0] = -spacetime.lapse_squared(r);
    g[2][2] = g[3][3] = across * across;
    return g;
}

Matrix4 ingoing_metric(const Spacetime& spacetime, double r, double theta) {
    Matrix4 g = ingoing_hat_metric(spacetime, r, theta);
    for (std::size_t i = 0; i < 4; ++i) g[i][3] *= std::sin(theta), g[3][i] *= std::sin(theta);
    return g;
}

Result<TetradPair> ingoing_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera) {
    if (Result<Done> ok = check_place(camera); !ok) return ok.error();
    Result<TetradPair> pair = ingoing_hat_pair(spacetime, camera);
    if (!pair) return pair;
    const long double sine = std::sin(camera.theta);
    for (std::size_t i = 0; i < 4; ++i) {
        const long double phi = (static_cast<long double>(pair->high[i][3]) + pair->low[i][3]) / sine;
        pair->high[i][3] = static_cast<double>(phi);
        pair->low[i][3] = static_cast<double>(phi - pair->high[i][3]);
    }
    return pair;
}

namespace {

// e_0 to e_3 of spacetime/spin_frame.h, moved along e_3 by the swirl.
TetradPair axial_hat_pair(const AxialMetric& metric, const CameraSpec& camera, const Observer& observer) {
    const SpinPlace p = spin_place(metric, camera.r, camera.theta);
    const long double out = observer.frame.outward, in = p.delta / (p.sigma * out), v = observer.swirl;
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

Result<TetradPair> ingoing_hat_pair(const Spacetime& spacetime, const CameraSpec& camera) {
    if (Result<Done> ok = check_speed(camera); !ok) return ok.error();
    const auto observer = observer_of(spacetime, camera);
    if (!observer) return observer.error();
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

Result<Matrix4> camera_tetrad(const Spacetime& spacetime, const CameraSpec& camera) {
    const Result<TetradPair> pair = camera_tetrad_pair(spacetime, camera);
    if (!pair) return pair.error();
    return pair->high;
}

// Forward fixes yaw and pitch. Roll is what is left of the turn after both, not an angle of its own: where forward is
// along a pole of yaw, an arbitrary yaw is undone by it.
void set_axes(CameraSpec& camera, const Mat3& axes) {
    const Vec3 back = axes.c;  // (cos yaw cos pitch, sin pitch, -sin yaw cos pitch) along (e_r, e_theta, e_phi)
    camera.yaw = std::atan2(-back.z, back.x);
    camera.pitch = std::atan2(back.y, std::hypot(back.x, back.z));
    camera.roll = 0.0;
    const Mat3 left = transposed(static_from_camera(camera)) * axes;
    camera.roll = std::atan2(left.b.x - left.a.y, left.a.x + left.b.y);
}

Vec3 pixel_direction(const CameraSpec& camera, double x, double y) {
    const double pixel = camera.plane_width / camera.width / camera.focal_distance;  // square pixels
    return {(x - 0.5 * camera.width) * pixel, (0.5 * camera.height - y) * pixel, -1.0};
}

// With c = cos(theta_camera): D = sqrt(1 - b^2) / ((1 - c)(1 + b)/2 + (1 + c)(1 - b)/2), the part of n across the
// motion is multiplied by D, the part along it becomes the difference over the sum of the two terms. 1 - c and 1 + c
// follow from the sine |n x v| / b, and 1 - b from 1 - b^2, so that neither small number is a difference.
Aberrated aberrate_to_static(Vec3 n, Vec3 velocity) {
    const double speed = length(velocity);
    if (speed == 0.0) return {n, 1.0};
    const double one_minus_b2 = static_cast<double>(one_minus_square(velocity));
    const Vec3 axis = velocity / speed;
    const Vec3 normal = exact_cross(n, velocity) / speed;
    const double c = dot(n, axis);
    const double sine2 = dot(normal, normal);
    const double one_minus_c = c > 0.0 ? sine2 / (1.0 + c) : 1.0 - c;
    const double one_plus_c = c > 0.0 ? 1.0 + c : sine2 / (1.0 - c);
    const double ahead = 0.5 * one_plus_c * one_minus_b2 / (1.0 + speed);  // (1 + c)(1 - b)/2
    const double astern = 0.5 * one_minus_c * (1.0 + speed);
    const double doppler = std::sqrt(one_minus_b2) / (ahead + astern);
    const Vec3 across = cross(axis, normal);
    return {doppler * across + ((ahead - astern) / (ahead + astern)) * axis, doppler};
}

}  // namespace nullscope
