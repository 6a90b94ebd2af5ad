// Polarised light as the GPU draws it, against axes that the reference carries along the rays by integration.
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "reference/disc_polarisation.h"
#include "scene/projection.h"
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
    const auto from = exact->axes_of(scene.camera);
    REQUIRE(from);
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
            const auto told = exact->at(*from, normalized(pixel_direction(scene.camera, x + 0.5, y + 0.5)), crossing);
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

// Light of an observer at infinity at (alpha, beta) M, from matter on circular orbits at the first crossing (../unit/test_polarisation.cpp has the reference's): a
// ring of hot spots, which go round within the last stable orbit too. From 1e6 r_s.
TEST_CASE("polarisation: the shader's synchrotron light of matter on circular orbits") {
    struct Row {
        double spin, theta, alpha, beta, r;
        double angle[3];  // field vertical, radial, toroidal
    };
    constexpr Row kRows[] = {{0, 60, 5, 3, 4.269185926, {33.475414, 122.536405, 25.143158}},
                             {0.9, 60, 5, 3, 3.629599984, {36.946388, 120.894317, 3.517027}},
                             {0.5, 80, -8, 2, 8.056922297, {177.484818, 70.289373, 110.819307}}};
    constexpr double kPixel_M = 0.2;
    constexpr int kSide = 201;
    on_one_context([&](GpuSession& session) {
        double worst = 0;
        for (const Row& row : kRows)
            for (const DiscField field : {DiscField::kVertical, DiscField::kRadial, DiscField::kToroidal}) {
                Scene scene =
                    polarised({row.spin == 0 ? "schwarzschild" : "kerr", {}}, Polarisation::kSynchrotron, field);
                if (row.spin != 0) scene.spacetime.parameters["spin"] = row.spin;
                scene.disc->opacity = 0, scene.disc->brightness = 0, scene.light.delay = false;
                SpotSpec& spot = scene.spots.emplace_back();
                spot.r = 0.5 * row.r, spot.size = 0.5, spot.count = 64;
                CameraSpec& camera = scene.camera;
                camera.r = 1e6, camera.theta = row.theta * kTurnDegree, camera.width = camera.height = kSide;
                camera.plane_width = 0.5 * kPixel_M * kSide / camera.r, camera.focal_distance = 1;
                if (row.spin != 0) camera.observer = ObserverKind::kZamo;
                REQUIRE(session.renderer->prepare(scene));
                const Image<float> stokes = draw_layers(*session.renderer).stokes;
                const float* light = stokes.at(kSide / 2 + static_cast<int>(std::lround(row.alpha / kPixel_M)),
                                               kSide / 2 - static_cast<int>(std::lround(row.beta / kPixel_M)));
                REQUIRE(light[0] > 0);
                const double found = 0.5 * std::atan2(light[2], light[1]),
                             off = std::abs(
                                 std::remainder(found - row.angle[static_cast<int>(field)] * kTurnDegree, M_PI));
                CAPTURE(row.spin);
                CAPTURE(static_cast<int>(field));
                CHECK(off < 0.05 * kTurnDegree);
                worst = std::max(worst, off);
            }
        fmt::print("polarisation of circular orbits from 1e6 r_s: within {:.2g} degrees\n", worst / kTurnDegree);
    });
}

// Seen face-on nothing is singled out: the whole disc has no net polarisation; a ring in synchrotron light has the second azimuthal mode
// (Palumbo, Wong and Prather 2020) of its field, counted from the picture's right as the angles are.
TEST_CASE("polarisation: discs seen face-on") {
    struct Mode {
        DiscField field;
        bool clockwise;
        double degrees;
    };
    constexpr Mode kModes[] = {{DiscField::kToroidal, false, 0},      {DiscField::kRadial, false, 199.949},
                               {DiscField::kVertical, false, 70.251}, {DiscField::kToroidal, true, 0},
                               {DiscField::kRadial, true, 160.051},   {DiscField::kVertical, true, 289.749}};
    on_one_context([&](GpuSession& session) {
        for (const Mode& mode : kModes) {
            Scene scene = polarised({"schwarzschild", {}}, Polarisation::kSynchrotron, mode.field);
            scene.disc->opacity = 0, scene.disc->brightness = 0, scene.light.delay = false;
            SpotSpec& spot = scene.spots.emplace_back();
            spot.r = 3, spot.size = 0.02, spot.count = 64;
            CameraSpec& camera = scene.camera;
            camera.r = 1e4, camera.theta = mode.clockwise ? M_PI : 0, camera.width = camera.height = 200;
            camera.plane_width = 9 / camera.r, camera.focal_distance = 1;
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> stokes = draw_layers(*session.renderer).stokes;
            std::complex<double> second, net;
            double all = 0;
            for (int y = 0; y < 200; ++y)
                for (int x = 0; x < 200; ++x) {
                    const float* light = stokes.at(x, y);
                    const double phi = std::atan2(99.5 - y, x - 99.5), r = std::hypot(99.5 - y, x - 99.5);
                    const std::complex<double> linear(light[1], light[2]);
                    net += linear, all += light[0];
                    if (r > 68) second += linear * std::polar(1.0, -2 * phi);  // the direct image
                }
            CAPTURE(mode.degrees);
            CHECK(std::abs(net) < 1e-5 * all);
            CHECK(std::abs(std::remainder(std::arg(second) / kTurnDegree - mode.degrees, 360)) < 0.05);
        }
    });
}

// A polariser lets half of unpolarised light through, of polarised light half of I + Q cos 2 psi + U sin 2 psi.
TEST_CASE("polarisation: pictures through a polariser") {
    on_one_context([&](GpuSession& session) {
        Scene scene = polarised({"kerr", {{"spin", 0.9}}}, Polarisation::kSynchrotron, DiscField::kRadial);
        scene.sky.kind = SkyKind::kPlain;
        scene.camera.r = 20, scene.camera.width = 160, scene.camera.height = 90, scene.camera.theta = 1.2;
        REQUIRE(session.renderer->prepare(scene));
        const PictureLayers plain = draw_layers(*session.renderer);
        double worst = 0, most = 0;
        for (const double axis : {0.0, 0.6, M_PI / 2}) {
            scene.picture.polariser = axis;
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> passed = session.renderer->picture();
            for (int y = 0; y < 90; ++y)
                for (int x = 0; x < 160; ++x) {
                    const auto luminance = [&](const float* p) {
                        return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
                    };
                    const float* light = plain.stokes.at(x, y);
                    const double expected =
                        0.5 * (light[0] + light[1] * std::cos(2 * axis) + light[2] * std::sin(2 * axis));
                    worst = std::max(worst, std::abs(luminance(passed.at(x, y)) - expected));
                    most = std::max(most, static_cast<double>(light[0]));
                }
        }
        fmt::print("through a polariser: light within {:.2g} of the brightest\n", worst / most);
        CHECK(worst < 1e-5 * most);
    });
}
