// The frequency ratio g of the disc's light as the GPU draws it: bolometric brightness is g^4 of what it is without beaming.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/seen_light.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Scene bolometric_scene(double r, double theta_deg) {
    Scene scene;
    scene.picture.refine = false;  // one ray a pixel
    scene.camera.r = r;
    scene.camera.theta = theta_deg * M_PI / 180;
    scene.camera.width = 640;
    scene.camera.height = 360;
    scene.camera.focal_distance = 1;
    scene.camera.plane_width = 2 * 16 / r;
    scene.sky.kind = SkyKind::kBlack;
    DiscSpec& disc = scene.disc.emplace();
    disc.emission = DiscEmission::kThermal;
    disc.inner = 1.4;  // matter falls inside of 3 r_s, and shines no more
    disc.outer = 14;
    scene.light.bolometric = true;
    return scene;
}

TEST_CASE("disc: g as the GPU draws it is the reference's, whole and with a part of it or aberration left out" *
          test::costly()) {
    constexpr double kTolerance = 1e-5;  // what the project promises
    on_one_context([&](GpuSession& session) {
        double worst = 0;
        int pixels = 0;
        struct Switches {
            bool doppler, gravity, aberration, lensing = true;
        };
        constexpr Switches kAll{true, true, true};
        std::vector<std::pair<double, Switches>> cases;
        for (const double theta : {5.0, 60.0, 80.0, 120.0}) cases.emplace_back(theta, kAll);
        for (const Switches part : {Switches{false, true, true},
                                    {true, false, true},
                                    {true, true, false},
                                    {true, false, false},
                                    {true, true, true, false},
                                    {true, false, false, false}})
            cases.emplace_back(60.0, part);
        Selection selection(3);
        for (const auto& [theta, part] : cases)
            for (const Vec3 velocity : {Vec3{0, 0, 0}, Vec3{0.2, 0.3, -0.1}}) {
                if (!selection.takes_next()) continue;
                Scene scene = bolometric_scene(40, theta);
                scene.camera.velocity = velocity;
                scene.light.doppler = part.doppler, scene.light.gravity = part.gravity,
                scene.light.aberration = part.aberration;
                scene.light.lensing = part.lensing;
                CAPTURE(part.doppler);
                CAPTURE(part.gravity);
                CAPTURE(part.aberration);
                CAPTURE(part.lensing);
                const Image<float> picture = picture_of(session, scene);
                Scene unbeamed = scene;
                unbeamed.light.beaming = false;
                const Image<float> own = picture_of(session, unbeamed);
                const auto tracer = reference::FrameTracer::make(scene);
                REQUIRE(tracer);
                const reference::DiscLight light(tracer->matter(), *scene.disc, scene.light);
                std::mt19937 random(3);
                for (int i = 0; i < by_depth(500, 1500, 1500); ++i) {
                    const int x = static_cast<int>(random() % 640), y = static_cast<int>(random() % 360);
                    const reference::RayPtr ray = tracer->ray(x + 0.5, y + 0.5);
                    const auto hits = tracer->disc_hits(*ray, 1);
                    if (hits.empty()) continue;
                    const double r = std::hypot(hits[0].x, hits[0].y);
                    if (r < 3.05 || r > 13.9) continue;  // dark; the rim
                    bool whole = true;                   // no rim within the pixel
                    for (const auto& [dx, dy] : {std::pair{-1.5, 0.0}, {1.5, 0.0}, {0.0, -1.5}, {0.0, 1.5}}) {
                        const auto beside = tracer->disc_hits(*tracer->ray(x + 0.5 + dx, y + 0.5 + dy), 1);
                        whole = whole && !beside.empty() && std::abs(beside[0].along - hits[0].along) < 0.3;
                    }
                    if (!whole) continue;
                    const double expected = ray->g * light.shift({r, ray->l_z, hits[0].climb}).seen(scene.light);
                    const auto brightness = [&](const Image<float>& image) {
                        const float* p = image.at(x, y);
                        return 0.2126390059 * p[0] + 0.7151686788 * p[1] + 0.0721923154 * p[2];
                    };
                    const double found = std::pow(brightness(picture) / brightness(own), 0.25),
                                 error = std::abs(found / expected - 1);
                    CAPTURE(theta);
                    CAPTURE(r);
                    CAPTURE(x);
                    CAPTURE(y);
                    CHECK(error <= kTolerance);
                    worst = std::max(worst, error);
                    ++pixels;
                }
            }
        fmt::print("g of the disc in {} pixels: within {:.2g} of the reference's\n", pixels, worst);
        CHECK(pixels > by_depth(150, 500, 500));
    });
}

// The picture with a temperature of the sky over the one without it, against what the reference makes of the same g.
TEST_CASE("sky: its light changes as a black body's by g, the same all over it or by direction, whole and in part" *
          test::costly()) {
    // The table of black bodies 2e-5, half floats of the sky's texture not at all: both have them.
    constexpr double kTolerance = 1e-3;
    on_one_context([&](GpuSession& session) {
        double worst = 0;
        int pixels = 0;
        for (int variant = 0; variant < 8; ++variant) {
            Scene scene;
            scene.picture.refine = false;
            scene.camera.r = 3.0;
            scene.camera.width = 160;
            scene.camera.height = 90;
            if (variant >= 1) scene.camera.velocity = {0.1, -0.2, 0.4};
            scene.light.shift = variant != 2, scene.light.beaming = variant != 3;
            scene.light.doppler = variant != 4, scene.light.gravity = variant != 5,
            scene.light.aberration = variant != 6;
            scene.light.bolometric = variant == 7;
            const Image<float> plain = picture_of(session, scene);
            scene.sky.temperature_K = 5000.0;
            REQUIRE(session.renderer->prepare(scene));
            CHECK(session.renderer->tables().effects().contains(Effect::kSkyShift));
            const Image<float> shifted = session.renderer->picture();
            const auto tracer = reference::FrameTracer::make(scene);
            REQUIRE(tracer);
            const Vec3 own = reference::seen_black_body(5000.0, 1.0, scene.light);
            for (int y = 0; y < 90; y += 2)
                for (int x = 0; x < 160; x += 2) {
                    const reference::RayPtr ray = tracer->ray(x + 0.5, y + 0.5);
                    if (ray->fate() != Fate::kEscaped || plain.at(x, y)[1] < 1e-4) continue;
                    const Vec3 seen = reference::seen_black_body(5000.0, ray->g, scene.light);
                    const double expected[] = {seen.x / own.x, seen.y / own.y, seen.z / own.z};
                    CAPTURE(variant);
                    CAPTURE(x);
                    CAPTURE(y);
                    for (int c = 0; c < 3; ++c) {
                        const double error = std::abs(shifted.at(x, y)[c] / plain.at(x, y)[c] / expected[c] - 1);
                        CHECK(error <= kTolerance);
                        worst = std::max(worst, error);
                    }
                    ++pixels;
                }
        }
        fmt::print("light of the sky in {} pixels: within {:.2g} of the reference's\n", pixels, worst);
        CHECK(pixels > 1000);
        Scene far;  // nothing to shift: nothing called for
        far.spacetime.metric = "minkowski";
        far.sky.temperature_K = 5000.0;
        CHECK_FALSE(effect_set(required_effects(far)).contains(Effect::kSkyShift));
    });
}

// Where the disc is a million times as wide as its spot, pixels cover 1e10 of the spot's size and more.
TEST_CASE("spots: on a wide disc") {
    Scene scene = bolometric_scene(15, 85);
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.width = 64, scene.camera.height = 36, scene.camera.plane_width = 1.2;
    *scene.disc = DiscSpec{};
    scene.spots.emplace_back();
    on_one_context([&](GpuSession& session) {
        const auto drawn = [&](double outer) {
            scene.disc->outer = outer;
            REQUIRE(session.renderer->prepare(scene));
            return session.renderer->picture();
        };
        const Image<float> wide = drawn(999999);
        CHECK(std::isfinite(sum_of(wide)));
        scene.spots.clear();
        CHECK(sum_of(wide) < sum_of(drawn(999999)) + 100);  // of the spot: 5
    });
}

}  // namespace
