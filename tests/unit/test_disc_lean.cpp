// Discs that lean: their plane, and what the reference sees of one, which is what a camera sees that is turned about one that does not.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "observer/pose.h"
#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/reference.h"
#include "scene/leaning_disc.h"

namespace {

using namespace nullscope;

constexpr double kOneDegree = M_PI / 180;

double off_by(Vec3 a, Vec3 b) { return length(a - b); }

TEST_CASE("disc lean: axes are the world's, turned about the line of nodes") {
    CHECK(disc_plane({0.0, 1.0, 0.1}, 7.0).x == Vec3{1, 0, 0});
    CHECK(disc_plane({0.0, 1.0, 0.1}, 7.0).normal == Vec3{0, 0, 1});
    for (const double tilt : {1e-9, 0.3, 1.5, M_PI / 2, 3.0, M_PI})
        for (const double node : {-2.0, 0.0, 0.7, 3.0}) {
            CAPTURE(tilt);
            CAPTURE(node);
            const DiscPlane plane = disc_plane({tilt, node, 0.25}, 2.0);
            const double at = node + 0.5;
            const Vec3 nodes{std::cos(at), std::sin(at), 0};
            CHECK(off_by(cross(plane.x, plane.y), plane.normal) < 1e-15);
            CHECK(std::fabs(length(plane.x) - 1) < 1e-15);
            CHECK(std::fabs(plane.normal.z - std::cos(tilt)) < 1e-15);
            // The node is where it was, and a quarter of a turn on the disc is above the equator.
            CHECK(off_by(plane.place(nodes.x, nodes.y), nodes) < 1e-15);
            CHECK(std::fabs(plane.place(-nodes.y, nodes.x).z - std::sin(tilt)) < 1e-15);
        }
}

// The camera of the world in which the disc is the equator's.
CameraSpec turned(CameraSpec camera, const DiscPlane& plane) {
    const Mat3 disc_from_world = transposed({plane.x, plane.y, plane.normal}), axes = world_from_camera(camera);
    const Mat3 frame = disc_from_world * world_from_static(camera.theta, camera.phi);
    const Vec3 place = frame.a, velocity = frame * camera.velocity;
    camera.theta = std::atan2(std::hypot(place.x, place.y), place.z), camera.phi = std::atan2(place.y, place.x);
    camera.velocity = transposed(world_from_static(camera.theta, camera.phi)) * velocity;
    set_world_axes(camera, disc_from_world * axes);
    return camera;
}

struct SeenDisc {
    std::vector<reference::DiscHit> hits;
    double g = 0;
};

SeenDisc seen(const reference::FrameTracer& tracer, double x, double y) {
    const auto ray = tracer.ray(x, y);
    return {tracer.disc_hits(*ray, 4), ray->g};
}

// How far the hits of two rays are apart, of their radius; none: they meet other crossings.
std::optional<double> apart(const SeenDisc& a, const SeenDisc& b) {
    if (a.hits.size() != b.hits.size()) return {};
    double most = 0;
    for (std::size_t k = 0; k < a.hits.size(); ++k) {
        const auto &p = a.hits[k], &q = b.hits[k];
        const double r = std::hypot(p.x, p.y);
        most = std::max({most, std::hypot(p.x - q.x, p.y - q.y) / r, std::fabs(p.l - q.l) / r,
                         std::fabs(p.climb - q.climb), std::fabs(p.delay - q.delay) / r});
    }
    return most;
}

Scene leaning_scene(const std::string& metric, std::mt19937_64& dice) {
    std::uniform_real_distribution<double> unit(0, 1);
    Scene scene;
    scene.spacetime.metric = metric;
    CameraSpec& camera = scene.camera;
    camera.width = 24, camera.height = 16, camera.plane_width = 1.2;
    camera.r = 6 + 20 * unit(dice), camera.theta = std::acos(1.98 * unit(dice) - 0.99), camera.phi = 6 * unit(dice);
    camera.yaw = 0.2 * unit(dice) - 0.1, camera.pitch = 0.2 * unit(dice) - 0.1, camera.roll = 6 * unit(dice);
    camera.velocity = {0.2 * unit(dice), 0.1, -0.2 * unit(dice)};
    DiscSpec& disc = scene.disc.emplace();
    disc.inner = 2.5, disc.outer = 14, disc.opacity = 0.5, disc.flow = DiscFlowKind::kKepler;
    disc.lean = {std::acos(2 * unit(dice) - 1), 6 * unit(dice), 0.01};
    scene.time = 5;
    return scene;
}

// What a rounding of the camera's axes does is what a pixel that is moved by it does: next to the critical curve much.
TEST_CASE("disc lean: where rays stay in planes it is what a turned camera sees, to rounding") {
    constexpr double kRounding = 1e-12, kMoved_px = 1e-6, kRoundingOfPixel_px = 1e-12;
    std::mt19937_64 dice(55);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const std::string metric : {"schwarzschild", "reissner-nordstrom", "minkowski"}) {
        int rays = 0, crossings = 0;
        double most = 0, least_wrong = INFINITY;
        for (int view = 0; view < 12; ++view) {
            const Scene scene = leaning_scene(metric, dice);
            Scene other = scene;
            other.camera = turned(scene.camera, disc_plane_of(scene)), other.disc->lean = {};
            Scene wrong = scene;
            wrong.disc->lean.tilt += 1e-7;
            const auto a = reference::FrameTracer::make(scene), b = reference::FrameTracer::make(other),
                       c = reference::FrameTracer::make(wrong);
            REQUIRE(a);
            REQUIRE(b);
            double wrong_most = 0;
            for (int i = 0; i < 25; ++i) {
                const double x = 24 * unit(dice), y = 16 * unit(dice);
                const SeenDisc one = seen(*a, x, y), two = seen(*b, x, y), beside = seen(*a, x + kMoved_px, y);
                const auto off = apart(one, two), moves = apart(one, beside);
                if (!moves) continue;  // at a rim
                ++rays, crossings += static_cast<int>(one.hits.size());
                REQUIRE(off);
                most = std::max(most, *off / (1 + *moves * kRoundingOfPixel_px / kMoved_px / kRounding));
                CHECK(std::fabs(two.g / one.g - 1) < kRounding);
                if (const auto far = apart(one, seen(*c, x, y))) wrong_most = std::max(wrong_most, *far);
            }
            least_wrong = std::min(least_wrong, wrong_most);
        }
        fmt::print(
            "disc lean: {}, {} rays with {} crossings are the turned camera's to {:.1e}; off by 1e-7 of tilt {:.1e}\n",
            metric, rays, crossings, most, least_wrong);
        CHECK(rays > 250);
        CHECK(crossings > 100);
        CHECK(most < kRounding);
        CHECK(least_wrong > 1e-9);
    }
}

// As nullscope trace lists them, by world azimuths: where the ray's own plane and the disc's meet.
TEST_CASE("disc lean: crossings of a list of rays lie in its plane") {
    Scene scene;
    scene.disc.emplace().lean = {70 * kOneDegree, 25 * kOneDegree};
    const DiscPlane plane = disc_plane_of(scene);
    const Mat3 world = world_from_static(1.1, 0.4);
    int met = 0;
    for (int i = 0; i < 20; ++i) {
        const Vec3 n = normalized(Vec3{-1, 0.03 * i - 0.3, 0.02 * i + 0.01});
        const auto record = reference::trace_ray(scene, {9, 1.1, 0.4, n, LocalFrame::kStatic, {}, {}}, 3);
        REQUIRE(record);
        const Vec3 line = normalized(cross(cross(world.a, world * n), plane.normal));
        const double phi = std::atan2(line.y, line.x);
        for (const auto& crossing : record->crossings) {
            CHECK(std::fabs(std::remainder(crossing.phi - phi, M_PI)) < 1e-12);
            ++met;
        }
    }
    CHECK(met > 10);
}

}  // namespace
