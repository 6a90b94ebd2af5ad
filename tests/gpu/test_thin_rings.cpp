// Images of the disc of high order, thinner than a pixel: a line as bright as the reference's, not dashes.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sky/sky.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kThinRingsSamples = 16;  // a side and pixel, of the reference
// Of the ring's light: one colour stands for its whole width, and the rows of a disc's image differ.
constexpr double kThinRingsTotal = 0.15;
// Of a column's light to its neighbours': what a line has that crosses pixels at an angle.
constexpr double kUneven = 0.25;

// Light of each column, linear, summed over the rows and colours.
std::vector<double> columns(const Image<float>& picture) {
    std::vector<double> light(static_cast<std::size_t>(picture.width), 0.0);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) light[static_cast<std::size_t>(x)] += static_cast<double>(picture.at(x, y)[c]);
    return light;
}
double total(const std::vector<double>& light) {
    double sum = 0;
    for (const double l : light) sum += l;
    return sum;
}
// The largest part by which a column differs from the mean of all.
double uneven(const std::vector<double>& light) {
    const double mean = total(light) / static_cast<double>(light.size());
    double most = 0;
    for (const double l : light) most = std::max(most, std::abs(l / mean - 1));
    return most;
}

// At the top of the photon ring; the first ring that winds once more is some 0.9 px wide at scale 1, the next at exp(-pi).
Scene ring_scene(double scale, double r) {
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.disc = DiscSpec{};
    CameraSpec& camera = scene.camera;
    camera.r = r, camera.theta = 80 * M_PI / 180;
    camera.pitch = std::asin(1.5 * std::sqrt(3.0) / r * std::sqrt(1 - 1 / r));
    camera.width = 60, camera.height = 16;
    camera.plane_width = scale * camera.width * 5.45e-5 * 22 / r;
    return scene;
}

TEST_CASE("thin rings: a line with the reference's light" * test::costly()) {
    const auto disc = load_disc_image(DiscSpec{});
    REQUIRE(disc);
    on_one_context([&](GpuSession& session) {
        Selection selection(4);  // the widest of the second ring first, where a lost line shows most
        for (const double r : {8.0, 22.0})
            for (const double scale : {1.5 * std::exp(-M_PI), std::exp(-M_PI), 0.5 * std::exp(-M_PI), 1.5, 1.0, 0.5}) {
                if (!selection.takes_next()) continue;
                const Scene scene = ring_scene(scale, r);
                CAPTURE(scale);
                CAPTURE(r);
                REQUIRE(session.renderer->prepare(scene));
                const std::vector<double> drawn = columns(session.renderer->picture());
                const auto sky = build_sky(scene.sky, {}, 16);
                REQUIRE(sky);
                const auto exact = reference::render_frame(scene, *sky, &disc->image, kThinRingsSamples, {});
                REQUIRE(exact);
                const std::vector<double> true_light = columns(*exact);
                const double ratio = total(drawn) / total(true_light);
                fmt::print(
                    "{:<7} r = {:<2}, scale {:.4f}: light {:.3f} of the reference's, uneven by {:.3f} ({:.3f})\n",
                    session.context->kind(), r, scale, ratio, uneven(drawn), uneven(true_light));
                CHECK(std::abs(ratio - 1) <= kThinRingsTotal);
                CHECK(uneven(drawn) <= uneven(true_light) + kUneven);
            }
    });
}

// The light of a scene's picture over the reference's, which traces four by four rays a pixel.
double share_of_light(GpuSession& session, const Scene& scene, const Image<float>* disc) {
    constexpr int kSamples = 4;
    REQUIRE(session.renderer->prepare(scene));
    const double drawn = total(columns(session.renderer->picture()));
    const auto sky = build_sky(scene.sky, {}, 16);
    REQUIRE(sky);
    const auto exact = reference::render_frame(scene, *sky, disc, kSamples, {});
    REQUIRE(exact);
    const double share = drawn / total(columns(*exact));
    fmt::print("{:<7} {}, disc from {} to {}: light {:.4f} of the reference's\n", session.context->kind(),
               scene.spacetime.metric, scene.disc->inner, scene.disc->outer, share);
    return share;
}

// Where a pixel is a fifth of the shadow's radius, the disc's near images are no thin rings: taken for some, they lost a tenth of their light.
TEST_CASE("thin rings: a picture of few pixels has the disc's light") {
    constexpr double kTotal = 0.006;  // of the light: rims filtered by a straight edge's share of a pixel
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.disc = DiscSpec{};
    scene.picture.refine = false;
    scene.disc->inner = 3.2, scene.disc->outer = 7.0, scene.disc->material.texture = TextureKind::kPlain;
    scene.camera.r = 11.246, scene.camera.theta = 73.545 * M_PI / 180;
    scene.camera.width = 32, scene.camera.height = 18, scene.camera.plane_width = 2 * std::tan(37.5 * M_PI / 180);
    on_one_context([&](GpuSession& session) {
        for (const auto& [metric, lapse] : {std::pair{"schwarzschild", ""}, {"formula", "1 - r^2/(r^3 + 0.3^2)"}}) {
            scene.spacetime = {metric, {}};
            if (*lapse != 0) scene.spacetime.parameters.formulas["A"] = lapse;
            CHECK(std::abs(share_of_light(session, scene, nullptr) - 1) <= kTotal);
        }
    });
}

// The limit holds from where the critical ray is closer to the photon sphere than the disc's rims are, and next to the critical direction.
TEST_CASE("thin rings: a disc about the photon sphere") {
    constexpr double kTotal = 0.01;
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.disc = DiscSpec{};
    const auto image = load_disc_image(*scene.disc);
    REQUIRE(image);
    scene.camera.r = 15.0, scene.camera.theta = M_PI / 3;
    scene.camera.width = 160, scene.camera.height = 90, scene.camera.plane_width = 2 * std::tan(12 * M_PI / 180);
    on_one_context([&](GpuSession& session) {
        for (const auto& [inner, outer] : {std::pair{1.45, 1.55}, {1.4, 1.6}}) {
            scene.disc->inner = inner, scene.disc->outer = outer;
            CHECK(std::abs(share_of_light(session, scene, &image->image) - 1) <= kTotal);
        }
    });
}

}  // namespace
