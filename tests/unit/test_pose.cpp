// Camera conventions, tetrad, boosts and aberration.
#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "observer/pose.h"
#include "scene/projection.h"
#include "scene/ray.h"
#include "spacetime/registry.h"
#include "support/observer.h"

using namespace nullscope;

namespace {

constexpr double kPosePi = std::numbers::pi;
constexpr int kPoses = 10'000;
constexpr double kFastest = 0.999999;           // gamma = 707
constexpr double kRotationTolerance = 1e-15;    // products of three rotations: a few units in the last place
constexpr double kOrthonormalPair = 1e-12;      // as asked for; measured 1.7e-13, a few times gamma^2 2^-64
constexpr double kOrthonormalRounded = 1e-15;   // of gamma^2: components rounded to 2^-53; measured 5.0e-16
constexpr double kAberrationTolerance = 4e-15;  // direction and relative frequency at any speed; measured 9e-16
constexpr double kTetradRay = 2e-15;            // of gamma^2: the rounded tetrad's own error

using Quad = boost::multiprecision::cpp_bin_float_quad;

struct Sampler {
    std::mt19937_64 engine{20151127};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    Vec3 direction() {
        std::normal_distribution<double> normal;
        return normalized({normal(engine), normal(engine), normal(engine)});
    }
    // Uniform in rapidity, so that all gammas occur; every fourth along one axis.
    Vec3 velocity(int i) {
        const double speed = i == 0 ? 0.0 : i % 10 == 0 ? kFastest : std::tanh(uniform(0.0, std::atanh(kFastest)));
        const Vec3 along = i % 4 == 0 ? Vec3{i % 8 == 0 ? 1.0 : 0.0, i % 8 == 0 ? 0.0 : 1.0, 0.0} : direction();
        const Vec3 v = speed * along;
        return length(v) > kFastest ? v * (1.0 - 1e-15) : v;
    }
    CameraSpec pose(int i) {
        CameraSpec camera;
        camera.r = 1.0 + std::pow(10.0, uniform(-4.0, 3.0));
        camera.theta = std::acos(uniform(-0.9999, 0.9999));
        camera.phi = uniform(-4.0, 4.0);
        camera.yaw = uniform(-kPosePi, kPosePi);
        camera.pitch = uniform(-kPosePi, kPosePi);
        camera.roll = uniform(-kPosePi, kPosePi);
        camera.velocity = velocity(i);
        return camera;
    }
};

long double gamma_of(Vec3 v) {
    const long double v2 =
        static_cast<long double>(v.x) * v.x + static_cast<long double>(v.y) * v.y + static_cast<long double>(v.z) * v.z;
    return 1.0L / std::sqrt(1.0L - v2);
}

std::shared_ptr<const Spacetime> spacetime(const char* metric) { return *make_spacetime(metric, {}); }

// The largest |g(e_i, e_j) - eta_ij| of the vectors high + low, summed in 113 bits.
double orthonormality_error(const Matrix4& g, const Matrix4& high, const Matrix4& low) {
    double worst = 0.0;
    for (int i = 0; i < 4; ++i) {
        for (int j = i; j < 4; ++j) {
            Quad sum = i != j ? 0 : i == 0 ? 1 : -1;  // - eta
            for (int mu = 0; mu < 4; ++mu) {
                sum += g[mu][mu] * (Quad(high[i][mu]) + low[i][mu]) * (Quad(high[j][mu]) + low[j][mu]);
            }
            worst = std::max(worst, std::fabs(static_cast<double>(sum)));
        }
    }
    return worst;
}

double distance(Vec3 a, Vec3 b) { return length(a - b); }

double rotation_error(const Mat3& m) {
    const Mat3 unit = transposed(m) * m;
    return std::max({distance(unit.a, {1, 0, 0}), distance(unit.b, {0, 1, 0}), distance(unit.c, {0, 0, 1}),
                     distance(cross(m.a, m.b), m.c)});
}

// The Lorentz transformation of the photon's momentum (1, -n), written out: static energy and static view direction. In
// 113 bits: the differences lose gamma^2 = 5e5 twice, which leaves 1e-13 of a long double (measured: 2.3e-13).
using Quad3 = std::array<Quad, 3>;
struct Direct {
    Quad3 n;
    Quad doppler;
};
Direct aberrate_directly(Vec3 n_camera, Vec3 velocity) {
    const auto product = [](const Quad3& a, const Quad3& b) -> Quad { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const Quad3 v = {velocity.x, velocity.y, velocity.z};
    const Quad gamma = 1 / sqrt(Quad(1 - product(v, v)));
    Quad3 n = {n_camera.x, n_camera.y, n_camera.z};
    const Quad norm = sqrt(product(n, n));
    for (Quad& x : n) x /= norm;
    const Quad wn = gamma * product(v, n);
    const Quad energy = gamma - wn;
    Direct result{{}, 1 / energy};
    for (int k = 0; k < 3; ++k) result.n[k] = (n[k] + gamma * v[k] * (wn / (1 + gamma) - 1)) / energy;
    return result;
}

}  // namespace

TEST_CASE("the static axes are where spherical coordinates say") {
    const Mat3 m = world_from_static(kPosePi / 2, 0.0);
    CHECK(distance(m.a, {1, 0, 0}) < kRotationTolerance);   // e_r
    CHECK(distance(m.b, {0, 0, -1}) < kRotationTolerance);  // e_theta: south
    CHECK(distance(m.c, {0, 1, 0}) < kRotationTolerance);   // e_phi: east
    CHECK(distance(world_from_static(0.3, 1.0).a,
                   {std::sin(0.3) * std::cos(1.0), std::sin(0.3) * std::sin(1.0), std::cos(0.3)}) < kRotationTolerance);
    Sampler sampler;
    for (int i = 0; i < kPoses; ++i) {
        CHECK(rotation_error(world_from_static(sampler.uniform(0, kPosePi), sampler.uniform(-9, 9))) <
              kRotationTolerance);
    }
    CHECK(rotation_error(world_from_static(0.0, 0.7)) < kRotationTolerance);  // on the axis too
}

TEST_CASE("the unrotated camera looks at the centre, east to the right and north up") {
    CameraSpec camera;
    const Mat3 axes = static_from_camera(camera);
    const auto look = [&](double x, double y) { return normalized(axes * pixel_direction(camera, x, y)); };
    const double cx = 0.5 * camera.width, cy = 0.5 * camera.height;
    CHECK(distance(look(cx, cy), {-1, 0, 0}) == 0.0);
    CHECK(look(cx + 10, cy).z > 0.0);
    CHECK(look(cx + 10, cy).y == 0.0);
    CHECK(look(cx, cy - 10).y < 0.0);  // a higher row of the picture: towards -e_theta
    CHECK(look(cx, cy - 10).z == 0.0);
}

TEST_CASE("the field of view spans the width and pixels are square") {
    CameraSpec camera;
    camera.plane_width = 3.0;
    camera.focal_distance = 2.0;
    camera.width = 300;
    camera.height = 100;
    const double half_fov = std::atan2(camera.plane_width, 2.0 * camera.focal_distance);
    const Vec3 left = pixel_direction(camera, 0, 50), right = pixel_direction(camera, 300, 50);
    CHECK(angle_between(left, right) == doctest::Approx(2 * half_fov).epsilon(1e-15));
    CHECK(left.x == -0.75);
    CHECK(right.x == 0.75);
    CHECK(pixel_direction(camera, 150, 0).y == 0.25);
    CHECK(pixel_direction(camera, 150, 100).y == -0.25);
    CHECK(left.z == -1.0);
}

TEST_CASE("yaw turns right, then pitch up, then roll takes the top to the right") {
    const double angle = 0.3;
    const auto axes = [](double yaw, double pitch, double roll) {
        CameraSpec camera;
        camera.yaw = yaw, camera.pitch = pitch, camera.roll = roll;
        return static_from_camera(camera);
    };
    const Vec3 right{0, 0, 1}, up{0, -1, 0}, forward{-1, 0, 0};
    const double c = std::cos(angle), s = std::sin(angle);
    CHECK(distance(-axes(angle, 0, 0).c, c * forward + s * right) < kRotationTolerance);
    CHECK(distance(axes(angle, 0, 0).b, up) < kRotationTolerance);
    CHECK(distance(-axes(0, angle, 0).c, c * forward + s * up) < kRotationTolerance);
    CHECK(distance(axes(0, angle, 0).a, right) < kRotationTolerance);
    CHECK(distance(axes(0, 0, angle).b, c * up + s * right) < kRotationTolerance);
    CHECK(distance(axes(0, 0, angle).c, -forward) < kRotationTolerance);
    // After a quarter turn to the right, pitch lifts the new line of sight (formerly right) and roll turns about it.
    CHECK(distance(-axes(kPosePi / 2, angle, 0).c, c * right + s * up) < kRotationTolerance);
    CHECK(distance(axes(kPosePi / 2, 0, angle).b, c * up - s * forward) < kRotationTolerance);
    CHECK(distance(axes(0, kPosePi / 2, angle).b, c * -forward + s * right) < kRotationTolerance);
    Sampler sampler;
    for (int i = 0; i < kPoses; ++i) CHECK(rotation_error(static_from_camera(sampler.pose(i))) < kRotationTolerance);
}

TEST_CASE("the tetrad is orthonormal over random poses, rotations and boosts") {
    Sampler sampler;
    double worst_pair = 0.0, worst_rounded = 0.0;
    for (int i = 0; i < kPoses; ++i) {
        const CameraSpec camera = sampler.pose(i);
        const auto metric = spacetime(i % 3 == 0 ? "minkowski" : "schwarzschild");
        const Result<TetradPair> pair = camera_tetrad_pair(*metric, camera);
        REQUIRE(pair);
        const Matrix4 g = metric->metric(camera.r, camera.theta);
        const double gamma2 = static_cast<double>(gamma_of(camera.velocity) * gamma_of(camera.velocity));
        worst_pair = std::max(worst_pair, orthonormality_error(g, pair->high, pair->low));
        worst_rounded = std::max(worst_rounded, orthonormality_error(g, pair->high, {}) / gamma2);
        CHECK(pair->high[0][0] > 0.0);  // towards the future
        CHECK((*camera_tetrad(*metric, camera)) == pair->high);
    }
    MESSAGE("worst |g(e_i, e_j) - eta_ij|: pair " << worst_pair << ", rounded " << worst_rounded << " gamma^2");
    CHECK(worst_pair < kOrthonormalPair);
    CHECK(worst_rounded < kOrthonormalRounded);
}

TEST_CASE("the tetrad of a camera at rest and of one that moves outward") {
    CameraSpec camera;
    camera.r = 2.0;  // A = 1/2
    camera.theta = kPosePi / 6;
    const auto metric = spacetime("schwarzschild");
    Matrix4 e = *camera_tetrad(*metric, camera);
    CHECK(e[0][0] == doctest::Approx(std::sqrt(2.0)).epsilon(1e-15));
    CHECK(e[1][3] == doctest::Approx(1.0).epsilon(1e-15));             // right = e_phi = 1/(r sin theta)
    CHECK(e[2][2] == doctest::Approx(-0.5).epsilon(1e-15));            // up = -e_theta = -1/r
    CHECK(e[3][1] == doctest::Approx(std::sqrt(0.5)).epsilon(1e-15));  // backward = e_r = sqrt(A)
    camera.velocity = {0.6, 0, 0};                                     // gamma = 5/4
    e = *camera_tetrad(*metric, camera);
    CHECK(e[0][0] == doctest::Approx(1.25 * std::sqrt(2.0)).epsilon(1e-15));
    CHECK(e[0][1] == doctest::Approx(0.75 * std::sqrt(0.5)).epsilon(1e-15));
    CHECK(e[3][0] == doctest::Approx(0.75 * std::sqrt(2.0)).epsilon(1e-15));
    CHECK(e[3][1] == doctest::Approx(1.25 * std::sqrt(0.5)).epsilon(1e-15));
}

TEST_CASE("there is no tetrad on or inside the horizon, on the axis, or at the speed of light") {
    const auto metric = spacetime("schwarzschild");
    const auto refused = [&](auto change) {
        CameraSpec camera;
        change(camera);
        return !camera_tetrad(*metric, camera) && !camera_tetrad_pair(*metric, camera);
    };
    CHECK_FALSE(refused([](CameraSpec&) {}));
    CHECK_FALSE(refused([](CameraSpec& c) { c.r = 1.0 + 1e-9; }));
    CHECK(refused([](CameraSpec& c) { c.r = 1.0; }));
    CHECK(refused([](CameraSpec& c) { c.r = 0.5; }));
    CHECK(refused([](CameraSpec& c) { c.r = kNotANumber; }));
    CHECK(refused([](CameraSpec& c) { c.theta = -0.1; }));
    CHECK(refused([](CameraSpec& c) { c.theta = 3.2; }));
    CHECK(refused([](CameraSpec& c) { c.theta = 0.0; }));
    CHECK(refused([](CameraSpec& c) { c.velocity = {1.0, 0, 0}; }));
    CHECK(refused([](CameraSpec& c) { c.velocity = {0.6, 0.8, 1e-5}; }));
    CHECK(refused([](CameraSpec& c) { c.velocity.y = kNotANumber; }));
}

TEST_CASE("aberration agrees with the Lorentz transformation in 113 bits, also along and against the motion") {
    Sampler sampler;
    double worst_n = 0.0, worst_doppler = 0.0;
    for (int i = 0; i < kPoses; ++i) {
        const Vec3 v = sampler.velocity(i);
        Vec3 n = sampler.direction();
        if (i % 3 == 1 && length(v) > 0) {  // within 10^-8 ... 1 rad of the motion, or of its opposite
            const double offset = std::pow(10.0, sampler.uniform(-8.0, 0.0));
            n = normalized((i % 2 == 0 ? 1.0 : -1.0) * normalized(v) + offset * n);
        }
        const Aberrated got = aberrate_to_static(n, v);
        const Direct want = aberrate_directly(n, v);
        worst_n = std::max({worst_n, std::fabs(static_cast<double>(got.n.x - want.n[0])),
                            std::fabs(static_cast<double>(got.n.y - want.n[1])),
                            std::fabs(static_cast<double>(got.n.z - want.n[2]))});
        worst_doppler = std::max(worst_doppler, std::fabs(static_cast<double>(got.doppler / want.doppler - 1)));
    }
    MESSAGE("worst direction " << worst_n << ", frequency " << worst_doppler);
    CHECK(worst_n < kAberrationTolerance);
    CHECK(worst_doppler < kAberrationTolerance);
}

TEST_CASE("aberration: simple cases") {
    const Aberrated rest = aberrate_to_static({0.6, 0, 0.8}, {0, 0, 0});
    CHECK(distance(rest.n, {0.6, 0, 0.8}) == 0.0);
    CHECK(rest.doppler == 1.0);
    const Aberrated ahead = aberrate_to_static({1, 0, 0}, {0.6, 0, 0});
    CHECK(distance(ahead.n, {1, 0, 0}) == 0.0);
    CHECK(ahead.doppler == doctest::Approx(2.0).epsilon(1e-15));  // blue: sqrt(1.6/0.4)
    const Aberrated astern = aberrate_to_static({-1, 0, 0}, {0.6, 0, 0});
    CHECK(distance(astern.n, {-1, 0, 0}) == 0.0);
    CHECK(astern.doppler == doctest::Approx(0.5).epsilon(1e-15));
    // The sky is bunched forward: a star abeam in the static frame is seen at cos = v, so a ray seen at 90 degrees
    // comes from cos = -v.
    const Aberrated abeam = aberrate_to_static({0, 1, 0}, {0.6, 0, 0});
    CHECK(distance(abeam.n, {-0.6, 0.8, 0}) < kAberrationTolerance);
    CHECK(abeam.doppler == doctest::Approx(0.8).epsilon(1e-15));
}

TEST_CASE("aberration: half-angle formula, frequency formula and the way back") {
    constexpr double kRoundTrip = 1e-12;  // rounding of n_static is stretched by up to 1414 on the way back
    Sampler sampler;
    for (int i = 1; i < kPoses; ++i) {
        const Vec3 v = sampler.velocity(i), n = sampler.direction();
        const double b = length(v);
        const Aberrated there = aberrate_to_static(n, v);
        CHECK(std::fabs(length(there.n) - 1.0) < kAberrationTolerance);
        const double stretch = std::sqrt((1.0 + b) / (1.0 - b));
        const double seen = angle_between(n, v), at_rest = angle_between(there.n, v);
        CHECK(at_rest >= seen);
        const double expected = 2.0 * std::atan(stretch * std::tan(0.5 * seen));
        CHECK(std::fabs(at_rest - expected) < 1e-9);  // 1 - b as a difference: 2^-53 / 1e-6
        const Aberrated back = aberrate_to_static(there.n, -v);
        CHECK(distance(back.n, n) < kRoundTrip);
        CHECK(std::fabs(back.doppler * there.doppler - 1.0) < 1e-9);  // conditioning: gamma^2 2^-53 of n_static
    }
}

TEST_CASE("a pixel's ray through the tetrad is the same as by aberration") {
    Sampler sampler;
    const auto metric = spacetime("schwarzschild");
    double worst = 0.0;
    for (int i = 0; i < kPoses; ++i) {
        CameraSpec camera = sampler.pose(i);
        const double x = sampler.uniform(0, camera.width), y = sampler.uniform(0, camera.height);
        const Vec3 n = normalized(pixel_direction(camera, x, y));
        const Matrix4 e = *camera_tetrad(*metric, camera);
        const Matrix4 g = metric->metric(camera.r, camera.theta);
        std::array<double, 4> p{};  // the photon's momentum e_0 - n^i e_i along the static tetrad
        for (int mu = 0; mu < 4; ++mu) {
            p[mu] = (e[0][mu] - n.x * e[1][mu] - n.y * e[2][mu] - n.z * e[3][mu]) * std::sqrt(std::fabs(g[mu][mu]));
        }
        const Aberrated ray = aberrate_to_static(static_from_camera(camera) * n, camera.velocity);
        const double gamma = static_cast<double>(gamma_of(camera.velocity));
        worst = std::max(worst, std::fabs(p[0] * ray.doppler - 1.0) / (gamma * gamma));
        worst = std::max(worst, distance(Vec3{-p[1], -p[2], -p[3]} / p[0], ray.n) / (gamma * gamma));
    }
    CHECK(worst < kTetradRay);
}
