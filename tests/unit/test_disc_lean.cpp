// Discs that lean: their plane, and what the reference sees of one, which is what a camera sees that is turned about one that does not.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "observer/pose.h"
#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/ray_curve.h"
#include "reference/reference.h"
#include "scene/leaning_disc.h"
#include "spacetime/leaning_circle.h"
#include "spacetime/registry.h"

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

// About a rotating hole, of a hair's tilt: what the equator's own way of crossings and matter have. By two ways of the reference.
TEST_CASE("disc lean: a hair's tilt about a rotating hole is none, by crossings and by matter") {
    for (const double spin : {-0.9, 0.6}) {
        Scene flat;
        flat.spacetime = {"kerr", {{"spin", spin}}};
        flat.camera.r = 11, flat.camera.theta = 1.0, flat.camera.observer = ObserverKind::kZamo;
        flat.camera.width = 24, flat.camera.height = 16, flat.camera.plane_width = 1.4;
        DiscSpec& disc = flat.disc.emplace();
        disc.inner = 5, disc.outer = 20, disc.opacity = 0.5, disc.emission = DiscEmission::kThermal;
        Scene hair = flat;
        hair.disc->lean = {1e-9, 0.7};
        const auto a = reference::FrameTracer::make(flat), b = reference::FrameTracer::make(hair);
        REQUIRE(a);
        REQUIRE(b);
        const reference::DiscLight of_flat(a->matter(), *flat.disc, {}), of_hair(b->matter(), *hair.disc, {});
        double most = 0, most_g = 0;
        int met = 0;
        for (int y = 1; y < 16; y += 2)
            for (int x = 1; x < 24; x += 2) {
                const auto one = a->ray(x, y), other = b->ray(x, y);
                const auto p = a->disc_hits(*one, 3), q = b->disc_hits(*other, 3);
                REQUIRE(p.size() == q.size());
                for (std::size_t k = 0; k < p.size(); ++k, ++met) {
                    const double r = std::hypot(p[k].x, p[k].y);
                    const auto g = [&](const reference::DiscLight& light, const reference::DiscHit& hit) {
                        return light.g_infinity({std::hypot(hit.x, hit.y), hit.l, hit.climb, hit.cosine, hit.across});
                    };
                    const auto slant = [&](const reference::DiscLight& light, const reference::DiscHit& hit) {
                        return light.cosine({std::hypot(hit.x, hit.y), hit.l, hit.climb, hit.cosine, hit.across});
                    };
                    most_g = std::max(most_g, std::fabs(slant(of_hair, q[k]) - slant(of_flat, p[k])));
                    most = std::max({most, std::hypot(p[k].x - q[k].x, p[k].y - q[k].y) / r,
                                     std::fabs(p[k].l - q[k].l) / r, std::fabs(p[k].climb - q[k].climb)});
                    most_g = std::max(most_g, std::fabs(g(of_hair, q[k]) / g(of_flat, p[k]) - 1));
                }
            }
        fmt::print(
            "disc lean: a = {}, {} crossings of a hair's tilt are the equator's to {:.1e}, g and cosine to {:.1e}\n",
            spin, met, most, most_g);
        CHECK(met > 40);
        CHECK(most < 1e-7);
        CHECK(most_g < 1e-7);
    }
}

// Of cameras that fly or fall, too.
TEST_CASE("disc lean: the curve of a pixel's ray ends where the pixel's ray does") {
    for (const ObserverKind observer : {ObserverKind::kZamo, ObserverKind::kRain}) {
        Scene scene;
        scene.spacetime = {"kerr", {{"spin", 0.8}}};
        CameraSpec& camera = scene.camera;
        camera.r = 14, camera.theta = 1.1, camera.phi = 0.4, camera.observer = observer;
        camera.velocity = {-0.2, 0.1, 0.3};
        camera.width = 16, camera.height = 10, camera.plane_width = 1.6;
        scene.disc.emplace().inner = 3, scene.disc->outer = 9;
        scene.disc->lean = {0.9, 0.7};
        const auto tracer = reference::FrameTracer::make(scene);
        REQUIRE(tracer);
        const auto spacetime = *make_spacetime("kerr", scene.spacetime.parameters);
        double most = 0;
        int met = 0, skies = 0;
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 16; ++x) {
                const reference::RayPtr ray = tracer->ray(x + 0.5, y + 0.5);
                const auto hits = tracer->disc_hits(*ray, 1);
                const double end = hits.empty() ? INFINITY : hits.front().along;
                const auto curve = reference::pixel_curve(
                    *tracer, *spacetime, {x + 0.5, y + 0.5, camera.r, ray->g, end}, {30, hits.empty() ? 1e5 : 100});
                REQUIRE(curve.size() == 30);
                const reference::CurvePoint& last = curve.back();
                const Vec3 n{std::sin(last.theta) * std::cos(last.phi), std::sin(last.theta) * std::sin(last.phi),
                             std::cos(last.theta)};
                CHECK(std::fabs(curve.front().r - 14) < 1e-9);
                if (!hits.empty()) {
                    const Vec3 place = disc_plane_of(scene).place(hits.front().x, hits.front().y);
                    most = std::max(most, length(last.r * n - place)), ++met;
                } else if (ray->fate() == Fate::kEscaped) {
                    CHECK(length(n - ray->end_direction()) < 2e-4);
                    ++skies;
                }
            }
        fmt::print("disc lean: {} curves of pixels end on the disc within {:.1e} r_s, {} on the sky\n", met, most,
                   skies);
        CHECK(met > 30);
        CHECK(skies > 30);
        CHECK(most < 1e-8);
    }
}

// u.u = -1 by the metric itself, at any place on the disc; at no tilt and at half a turn the geodesics.
TEST_CASE("disc lean: matter about a rotating hole keeps below light, or is refused") {
    const auto hole = *make_spacetime("kerr-newman", MetricParameters{{"spin", 0.8}, {"charge", 0.4}});
    for (const double tilt : {0.3, 1.2, M_PI / 2, 2.5}) {
        const DiscPlane plane = disc_plane({tilt, 0.4}, 0);
        for (const double r : {3.0, 7.0})
            for (const double round : {0.0, 0.7, 1.5, 4.0}) {
                const double rate = *leaning_rate(*hole, r, Sense::kEastward, tilt);
                const Vec3 n = plane.place(std::cos(round), std::sin(round)), way = rate * cross(plane.normal, n);
                const double theta = std::acos(n.z), phi = std::atan2(n.y, n.x);
                const Mat3 world = world_from_static(theta, phi);
                const double u[4] = {1, 0, dot(way, world.b), dot(way, world.c) / std::sin(theta)};
                const Matrix4 g = hole->metric(r, theta);
                double square = 0;
                for (std::size_t i = 0; i < 4; ++i)
                    for (std::size_t k = 0; k < 4; ++k) square += g[i][k] * u[i] * u[k];
                CHECK(std::fabs(leaning_lapse2(*hole, r, rate, tilt, std::sin(theta)) + square) < 1e-14);
            }
        const auto limit = leaning_disc_limit(*hole, 0.8, 20, Sense::kEastward, tilt);
        REQUIRE(limit);
        CHECK(*limit >= 0.8);
        CHECK(*limit < 3);
        CHECK(!leaning_disc_limit(*hole, 1.02 * *limit, 20, Sense::kEastward, tilt));
    }
    CHECK(*leaning_rate(*hole, 5, Sense::kEastward, 0) == circular_orbit(*hole, 5)->omega);
    // Upside down, eastward about its own axis is westward about the hole's.
    CHECK(std::fabs(*leaning_rate(*hole, 5, Sense::kEastward, M_PI) +
                    circular_orbit(*hole, 5, Sense::kWestward)->omega) < 1e-15);
}

}  // namespace
