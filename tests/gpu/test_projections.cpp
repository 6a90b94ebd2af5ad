// Projections other than the pinhole: the shader's directions in pictures of 8192 px against closed forms; rays and pictures of all kinds
// of light paths against the reference.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/assets.h"
#include "observer/pose.h"
#include "reference/reference.h"
#include "scene/projection.h"
#include "sky/point_stars.h"
#include "support/gpu_session.h"
#include "support/large_picture.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// All but the pinhole.
std::vector<Projection> wide_ones() {
    std::vector<Projection> list;
    for (int i = 1; i < kProjections; ++i) list.push_back(static_cast<Projection>(i));
    return list;
}

void set_projection(CameraSpec& camera, Projection projection, int height) {
    camera.projection = projection;
    set_field_of_view(camera, usual_field_of_view(projection));
    camera.height = height;
    const ProjectionRow& row = projection_row(projection);
    camera.width = row.circle ? height : row.faces ? 3 * height / 2 : 2 * height;
}

// In long double, from the definition: angles from the line of sight. Of projections that are not here pixel_direction(), which
// tests/unit/test_projection.cpp holds to formulas.
std::array<long double, 3> closed_form(const CameraSpec& camera, double x, double y) {
    const long double pixel = static_cast<long double>(camera.plane_width) /
                              (camera.projection == Projection::kFisheye ? std::min(camera.width, camera.height)
                                                                         : camera.width),
                      u = (x - 0.5L * camera.width) * pixel, v = (0.5L * camera.height - y) * pixel;
    if (camera.projection == Projection::kCube) {
        const int column = std::min(static_cast<int>(3 * x / camera.width), 2),
                  row = static_cast<int>(2 * y / camera.height);
        const long double a = u - 2 * (column - 1), b = v + (row == 0 ? -1 : 1), far = std::sqrt(1 + a * a + b * b);
        const std::array<long double, 3> faces[] = {{-1, b, -a}, {a, b, -1}, {1, b, a},
                                                    {a, -1, -b}, {-a, b, 1}, {a, 1, b}};
        const auto d = faces[3 * row + column];
        return {d[0] / far, d[1] / far, d[2] / far};
    }
    if (camera.projection == Projection::kFisheye) {
        const long double angle = std::sqrt(u * u + v * v), bearing = std::atan2(v, u);
        return {std::sin(angle) * std::cos(bearing), std::sin(angle) * std::sin(bearing), -std::cos(angle)};
    }
    if (camera.projection == Projection::kStereographic) {
        const long double scale = 4 * std::tan(0.25L * camera.plane_width) / camera.plane_width,
                          angle = 2 * std::atan(0.5L * scale * std::hypot(u, v)), bearing = std::atan2(v, u);
        return {std::sin(angle) * std::cos(bearing), std::sin(angle) * std::sin(bearing), -std::cos(angle)};
    }
    if (camera.projection != Projection::kCylindrical && camera.projection != Projection::kEquirectangular) {
        const Vec3 d = normalized(pixel_direction(camera, x, y));
        return {d.x, d.y, d.z};
    }
    const long double latitude = camera.projection == Projection::kCylindrical ? std::atan(v) : v;
    return {std::cos(latitude) * std::sin(u), std::sin(latitude), -std::cos(latitude) * std::cos(u)};
}

TEST_CASE("projections: directions in pictures of 8192 px are those of closed forms to 0.01 px") {
    constexpr double kMost_px = 0.01;
    constexpr int kSide = 8192;
    on_every_context([&](GpuSession& session) {
        for (const Projection projection : wide_ones()) {
            Scene scene;
            scene.spacetime = {"minkowski", {}};
            scene.sky.kind = SkyKind::kPlain;
            CameraSpec whole = scene.camera;
            set_projection(whole, projection, kSide);
            if (projection_row(projection).faces)
                whole.width = 8190, whole.height = 5460;
            else
                whole.width = kSide;
            whole.theta = 0.7, whole.phi = 0.3, whole.yaw = 0.4, whole.pitch = 0.2;
            const Mat3 axes = world_from_static(whole.theta, whole.phi) * static_from_camera(whole);
            double most = 0.0;
            int rays = 0, dark = 0;
            scene.camera = whole;
            each_ray_of_squares(session, scene, [&](const RayPixel& ray, int column, int row) {
                if (ray.fate != Fate::kEscaped) {
                    ++dark;
                    return;
                }
                const auto d = closed_form(whole, column + 0.5, row + 0.5);
                const Vec3 exact =
                    axes * Vec3{static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2])};
                most = std::max(most, length(ray.sky - exact) / whole.pixel());
                ++rays;
            });
            fmt::print("{}, 8192x8192: {} rays off by {:.2g} px at most, {} pixels show nothing\n",
                       projection_name(projection), rays, most, dark);
            CHECK(most < kMost_px);
            CHECK(rays > 100000);
            const bool all_of_it = projection_row(projection).shown == nullptr || projection_row(projection).faces;
            CHECK((dark > 0) == !all_of_it);
        }
    });
}

struct Place {
    const char* metric;
    MetricParameters parameters;
    ObserverKind observer;
    double r;
    Vec3 velocity;
    bool disc;
};

TEST_CASE("projections: rays are the reference's about every kind of hole" * test::costly()) {
    constexpr double kMost_px =
        0.05;  // of 2048 px across: a pixel spans as much as in the middle of 1080p over two radians
    using enum ObserverKind;
    const Place places[] = {{"schwarzschild", {}, kStatic, 6.0, {}, true},
                            {"schwarzschild", {}, kRain, 0.8, {}, false},
                            {"schwarzschild", {}, kOrbit, 5.0, {0.1, 0.0, 0.2}, true},
                            {"kerr", {{"spin", 0.9}}, kStatic, 5.0, {}, true},
                            {"kerr", {{"spin", 0.9}}, kRain, 0.6, {}, false},
                            {"kerr", {{"spin", 0.7}}, kOrbit, 6.0, {0.0, 0.2, 0.0}, true},
                            {"ellis", {{"throat", 1.0}}, kStatic, 2.0, {}, false}};
    on_one_context([&](GpuSession& session) {
        Selection selection(5);
        for (const Place& place : places)
            for (const Projection projection : wide_ones()) {
                if (!selection.takes_next()) continue;
                Scene scene;
                scene.spacetime = {place.metric, place.parameters};
                scene.camera.observer = place.observer, scene.camera.r = place.r, scene.camera.theta = 1.2;
                scene.camera.velocity = place.velocity;
                scene.camera.yaw = 0.6, scene.camera.pitch = 0.3, scene.camera.roll = 0.2;
                if (place.observer == kOrbit) scene.camera.theta = M_PI / 2;
                set_projection(scene.camera, projection, 48);
                if (place.disc) scene.disc.emplace(), scene.disc->inner = 1.5, scene.disc->outer = 4.0;
                const double finer = 2048.0 / scene.camera.width;
                const RayMeasures m = measure_rays(gl_ray_data(session, scene), scene.camera, reference_trace(scene));
                fmt::print(
                    "{:<15} {:<13} {:<6} r = {:<4}: sky {:.4f}, disc {:.4f}, g {:.4f} px of 2048; fate errors {}\n",
                    projection_name(projection), place.metric, observer_name(place.observer), place.r,
                    m.sky_px.max * finer, m.place_px.max * finer, m.g_px.max * finer, m.fate_errors);
                CHECK(m.sky_px.max * finer <= kMost_px);
                CHECK(m.place_px.max * finer <= kMost_px);
                CHECK(m.fate_errors == 0);
                CHECK(m.not_finite == 0);
                CHECK(m.sky_px.count > 500);
            }
    });
}

}  // namespace
