// What tests alone ask of an observer: the tetrad of a static camera in coordinates, and aberration in closed form.
#pragma once
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/result.h"
#include "numeric/one_minus_square.h"
#include "observer/observer.h"
#include "observer/pose.h"
#include "observer/spin_frame.h"
#include "spacetime/spacetime.h"

namespace nullscope {

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
inline Result<TetradPair> camera_tetrad_pair(const Spacetime& spacetime, const CameraSpec& camera) {
    if (!camera_can_rest(spacetime, camera.r))
        return bad_input(fmt::format("no static frame at r = {}; allowed: {}", camera.r, allowed_radii(spacetime)));
    if (!(camera.theta >= 0 && camera.theta <= M_PI) || std::sin(camera.theta) == 0)
        return bad_input("no coordinate tetrad on the axis; allowed: 0 < theta < pi");
    TRY(pair, camera_rows_pair(camera));
    const Matrix4 g = spacetime.metric(camera.r, camera.theta),
                  inverse = spacetime.inverse_metric(camera.r, camera.theta);
    // Of a camera without angular momentum.
    const long double drag = static_cast<long double>(inverse[0][3]) / inverse[0][0];
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<long double, 4> row{};
        for (std::size_t mu = 0; mu < 4; ++mu) row[mu] = static_cast<long double>(pair->high[i][mu]) + pair->low[i][mu];
        const long double t = row[0];
        for (std::size_t mu = 0; mu < 4; ++mu)
            row[mu] /= std::sqrt(mu == 0 && drag != 0 ? -1.0L / inverse[0][0]
                                                      : std::fabs(static_cast<long double>(g[mu][mu])));
        if (drag != 0) row[3] += drag * t * std::sqrt(-static_cast<long double>(inverse[0][0]));
        for (std::size_t mu = 0; mu < 4; ++mu) {
            pair->high[i][mu] = static_cast<double>(row[mu]);
            pair->low[i][mu] = static_cast<double>(row[mu] - pair->high[i][mu]);
        }
    }
    return pair;
}

inline Result<Matrix4> camera_tetrad(const Spacetime& spacetime, const CameraSpec& camera) {
    const Result<TetradPair> pair = camera_tetrad_pair(spacetime, camera);
    if (!pair) return pair.error();
    return pair->high;
}

// The metric in the coordinates of ingoing_hat_pair, with components along d_phi/sin(theta).
inline Matrix4 ingoing_hat_metric(const Spacetime& spacetime, double r, double theta) {
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

// In those of ingoing_tetrad_pair (observer/pose.h).
inline Matrix4 ingoing_metric(const Spacetime& spacetime, double r, double theta) {
    Matrix4 g = ingoing_hat_metric(spacetime, r, theta);
    for (std::size_t i = 0; i < 4; ++i) g[i][3] *= std::sin(theta), g[3][i] *= std::sin(theta);
    return g;
}

// a b - c d within 1.5 units in the last place (Kahan).
inline double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

inline Vec3 exact_cross(Vec3 a, Vec3 b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

// A unit view direction seen in the camera's rest frame, as the static observer at the same place sees it, and the
// ratio D = (frequency in the camera) / (frequency in the static frame) = gamma (1 + v . n_static). n_camera along the
// static axes (already rotated by static_from_camera). The motion bunches the sky forward: the static angle from the
// motion is larger, tan(theta_static / 2) = sqrt((1 + v)/(1 - v)) tan(theta_camera / 2). Product form: exact to
// rounding for rays along and against the motion. velocity: |v| < 1.
struct Aberrated {
    Vec3 n;
    double doppler;
};
inline Aberrated aberrate_to_static(Vec3 n, Vec3 velocity) {
    const double speed = length(velocity);
    if (speed == 0.0) return {n, 1.0};
    const double one_minus_b2 = static_cast<double>(one_minus_square(velocity.x, velocity.y, velocity.z));
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
