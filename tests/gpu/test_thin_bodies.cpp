// Bodies thinner than a pixel keep their light: it is how much of a pixel they cover that counts, not how thick they are along the ray.
#include <cmath>
#include <vector>

#include "sky/sky.h"
#include "support/draft.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kThinBodiesSamples = 3;  // a side and pixel, of the reference
// Of the light: edges are softened half a pixel outward where a body has corners, and to both sides where it is round.
constexpr double kTotalOfBodies = 0.06;

Draft thin_about(const char* metric) {
    return Draft()
        .metric(metric, metric == std::string("kerr") ? MetricParameters{{"spin", 0.9}} : MetricParameters{})
        .sky(SkyKind::kBlack)
        .place(30, 1.3)
        .size(48, 27)
        .plane(0.6);
}
Draft ring_about(const char* metric, double height) { return thin_about(metric).cylinder(4, 8, height); }
Draft ball_about(const char* metric) { return thin_about(metric).ball({6, 1, 0.5}, 1.5); }

double light(const Image<float>& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) sum += static_cast<double>(picture.at(x, y)[1]);
    return sum;
}

TEST_CASE("thin bodies: as much light as the reference's" * test::costly()) {
    const std::pair<std::string, Scene> cases[] = {
        {"thin ring, flat", ring_about("minkowski", 0.05)},
        {"thin ring", ring_about("schwarzschild", 0.05)},
        {"thin ring, rotating hole", ring_about("kerr", 0.05)},
        {"thick ring, flat", ring_about("minkowski", 1.5)},
        {"thick ring, rotating hole", ring_about("kerr", 1.5)},
        {"ball of six pixels, flat", ball_about("minkowski")},
        {"ball of six pixels", ball_about("schwarzschild")},
        {"ball of six pixels, rotating hole", ball_about("kerr")},
        {"torus of four pixels, flat", thin_about("minkowski").surface("(length(x, y) - 6)^2 + z^2 - 1", 8)},
        {"ring as thin as places are rounded, flat", ring_about("minkowski", 5e-5).place(30, 1.0)},
    };
    std::map<std::string, double> exact_light;
    on_every_context([&](GpuSession& session) {
        Selection selection(3);
        for (const auto& one : cases) {
            const auto& [name, scene] = one;
            if (!selection.takes_next()) continue;
            CAPTURE(one.first);
            REQUIRE(session.renderer->prepare(scene));
            if (!exact_light.contains(name)) {
                const auto sky = build_sky(scene.sky, {}, 16);
                REQUIRE(sky);
                const auto exact = reference::render_frame(scene, *sky, nullptr, kThinBodiesSamples, {});
                REQUIRE(exact);
                exact_light[name] = light(*exact);
            }
            const double drawn = light(session.renderer->picture()), all = exact_light[name];
            fmt::print("{:<7} {:<35} light {:.4f} of the reference's {:.1f}\n", session.context->kind(), name,
                       drawn / all, all);
            CHECK(all > 1);
            CHECK(std::abs(drawn / all - 1) <= kTotalOfBodies);
        }
    });
}

// One ray a pixel, wherever between the pixels' middles the body is.
TEST_CASE("thin bodies: a ball and a sphere narrower than a pixel have the light of their size") {
    constexpr double kDistance = 30, kRadius = 0.2, kWidth = 0.6, kOff = 0.08;
    constexpr int kPlaces = 12, kPixels = 16;
    const double radius_px = kRadius / kDistance * kPixels / kWidth, size_px = M_PI * radius_px * radius_px;
    on_every_context([&](GpuSession& session) {
        for (const bool sphere : {false, true})
            for (int k = 0; k < kPlaces; ++k) {
                CAPTURE(sphere);
                CAPTURE(k);
                Draft draft = Draft().metric("minkowski").sky(SkyKind::kBlack).place(kDistance, 1.3);
                draft.size(kPixels, kPixels).plane(kWidth);
                Scene scene = sphere ? draft.sphere(kRadius) : draft.ball({0, 0.5, 0}, kRadius);
                scene.bodies.back().material.colour = {1, 1, 1};
                scene.camera.yaw += 0.0031 * k, scene.camera.pitch += 0.0083 * k;
                scene.picture.refine = false;
                REQUIRE(session.renderer->prepare(scene));
                CHECK(std::abs(light(session.renderer->picture()) / size_px - 1) <= kOff);
            }
    });
}

// Along the ray its parts are short: swept angles are far from even there.
TEST_CASE("thin bodies: a solid by formula behind the centre or a throat has as much light as the ball that it is") {
    constexpr double kBound = 10, kOff = 0.04;
    constexpr int kPixels = 64;
    struct View {
        const char* metric;
        double x, width;
        bool far;
    };
    on_every_context([&](GpuSession& session) {
        for (const View& view : {View{"minkowski", -3, 0.5, false}, View{"ellis", 3, 0.16, true}}) {
            CAPTURE(view.metric);
            const auto drawn = [&](const auto& with_body) {
                Draft draft = Draft().metric(view.metric).sky(SkyKind::kBlack).place(10, 1.3);
                draft.size(kPixels, kPixels).plane(view.width);
                Scene scene = with_body(draft);
                scene.far_sky.kind = SkyKind::kBlack;
                scene.picture.refine = false;
                REQUIRE(session.renderer->prepare(scene));
                return light(session.renderer->picture());
            };
            const double ball = drawn([&](Draft& d) { return d.ball({view.x, 0, 0}, 1, view.far); });
            const auto shape = fmt::format("length(x - {}, y, z) - 1", view.x);
            CHECK(ball > 50);
            CHECK(std::abs(drawn([&](Draft& d) { return d.surface(shape, kBound, view.far); }) / ball - 1) <= kOff);
        }
    });
}

// There two neighbouring numbers of the swept angle are a tenth of the distance apart.
TEST_CASE("thin bodies: a ball a million r_s behind the hole has about the light of one a hundred times closer") {
    constexpr double kOff = 0.12;
    on_every_context([&](GpuSession& session) {
        const auto drawn = [&](double distance) {
            Scene scene =
                thin_about("schwarzschild").place(15, 1.4).plane(1.15).ball({-distance, 0, 0}, 0.25 * distance);
            scene.picture.refine = false;
            REQUIRE(session.renderer->prepare(scene));
            return light(session.renderer->picture());
        };
        const double near = drawn(1e4);
        CHECK(near > 50);
        CHECK(std::abs(drawn(1e6) / near - 1) <= kOff);
    });
}

}  // namespace
