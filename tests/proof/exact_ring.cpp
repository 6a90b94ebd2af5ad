#include "proof/exact_ring.h"

#include <algorithm>
#include <cmath>

namespace nullscope::proof {
namespace {

// Where the ray has left the photon sphere there is nothing small any more.
using Fewer = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

Big dot(const Big3& a, const Big3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Big3 sum(const Big3& a, const Big& s, const Big3& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
Big3 unit(const Big3& a) { return sum({0, 0, 0}, 1 / sqrt(dot(a, a)), a); }
Big3 cross(const Big3& a, const Big3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Where light that an observer with velocity w sees at v (unit) is seen by one at rest.
Big3 seen_from(const Big3& v, const Big3& w) {
    const Big w2 = dot(w, w), gamma = 1 / sqrt(1 - w2), along = dot(w, v);
    const Big3 k = sum(v, gamma * gamma / (1 + gamma) * along - gamma, w);
    return unit(k);
}

// R_F (Carlson 1995): duplication until the arguments agree to 1e-12, then its series to fifth order: 1e-70.
template <class Real>
Real carlson_rf(Real x, Real y, Real z) {
    using std::abs, std::sqrt;
    for (;;) {
        const Real mean = (x + y + z) / 3;
        const Real dx = 1 - x / mean, dy = 1 - y / mean, dz = 1 - z / mean;
        if (std::max({abs(dx), abs(dy), abs(dz)}) < 1e-12) {
            const Real e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / sqrt(mean);
        }
        const Real l = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
        x = (x + l) / 4, y = (y + l) / 4, z = (z + l) / 4;
    }
}

// Of (du/dphi)^2 = q^2 - u^2 + u^3 for q below the critical one: u1 < u2 < u3 with u1 < 0, by the cosine of a third.
std::array<Big, 3> roots(const Big& q2) {
    const Big pi = boost::math::constants::pi<Big>();
    const Big third = acos(1 - Big(27) / 2 * q2) / 3;
    std::array<Big, 3> u;
    for (int k = 0; k < 3; ++k) u[static_cast<std::size_t>(k)] = Big(1) / 3 + Big(2) / 3 * cos(third - 2 * pi * k / 3);
    std::sort(u.begin(), u.end());
    return u;
}

// Integral of du / sqrt((u - u1)(u2 - u)(u3 - u)) from low to high <= u2 (Carlson 1988).
template <class Real>
Real swept(const std::array<Real, 3>& u, const Real& low, const Real& high) {
    using std::sqrt;
    const auto root = [](const Real& v) { return sqrt(v > 0 ? v : Real(0)); };
    const Real x1 = root(high - u[0]), y1 = root(low - u[0]), x2 = root(u[1] - high), y2 = root(u[1] - low),
               x3 = root(u[2] - high), y3 = root(u[2] - low), d = high - low;
    if (d == 0) return 0;
    const Real a = (x1 * x2 * y3 + y1 * y2 * x3) / d, b = (x1 * x3 * y2 + y1 * y3 * x2) / d,
               c = (x2 * x3 * y1 + y2 * y3 * x1) / d;
    return 2 * carlson_rf(a * a, b * b, c * c);
}

// The u that is reached from `from` after an angle: halvings in double, then Newton's steps.
Fewer place_after(const std::array<Fewer, 3>& u, const Fewer& from, const Fewer& wanted) {
    constexpr int kHalvings = 40, kSteps = 3;
    std::array<double, 3> rough{};
    for (std::size_t i = 0; i < 3; ++i) rough[i] = static_cast<double>(u[i]);
    const double start = static_cast<double>(from), angle = static_cast<double>(wanted);
    double low = start, high = rough[1];
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (swept(rough, start, middle) < angle ? low : high) = middle;
    }
    Fewer at = 0.5 * (low + high);
    for (int i = 0; i < kSteps; ++i)
        at += (wanted - swept(u, from, at)) * sqrt((at - u[0]) * (u[1] - at) * (u[2] - at));
    return at;
}

}  // namespace

ExactRing::ExactRing(const Scene& scene) : scene_(scene) {
    const CameraSpec& camera = scene.camera;
    const Big r = camera.r;
    u0_ = 1 / r;
    lapse_ = sqrt(1 - u0_);
    motion_ = {Big(camera.velocity.x), Big(camera.velocity.y), Big(camera.velocity.z)};
    if (camera.observer == ObserverKind::kOrbit) motion_ = {0, 0, sqrt(1 / (2 * (r - 1)))};
    if (camera.observer == ObserverKind::kRain) motion_ = {-sqrt(u0_), 0, 0};
    const Big sine = 3 * sqrt(Big(3)) / 2 * u0_ * lapse_, cosine = sqrt(1 - sine * sine), psi = camera.zoom->angle;
    const Big3 critical{-cosine, -sine * sin(psi), -sine * cos(psi)};
    const Big3 back_motion = sum({0, 0, 0}, -1, motion_);
    forward_ = seen_from(critical, back_motion);
    // Yaw and pitch of docs/observers.md, roll after them.
    const Big3 back = sum({0, 0, 0}, -1, forward_);
    const Big cp = sqrt(back[0] * back[0] + back[2] * back[2]), cy = back[0] / cp, sy = -back[2] / cp;
    const Big3 right{sy, 0, cy}, up = cross(back, right);
    const Big cr = cos(Big(camera.roll)), sr = sin(Big(camera.roll));
    right_ = sum(sum({0, 0, 0}, cr, right), -sr, up);
    up_ = sum(sum({0, 0, 0}, cr, up), sr, right);
    pixel_ = Big(camera.plane_width) / camera.width / Big(camera.focal_distance) * exp(-Big(camera.zoom->depth));
}

ExactRingRay ExactRing::ray(const Big& x, const Big& y) const {
    const CameraSpec& camera = scene_.camera;
    const Big pi = boost::math::constants::pi<Big>();
    const Big3 seen = unit(sum(sum(forward_, pixel_ * x, right_), pixel_ * y, up_));
    const Big3 n = seen_from(seen, motion_);
    const Big across = sqrt(n[1] * n[1] + n[2] * n[2]), q = lapse_ / (across / u0_), q2 = q * q;
    ExactRingRay ray;
    ray.escapes = 27 * q2 < 4;
    // In the plane of the ray: outward at the camera, and the way that it goes. World axes at the camera's place.
    const Big theta = camera.theta, phi = camera.phi;
    const Big3 er{sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)},
        et{cos(theta) * cos(phi), cos(theta) * sin(phi), -sin(theta)}, ep{-sin(phi), cos(phi), 0};
    const Big3 way = sum(sum({0, 0, 0}, n[1] / across, et), n[2] / across, ep);
    const auto outward = [&](const Big& angle) { return sum(sum({0, 0, 0}, cos(angle), er), sin(angle), way); };
    if (!ray.escapes) return ray;
    const auto u = roots(q2);
    const Big in = swept(u, u0_, u[1]), out = swept(u, Big(0), u[1]);
    ray.swept = in + out;
    ray.order = static_cast<int>(floor(ray.swept / pi));
    const Big3 end = outward(ray.swept);
    for (std::size_t i = 0; i < 3; ++i) ray.sky[i] = static_cast<double>(end[i]);
    if (!scene_.disc) return ray;
    // z = 0 of cos(angle) er + sin(angle) way.
    Big first = atan2(-er[2], way[2]);
    while (first <= 0) first += pi;
    while (first > pi) first -= pi;
    for (int k = 0; k <= ray.order; ++k) {
        const Big at = first + k * pi;
        if (at >= ray.swept) break;
        // Next to the photon sphere, far from both ends, no disc of these scenes is.
        constexpr double kEnds = 12.0;
        if (at > kEnds && ray.swept - at > kEnds) {
            k += std::max(static_cast<int>((ray.swept - kEnds - at) / pi) - 1, 0);
            continue;
        }
        const bool inward = at < in;
        const Fewer from(inward ? u0_ : Big(0)), wanted(inward ? at : ray.swept - at);
        const std::array<Fewer, 3> near{Fewer(u[0]), Fewer(u[1]), Fewer(u[2])};
        const double r = 1 / static_cast<double>(place_after(near, from, wanted));
        if (r < scene_.disc->inner || r > scene_.disc->outer) continue;
        const Big3 place = outward(at);
        ray.disc = {r * static_cast<double>(place[0]), r * static_cast<double>(place[1])};
        break;
    }
    return ray;
}

}  // namespace nullscope::proof
