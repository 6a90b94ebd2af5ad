// The gas of a disc as the GPU draws it: the reference's where a pixel is small, and its mean where it is not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/disc_gas.h"
#include "reference/frame_tracer.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kDiscGasWidth = 96, kDiscGasHeight = 54;

Scene gas_scene(const SpacetimeSpec& spacetime, double theta) {
    Scene scene;
    scene.picture.refine = false;  // one ray a pixel
    scene.spacetime = spacetime;
    if (spacetime.metric != "schwarzschild") scene.camera.observer = ObserverKind::kZamo;
    scene.camera.r = 25;
    scene.camera.theta = theta;
    scene.camera.width = kDiscGasWidth, scene.camera.height = kDiscGasHeight;
    scene.camera.focal_distance = 1;
    scene.sky.kind = SkyKind::kPlain;
    scene.sky.material.colour = {0, 0, 1};
    DiscSpec& disc = scene.disc.emplace();
    disc.inner = 2.5, disc.outer = 12, disc.opacity = 0.5, disc.edge = 0.2, disc.rotation = 0.4;
    disc.material.texture = TextureKind::kGas;
    disc.material.colour = {1, 0, 0};
    disc.flow = DiscFlowKind::kKepler;
    return scene;
}

// What pixels are off by: of the disc's light over its own and 1, of what shines through.
struct Worst {
    double light = 0, through = 0;
    int pixels = 0;
};

// A window of the sky of half a degree: pixels are smaller than the finest octave.
void measure(GpuSession& session, Scene scene, std::mt19937& random, Worst& worst) {
    constexpr double kClose =
        4e-2;  // floats: places to 1e-6, angles to 1e-5 of the finest filaments, 1e-3 of ln r wide
    constexpr double kWidest = 2e-4;  // of r, what a pixel spans: a fifth of the finest filaments
    scene.camera.plane_width = 1e-3;
    std::uniform_real_distribution<double> angle(-0.5, 0.5), time(0, 300);
    scene.camera.yaw = angle(random), scene.camera.pitch = 0.5 * angle(random), scene.time = time(random);
    const Image<float> picture = picture_of(session, scene);
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    const DiscSpec& disc = *scene.disc;
    const bool flows = disc.flow == DiscFlowKind::kKepler;
    for (int i = 0; i < 40; ++i) {
        const int x = static_cast<int>(random() % kDiscGasWidth), y = static_cast<int>(random() % kDiscGasHeight);
        const reference::RayPtr ray = tracer->ray(x + 0.5, y + 0.5);
        const auto hits = tracer->disc_hits(*ray, 2);
        if (hits.size() != 1 || ray->fate() != Fate::kEscaped) continue;
        const double r = std::hypot(hits[0].x, hits[0].y);
        if (r < disc.inner + 0.01 || r > disc.outer - 0.01) continue;
        const auto beside = tracer->disc_hits(*tracer->ray(x + 1.5, y + 0.5), 2),
                   above = tracer->disc_hits(*tracer->ray(x + 0.5, y + 1.5), 2);
        if (beside.size() != 1 || above.size() != 1) continue;
        const double wide = std::max(std::hypot(beside[0].x - hits[0].x, beside[0].y - hits[0].y),
                                     std::hypot(above[0].x - hits[0].x, above[0].y - hits[0].y));
        if (wide > kWidest * r) continue;  // a small image: the finest octaves are averaged there
        const double depth = std::min(r - disc.inner, disc.outer - r) / (disc.outer - disc.inner) / disc.edge,
                     whole = depth < 1 ? depth * depth * (3 - 2 * depth) : 1, opacity = disc.opacity * whole;
        const double sense = tracer->matter().sense(disc.sense);
        const auto gas = reference::gas_at(
            disc, r, std::atan2(hits[0].y, hits[0].x), scene.time - hits[0].delay, whole,
            [&](double at) { return flows ? tracer->matter().kepler_rate(at, sense) : 0.0; }, sense);
        const double thin = 1 - opacity * gas.light, thick = (1 - opacity) * gas.gaps,
                     through = std::clamp((1 - opacity * opacity) * thin + opacity * opacity * thick, 0.0, 1.0);
        const double light_off = std::abs(picture.at(x, y)[0] - opacity * gas.light) / (opacity * (1 + gas.light)),
                     through_off = std::abs(picture.at(x, y)[2] - through);
        CAPTURE(scene.spacetime.metric);
        CAPTURE(r);
        CHECK(light_off < kClose);
        CHECK(through_off < kClose);
        worst.light = std::max(worst.light, light_off), worst.through = std::max(worst.through, through_off);
        ++worst.pixels;
    }
}

TEST_CASE("disc gas: the shader's is the reference's, at rest and moving, with and without delay and rotation" *
          test::costly()) {
    const SpacetimeSpec metrics[] = {
        {"schwarzschild", {}}, {"kerr", {{"spin", 0.9}}}, {"reissner-nordstrom", {{"charge", 0.7}}}};
    on_one_context([&](GpuSession& session) {
        std::mt19937 random(23);
        Worst worst;
        for (int view = 0; view < by_depth(24, 96, 96); ++view) {
            Scene scene = gas_scene(metrics[view % 3], view % 2 == 0 ? 0.5 : 1.2);
            scene.light.delay = view % 4 != 3;
            if (view % 5 == 4) scene.disc->flow = DiscFlowKind::kStill;
            if (view % 4 == 2) scene.disc->sense = OrbitSense::kWestward;
            if (view % 8 == 1 && view % 3 == 1) scene.spacetime.parameters["spin"] = -0.9;
            measure(session, scene, random, worst);
        }
        fmt::print("disc gas: in {} pixels light within {:.2g} of it and 1, what shines through within {:.2g}\n",
                   worst.pixels, worst.light, worst.through);
        CHECK(worst.pixels > by_depth(200, 1000, 1000));
    });
}

Image<float> whole_disc(GpuSession& session, int width, double contrast) {
    Scene scene = gas_scene({"schwarzschild", {}}, 0.7);
    scene.light.lensing = false;
    scene.camera.plane_width = 1.2;
    scene.camera.width = width, scene.camera.height = width;
    scene.disc->gas.contrast = contrast, scene.disc->inner = 1.0;
    REQUIRE(session.renderer->prepare(scene));
    return session.renderer->picture();
}

// Of the disc's light, and of the sky's that shines through.
struct Means {
    double light = 0, through = 0;
};
// Of a square of so many pixels, (x, y) its first.
Means means_of(const Image<float>& picture, int x, int y, int side) {
    Means mean;
    for (int row = y; row < y + side; ++row)
        for (int column = x; column < x + side; ++column)
            mean.light += picture.at(column, row)[0], mean.through += picture.at(column, row)[2];
    return {mean.light / side / side, mean.through / side / side};
}

// Octaves finer than a pixel are at their mean: a coarse picture is a fine one, averaged, and all of the disc's light that of a smooth one.
TEST_CASE("disc gas: a coarse picture is the mean of a fine one") {
    constexpr int kFine = 1024;
    constexpr double kMean = 0.03;   // 32 px: rims and clumps a few pixels wide
    constexpr double kPixel = 0.35;  // rms of a pixel over the mean, of octaves that are half seen
    constexpr double kSmooth = 0.1;  // of this disc at this time
    on_one_context([&](GpuSession& session) {
        const Image<float> picture = whole_disc(session, kFine, 0.6);
        const Means fine = means_of(picture, 0, 0, kFine);
        for (const int width : {512, 128, 32, 16}) {
            const Image<float> small = whole_disc(session, width, 0.6);
            const Means coarse = means_of(small, 0, 0, width);
            const int side = kFine / width;
            double off = 0, lit = 0;
            for (int y = 0; y < width; ++y)
                for (int x = 0; x < width; ++x) {
                    const double mean = means_of(picture, x * side, y * side, side).light;
                    off += std::pow(small.at(x, y)[0] - mean, 2), lit += mean * mean;
                }
            fmt::print("disc gas: {} px: light {:.4f}, through {:.4f} of those of {} px; rms of a pixel {:.3f}\n",
                       width, coarse.light / fine.light, coarse.through / fine.through, kFine, std::sqrt(off / lit));
            CHECK(coarse.light == doctest::Approx(fine.light).epsilon(kMean));
            CHECK(coarse.through == doctest::Approx(fine.through).epsilon(kMean));
            CHECK(std::sqrt(off / lit) < kPixel);
        }
        const Means smooth = means_of(whole_disc(session, kFine, 0.0), 0, 0, kFine);
        fmt::print("disc gas: light {:.4f}, through {:.4f} of those of a smooth disc\n", fine.light / smooth.light,
                   fine.through / smooth.through);
        CHECK(fine.light == doctest::Approx(smooth.light).epsilon(kSmooth));
        CHECK(fine.through == doctest::Approx(smooth.through).epsilon(kSmooth));
    });
}

}  // namespace
