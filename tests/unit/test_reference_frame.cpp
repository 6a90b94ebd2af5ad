// The reference's frames: finite everywhere, boosted cameras, disc hits, compositing.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "observer/pose.h"
#include "reference/reference.h"
#include "scene/projection.h"
#include "support/costly.h"
#include "support/observer.h"

namespace {

using namespace nullscope;

// A few dozen roundings of numbers of order one.
constexpr double kReferenceFrameRounding = 1e-14;
// Colours are stored as float.
constexpr double kReferenceFrameFloat = 1e-6;

Scene small_scene() {
    Scene scene;
    scene.camera.width = 65;  // odd: the middle pixel looks exactly at the hole
    scene.camera.height = 49;
    return scene;
}

bool all_finite(const RayPixel& p) {
    for (const double value : {p.sky.x, p.sky.y, p.sky.z, p.g, p.delay, p.angle, p.u, p.v}) {
        if (!std::isfinite(value)) return false;
    }
    return true;
}

TEST_CASE("reference: frames are finite everywhere") {
    for (const double r : {1.0001, 1.2, 1.5, 3.0, 15.0, 1e6}) {
        for (const double theta : {0.0, 1.48, M_PI / 2, M_PI}) {
            for (const double speed : {0.0, 0.5, 0.999999}) {
                Scene scene = small_scene();
                scene.camera.r = r;
                scene.camera.theta = theta;
                scene.camera.velocity = {-0.8 * speed, 0, 0.6 * speed};
                scene.disc = DiscSpec{};
                scene.disc->opacity = 0.5;
                const auto frame = reference::trace_frame(scene);
                REQUIRE(frame);
                bool finite = true, units = true;
                for (const RayPixel& pixel : frame->pixels) {
                    finite = finite && all_finite(pixel);
                    const double norm = length(pixel.sky);
                    units = units &&
                            (pixel.fate == Fate::kEscaped ? std::abs(norm - 1) < kReferenceFrameRounding : norm == 0);
                    units = units && pixel.order == static_cast<int>(std::floor(pixel.angle / M_PI)) && pixel.g > 0;
                }
                CHECK(finite);
                CHECK(units);
            }
        }
    }
}

TEST_CASE("reference: frames from inside a horizon are finite, and light of no positive energy has no g" *
          test::costly()) {
    for (const char* metric : {"schwarzschild", "reissner-nordstrom", "kerr"})
        for (const ObserverKind observer : {ObserverKind::kRain, ObserverKind::kFall, ObserverKind::kThrow})
            for (const double r : {0.3, 0.6, 0.87}) {
                Scene scene = small_scene();
                scene.spacetime.metric = metric;
                if (metric == std::string("kerr"))
                    scene.spacetime.parameters["spin"] = 0.5;  // between 0.067 and 0.933 r_s
                scene.camera.width = 24, scene.camera.height = 18, scene.camera.plane_width = 6;
                scene.camera.observer = observer, scene.camera.r = r, scene.camera.theta = 1.2;
                scene.camera.fall_from = 5, scene.camera.energy = 0.4;
                scene.camera.velocity = {0.3, 0.1, -0.2};
                for (const double yaw : {0.0, M_PI}) {
                    scene.camera.yaw = yaw;
                    const auto frame = reference::trace_frame(scene);
                    CAPTURE(std::string(metric));
                    CAPTURE(r);
                    REQUIRE(frame);
                    int broken = 0;
                    for (const RayPixel& pixel : frame->pixels) broken += !all_finite(pixel) || !(pixel.g >= 0);
                    CHECK(broken == 0);
                }
            }
}

// The frame carries a photon momentum through the tetrad; the same pixel by the product form of aberration and
// trace_ray.
TEST_CASE("reference: pixels agree with single rays, also at 0.999999 c") {
    for (const double speed : {0.0, 0.3, 0.99, 0.999999}) {
        Scene scene = small_scene();
        scene.camera.velocity = speed * normalized(Vec3{-1, 0.3, 0.4});
        scene.camera.yaw = 0.2;
        scene.camera.pitch = -0.1;
        scene.camera.roll = 0.4;
        const auto frame = reference::trace_frame(scene);
        REQUIRE(frame);
        int escaped = 0;
        for (int y = 0; y < scene.camera.height; y += 4) {
            for (int x = 0; x < scene.camera.width; x += 4) {
                const Vec3 n =
                    static_from_camera(scene.camera) * normalized(pixel_direction(scene.camera, x + 0.5, y + 0.5));
                const Aberrated seen = aberrate_to_static(n, scene.camera.velocity);
                RayQuery query;
                query.r = scene.camera.r;
                query.theta = scene.camera.theta;
                query.n = seen.n;
                const auto record = reference::trace_ray(scene, query);
                REQUIRE(record);
                const RayPixel& pixel = frame->at(x, y);
                CHECK(pixel.fate == record->fate);
                // Rounding of the view direction, 2e-16, grows by gamma = 700 ahead or astern, and by the deflection
                // near the hole.
                const double gamma = 1 / std::sqrt((1 - speed) * (1 + speed)), steep = 1 + std::exp(record->angle);
                CHECK(pixel.g == doctest::Approx(record->g * seen.doppler).epsilon(kReferenceFrameRounding * gamma));
                CHECK(std::abs(pixel.angle - record->angle) < kReferenceFrameRounding * gamma * steep);
                if (pixel.fate != Fate::kEscaped) continue;
                ++escaped;
                CHECK(angle_between(pixel.sky, record->sky) < kReferenceFrameRounding * gamma * steep);
                CHECK(pixel.delay == doctest::Approx(record->delay).epsilon(kReferenceFrameRounding * gamma * steep));
            }
        }
        CHECK(escaped > 0);
    }
}

TEST_CASE("reference: opaque and translucent disc hits") {
    Scene scene = small_scene();
    scene.camera.r = 20;
    scene.disc = DiscSpec{};
    const auto opaque = reference::trace_frame(scene);
    scene.disc->opacity = 0.3;
    const auto translucent = reference::trace_frame(scene);
    scene.disc.reset();
    const auto without = reference::trace_frame(scene);
    REQUIRE(opaque);
    REQUIRE(translucent);
    REQUIRE(without);
    int hits = 0, second_images = 0;
    for (int y = 0; y < scene.camera.height; ++y) {
        for (int x = 0; x < scene.camera.width; ++x) {
            const RayPixel &solid = opaque->at(x, y), &thin = translucent->at(x, y), &bare = without->at(x, y);
            CHECK(thin.fate == bare.fate);
            CHECK(thin.angle == bare.angle);
            CHECK(thin.hit == solid.hit);
            CHECK(solid.hit == (solid.fate == Fate::kHit ? 1 : 0));
            if (solid.fate != Fate::kHit) continue;
            ++hits;
            second_images += solid.order == 1;
            RayQuery query;
            query.r = scene.camera.r;
            query.theta = scene.camera.theta;
            query.n = static_from_camera(scene.camera) * normalized(pixel_direction(scene.camera, x + 0.5, y + 0.5));
            query.at_angle = solid.angle;
            const auto record = reference::trace_ray(scene, query);
            REQUIRE(record);
            const double r = std::hypot(solid.u, solid.v);
            CHECK(r >= DiscSpec{}.inner);
            CHECK(r <= DiscSpec{}.outer);
            // Position from a rounded view direction: 1e-13 covers the stretch of grazing and wound rays of this frame.
            CHECK(r * record->at == doctest::Approx(1).epsilon(10 * kReferenceFrameRounding * std::exp(solid.angle)));
            CHECK(thin.u == solid.u);
            CHECK(thin.v == solid.v);
        }
    }
    CHECK(hits > 200);
    CHECK(second_images > 0);
}

SkyCube plain_sky(Vec3 colour) {
    SkyCube sky;
    sky.size = 4;
    for (Image<float>& face : sky.faces) {
        face = Image<float>(4, 4, 3);
        for (std::size_t i = 0; i < face.data.size(); i += 3) {
            face.data[i] = static_cast<float>(colour.x);
            face.data[i + 1] = static_cast<float>(colour.y);
            face.data[i + 2] = static_cast<float>(colour.z);
        }
    }
    return sky;
}

TEST_CASE("reference: colours composite front to back over all crossings") {
    Scene scene = small_scene();
    scene.camera.r = 20;
    scene.disc = DiscSpec{};
    scene.disc->opacity = 0.25;
    scene.disc->brightness = 2;
    const SkyCube sky = plain_sky({0, 1, 0});
    const auto image = reference::render_frame(scene, sky, nullptr, 1);
    const auto rays = reference::trace_frame(scene);
    REQUIRE(image);
    REQUIRE(rays);
    int most = 0;
    for (std::size_t i = 0; i < rays->pixels.size(); ++i) {
        // Red comes from the white disc alone: 2 (1 - 0.75^n) after n hits; green also from the sky behind.
        const double red = image->data[3 * i], through = 1 - red / 2, hits = std::log(through) / std::log(0.75);
        CHECK(std::abs(hits - std::round(hits)) < 1e-4);
        most = std::max(most, static_cast<int>(std::round(hits)));
        CHECK((std::round(hits) > 0) == (rays->pixels[i].hit == 1));
        const double behind = rays->pixels[i].fate == Fate::kEscaped ? through : 0;
        CHECK(std::abs(image->data[3 * i + 1] - (red + behind)) < kReferenceFrameFloat);
    }
    CHECK(most >= 2);
}

TEST_CASE("reference: the disc's image is mapped as DiscSpec says") {
    Scene scene;
    scene.spacetime.metric = "minkowski";
    scene.camera.r = 30;
    scene.camera.theta = 1e-3;  // from above the pole: forward is down, up is -e_theta, away from phi = 0
    scene.camera.width = scene.camera.height = 64;
    scene.disc = DiscSpec{};
    scene.disc->inner = 1;
    scene.disc->outer = 12;
    Image<float> quadrants(2, 2, 3);
    quadrants.at(0, 0)[0] = 1;  // x < 0, y > 0: red
    quadrants.at(1, 0)[1] = 1;  // x > 0, y > 0: green
    quadrants.at(0, 1)[2] = 1;  // x < 0, y < 0: blue
    const SkyCube sky = plain_sky({0, 0, 0});
    const auto rays = reference::trace_frame(scene);
    REQUIRE(rays);
    for (const double rotation : {0.0, M_PI / 2}) {
        scene.disc->rotation = rotation;
        const auto image = reference::render_frame(scene, sky, &quadrants, 1);
        REQUIRE(image);
        int checked = 0;
        for (int i = 0; i < 64 * 64; ++i) {
            const RayPixel& p = rays->pixels[i];
            if (p.hit == 0 || std::min(std::abs(p.u), std::abs(p.v)) < 6.5) continue;  // beyond the last texel's centre
            const double x = rotation == 0 ? p.u : p.v, y = rotation == 0 ? p.v : -p.u;  // turned back
            const Vec3 expected = y > 0 ? (x < 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}) : Vec3{0, 0, x < 0 ? 1.0 : 0.0};
            const float* pixel = image->data.data() + 3 * i;
            CHECK(length(Vec3{pixel[0], pixel[1], pixel[2]} - expected) < kReferenceFrameFloat);
            ++checked;
        }
        CHECK(checked > 50);
    }
}

TEST_CASE("reference: frames refuse what cannot be") {
    const auto refused = [](const Scene& scene) {
        const auto frame = reference::trace_frame(scene);
        return !frame && frame.error().kind == ErrorKind::kBadInput;
    };
    Scene scene = small_scene();
    scene.camera.r = 1;
    CHECK(refused(scene));
    scene = small_scene();
    scene.camera.velocity = {1, 0, 0};
    CHECK(refused(scene));
    scene = small_scene();
    scene.camera.theta = -0.1;
    CHECK(refused(scene));
    scene = small_scene();
    scene.spacetime.metric = "nothing";
    CHECK(refused(scene));
    CHECK(!reference::render_frame(small_scene(), plain_sky({0, 0, 0}), nullptr, 0));
    CHECK(!reference::trace_pixels(small_scene(), {{kNotANumber, 1}}));
}

TEST_CASE("rays that are asked for no delay are the same but for it") {
    const Scene scene = small_scene();
    const std::vector<std::array<double, 2>> positions{{0.5, 0.5}, {3.25, 2.5}, {-9, 0}};
    const auto all = reference::trace_pixels(scene, positions), bare = reference::trace_pixels(scene, positions, false);
    REQUIRE(all);
    REQUIRE(bare);
    REQUIRE(bare->size() == positions.size());
    CHECK((*all)[0].delay != 0);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const RayPixel &a = (*all)[i], &b = (*bare)[i];
        CHECK(b.delay == 0);
        CHECK(a.fate == b.fate);
        CHECK(a.hit == b.hit);
        CHECK(length(a.sky - b.sky) == 0);
        CHECK(a.angle == b.angle);
        CHECK(a.g == b.g);
    }
}

}  // namespace
