// Motion vectors and ST maps against closed forms: pictures of rays that are made here, without a tracer.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/ray_motion.h"
#include "compare/st_map.h"
#include "observer/pose.h"
#include "scene/projection.h"

namespace {

using namespace nullscope;

constexpr double kMotionError_px = 0.02, kStError_px = 1e-3;  // between pixels rays are interpolated; floats

CameraSpec camera_of(double yaw) {
    CameraSpec camera;
    camera.width = 160, camera.height = 90, camera.yaw = yaw;
    return camera;
}

Mat3 ray_motion_axes_of(const CameraSpec& camera) {
    return world_from_static(camera.theta, camera.phi) * static_from_camera(camera);
}

// The sky, and in front of it a disc of radius 40 px in the picture's middle, on a plane across the line of sight at distance 10.
RayFrame rays_of(const CameraSpec& camera, double disc_at, double delay) {
    RayFrame frame{camera.width, camera.height, {}};
    const Mat3 axes = ray_motion_axes_of(camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Vec3 n = pixel_direction(camera, x + 0.5, y + 0.5);
            RayPixel pixel;
            pixel.fate = Fate::kEscaped, pixel.sky = normalized(axes * n), pixel.delay = delay;
            if (std::hypot(10 * n.x, 10 * n.y) < 2.0)
                pixel.hit = kDiscHit, pixel.fate = Fate::kHit, pixel.u = 10 * n.x - disc_at, pixel.v = 10 * n.y;
            frame.pixels.push_back(pixel);
        }
    return frame;
}

TEST_CASE("ray motion: a camera that turns, and a disc that moves, by closed forms") {
    const CameraSpec before = camera_of(0.1), after = camera_of(0.13);
    const RayFrame now = rays_of(before, 0.0, 0.0), next = rays_of(after, 0.3, 0.0);
    const RayMotion motion = ray_motion(now, next, 2.0, [](const RayPixel& p, double time) {
        return Vec3{p.u + 0.25 * time, p.v, p.w};
    });
    double sky_off = 0, disc_off = 0;
    int sky = 0, disc = 0;
    for (int y = 0; y < now.height; ++y)
        for (int x = 0; x < now.width; ++x) {
            const std::size_t i = now.index(x, y);
            if (motion.known[i] == 0.0f) continue;
            const double to_x = x + 0.5 + motion.right[i], to_y = y + 0.5 - motion.up[i];
            if (now.pixels[i].hit == kDiscHit) {
                // At u + 0.5 of its plane, which has moved by 0.3 to the right.
                const auto to = pixel_of(after, {(now.pixels[i].u + 0.8) / 10, now.pixels[i].v / 10, -1.0});
                disc_off = std::max(disc_off, std::hypot(to_x - (*to)[0], to_y - (*to)[1]));
                ++disc;
            } else {
                const auto to = pixel_of(after, transposed(ray_motion_axes_of(after)) * now.pixels[i].sky);
                sky_off = std::max(sky_off, std::hypot(to_x - (*to)[0], to_y - (*to)[1]));
                ++sky;
            }
        }
    fmt::print("motion: {} px of sky off by {:.1e} px, {} of disc by {:.1e} px\n", sky, sky_off, disc, disc_off);
    CHECK(sky > 9000);
    CHECK(disc > 1000);
    CHECK(sky_off < kMotionError_px);
    CHECK(disc_off < kMotionError_px);
}

TEST_CASE("ray motion: light that arrives later has left later") {
    const CameraSpec camera = camera_of(0.0);
    const RayFrame now = rays_of(camera, 0.0, 3.0),
                   next = rays_of(camera, 0.0, 2.5);  // time 2, light 0.5 less on its way
    double seen = 0;
    const RayMotion motion = ray_motion(now, next, 2.0, [&](const RayPixel& p, double time) {
        seen = time;
        return Vec3{p.u, p.v, p.w};
    });
    CHECK(seen == doctest::Approx(2.5));
    CHECK(motion.known[now.index(80, 45)] == 1.0f);
    CHECK(std::abs(motion.right[now.index(80, 45)]) < kMotionError_px);
}

// A plate as narrow as a deep zoom's view: most of the sky is further from it than a float can say.
TEST_CASE("ST maps: places on a narrow plate are finite") {
    CameraSpec camera = camera_of(0.4);
    camera.plane_width = 1e-300;
    const Image<float> plate =
        st_map(rays_of(camera_of(0.4), 0.0, 0.0), [&](Vec3 n) { return plate_place(camera, n); });
    CHECK(std::ranges::all_of(plate.data, [](float v) { return std::isfinite(v); }));
}

TEST_CASE("ST maps: with straight light a plate is the picture itself, a panorama the sky") {
    const CameraSpec camera = camera_of(0.4);
    RayFrame rays = rays_of(camera, 0.0, 0.0);
    const Image<float> plate = st_map(rays, [&](Vec3 n) { return plate_place(camera, n); });
    const Image<float> sky = st_map(rays, [&](Vec3 n) { return std::optional(panorama_place(n)); });
    double off = 0;
    for (int y = 0; y < rays.height; ++y)
        for (int x = 0; x < rays.width; ++x) {
            const float *p = plate.at(x, y), *s = sky.at(x, y);
            if (rays.at(x, y).fate != Fate::kEscaped) {
                CHECK(p[2] == 0.0f);
                continue;
            }
            CHECK(p[2] == 1.0f);
            off = std::max({off, std::abs(p[0] * double(camera.width) - (x + 0.5)),
                            std::abs((1 - p[1]) * double(camera.height) - (y + 0.5))});
            const double azimuth = (0.5 - s[0]) * 2 * M_PI, latitude = (s[1] - 0.5) * M_PI;
            const Vec3 back{std::cos(latitude) * std::cos(azimuth), std::cos(latitude) * std::sin(azimuth),
                            std::sin(latitude)};
            CHECK(angle_between(back, rays.at(x, y).sky) < 1e-5);
        }
    CHECK(off < kStError_px);
}

}  // namespace
