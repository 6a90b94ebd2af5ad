// Polarised light as the GPU draws it, against axes that the reference carries along the rays by integration.
#include <algorithm>
#include <cmath>
#include <random>

#include "reference/disc_polarisation.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kTurnDegree = M_PI / 180;
constexpr double kAngle = 0.01 * kTurnDegree;  // measured 0.001 in 200 views, of floats and of the crossing's place
constexpr double kFraction = 2e-5;             // of the fit, 5e-6, and of the cosine

Scene polarised(const SpacetimeSpec& spacetime, Polarisation by, DiscField field) {
    Scene scene;
    scene.spacetime = spacetime;
    scene.picture.refine = false;
    scene.sky.kind = SkyKind::kBlack;
    DiscSpec& disc = scene.disc.emplace();
    disc.emission = DiscEmission::kThermal;
    disc.inner = 1.2, disc.outer = 15;
    disc.polarisation.by = by;
    disc.polarisation.field = field;
    disc.polarisation.vector = {0.5, -0.3, 0.4};
    return scene;
}

CameraSpec any_camera(std::mt19937& random, bool rotates) {
    const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    CameraSpec camera;
    camera.width = 96, camera.height = 54;
    camera.r = std::exp(among(std::log(4.0), std::log(3000.0)));
    camera.theta = among(0.1, M_PI - 0.1), camera.phi = among(-3.0, 3.0), camera.roll = among(-3.0, 3.0);
    camera.plane_width = 36.0 / camera.r, camera.focal_distance = 1;
    camera.observer = rotates ? ObserverKind::kZamo : ObserverKind::kStatic;
    switch (random() % 4) {
        case 0: camera.observer = ObserverKind::kOrbit; break;
        case 1:  // also inside the horizon
            camera.observer = ObserverKind::kRain;
            if (random() % 2 == 0) camera.r = among(0.85, 3.0), camera.yaw = among(-3.0, 3.0), camera.plane_width = 2;
            break;
        case 2: camera.velocity = {among(-0.4, 0.4), among(-0.4, 0.4), among(-0.4, 0.4)}; break;
        default: break;
    }
    return camera;
}

struct WorstPolarisation {
    double angle = 0, fraction = 0;
    int pixels = 0, views = 0;
};

// Some of a view's bright pixels, of opaque discs: the light of the first crossing between the rims.
void compare_view(GpuSession& session, const Scene& scene, std::mt19937& random, WorstPolarisation& worst) {
    constexpr int kPixels = 4;
    const auto exact = reference::DiscPolarisation::make(scene);
    REQUIRE(exact);
    REQUIRE(session.renderer->prepare(scene));
    const Image<float> stokes = draw_layers(*session.renderer).stokes;
    const auto intensity = [&](int x, int y) { return stokes.at(x, y)[0]; };
    const float most = *std::ranges::max_element(stokes.data);
    if (!(most > 0)) return;
    ++worst.views;
    for (int i = 0, tries = 0; i < kPixels && tries < 2000; ++tries) {
        const int x = 1 + static_cast<int>(random() % 94), y = 1 + static_cast<int>(random() % 52);
        // Whole pixels of the disc: next to a rim its light is a part of one crossing's and of the next.
        if (!(intensity(x, y) > 1e-4f * most) || !(intensity(x - 1, y) > 0) || !(intensity(x + 1, y) > 0) ||
            !(intensity(x, y - 1) > 0) || !(intensity(x, y + 1) > 0))
            continue;
        ++i;
        for (int crossing = 1; crossing <= 3; ++crossing) {
            const auto told = exact->at(x + 0.5, y + 0.5, crossing);
            if (!told || told->r > scene.disc->outer) continue;
            if (told->r > 0.95 * scene.disc->outer || told->r < 1.1 * scene.disc->inner) break;
            const double q = stokes.at(x, y)[1] / intensity(x, y), u = stokes.at(x, y)[2] / intensity(x, y);
            const double fraction = std::hypot(q, u);
            worst.fraction = std::max(worst.fraction, std::abs(fraction - told->fraction));
            if (fraction > 1e-3)
                worst.angle =
                    std::max(worst.angle, std::abs(std::remainder(0.5 * std::atan2(u, q) - told->angle, M_PI)));
            ++worst.pixels;
            break;
        }
    }
}

}  // namespace

TEST_CASE("polarisation: angle and fraction are the reference's for any camera") {
    MetricParameters formula;
    formula.formulas["A"] = "1 - 1/r + 0.05/r^3";
    const SpacetimeSpec metrics[] = {{"kerr", {{"spin", 0.95}}},
                                     {"kerr-newman", {{"spin", 0.6}, {"charge", 0.7}}},
                                     {"schwarzschild", {}},
                                     {"reissner-nordstrom", {{"charge", 0.9}}},
                                     {"formula", formula}};
    on_one_context([&](GpuSession& session) {
        WorstPolarisation worst;
        std::mt19937 random(53);
        for (int i = 0; i < by_depth(20, 200, 200); ++i) {
            const SpacetimeSpec& spacetime = metrics[i % 5];
            const auto by = i % 3 == 0 ? Polarisation::kScattering : Polarisation::kSynchrotron;
            Scene scene = polarised(spacetime, by, static_cast<DiscField>(i % 4));
            scene.camera = any_camera(random, i % 5 < 2);
            compare_view(session, scene, random, worst);
        }
        fmt::print("polarisation in {} pixels of {} views: within {:.2g} degrees and {:.2g} of the fraction\n",
                   worst.pixels, worst.views, worst.angle / kTurnDegree, worst.fraction);
        CHECK(worst.pixels > by_depth(40, 400, 400));
        CHECK(worst.angle < kAngle);
        CHECK(worst.fraction < kFraction);
    });
}
