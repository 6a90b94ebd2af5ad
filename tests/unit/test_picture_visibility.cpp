// Visibilities of a disc with their derivatives (gradient/picture_visibility.h) against sums over the reference's pixels, against differences of themselves, and
// closed forms of turns.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "changed_scene.h"
#include "gradient/picture_visibility.h"
#include "known_light.h"
#include "scene/projection.h"
#include "support/costly.h"
#include "support/depth.h"

namespace {

using namespace nullscope;
using test::change_scene;
using Complex = std::complex<double>;

constexpr int kAcross = 64;  // px

// A transparent ring about a hole of spin 0.7, whose disc is 40 px wide.
Scene ring_scene() {
    Scene scene;
    scene.spacetime = {"kerr", MetricParameters({{"spin", 0.7}})};
    scene.sky.kind = SkyKind::kBlack;
    CameraSpec& camera = scene.camera;
    camera.r = 500, camera.theta = 50 * M_PI / 180;
    camera.width = camera.height = kAcross;
    set_field_of_view(camera, 2 * std::atan(12.0 / 500));
    DiscSpec disc;
    disc.inner = 2, disc.outer = 7, disc.edge = 0.4, disc.opacity = 0.001;
    disc.emission = DiscEmission::kThermal, disc.temperature_K = 5000;
    disc.material.texture = TextureKind::kPlain;
    disc.emissivity.by = Emissivity::kPowerLaw;
    scene.disc = disc;
    scene.light.bolometric = true;
    return scene;
}

// Up to twelve fringes across the picture, in some directions.
std::vector<Fringes> some_fringes() {
    std::vector<Fringes> fringes;
    for (int i = 0; i < 24; ++i) {
        const double wave = 2 * M_PI * 12 / kAcross * (i + 1) / 24, turn = 2.4 * i;
        fringes.push_back({wave * std::cos(turn), wave * std::sin(turn)});
    }
    return fringes;
}

// As many spokes for values as for derivatives.
constexpr VisibilityRule kRule{12, 0.01};

VisibilityGradient found_of(const Scene& scene, const std::vector<std::string>& keys,
                            const std::vector<Fringes>& fringes) {
    const auto light = PictureLight::make(scene, keys, 1e-6);
    REQUIRE_MESSAGE(light, (light ? "" : light.error().message()));
    auto found = visibility_gradient(**light, fringes, kRule);
    REQUIRE_MESSAGE(found, (found ? "" : found.error().message()));
    return std::move(*found);
}

double size_of(const VisibilityGradient::Sums& sums) {
    double sum = 0;
    for (const Complex& one : sums) sum += std::norm(one);
    return std::sqrt(sum / static_cast<double>(sums.size()));
}

double luminance_of(const Vec3& light) {
    return 0.2126390059 * light.x + 0.7151686788 * light.y + 0.0721923154 * light.z;
}

// Sums over places of a picture leave out how the thin images lie between them: less so the more places there are.
constexpr double kOfPlaces = 3e-3;

TEST_CASE("picture visibility: as sums over the reference's rays have it") {
    const Scene scene = ring_scene();
    const std::vector<Fringes> fringes = some_fringes();
    const VisibilityGradient found = found_of(scene, {}, fringes);
    const test::KnownLight light(scene);
    const int across = test::by_depth(2, 4, 8);
    VisibilityGradient::Sums sums(fringes.size());
    double all = 0;
    for (int row = 0; row < kAcross * across; ++row)
        for (int column = 0; column < kAcross * across; ++column) {
            const double x = (column + 0.5) / across, y = (row + 0.5) / across;
            const double there = luminance_of(light.at(x, y)) / (across * across);
            all += there;
            for (std::size_t i = 0; i < fringes.size(); ++i)
                sums[i] +=
                    std::polar(there, fringes[i].right * (x - 0.5 * kAcross) + fringes[i].down * (y - 0.5 * kAcross));
        }
    double worst = 0;
    for (std::size_t i = 0; i < fringes.size(); ++i) worst = std::max(worst, std::abs(found.value[i] - sums[i]) / all);
    MESSAGE(fmt::format(
        "flux {:.9g}, by {} x {} rays a pixel {:.9g}; visibilities within {:.2g} of it; {} rays, error {:.2g}",
        found.flux, across, across, all, worst, found.rays, found.error));
    CHECK(std::fabs(found.flux / all - 1) < kOfPlaces);
    CHECK(worst < kOfPlaces);
}

constexpr double kSameSlope =
    2e-3;  // of a derivative's root mean square: what a quadrature of 12 places a piece is off by

TEST_CASE("picture visibility: derivatives are those of its values") {
    const Scene scene = ring_scene();
    const std::vector<Fringes> fringes = some_fringes();
    std::vector<std::string> keys = {"spin"};
    if (test::depth() != test::Depth::kQuick)
        for (const char* key : {"camera.theta", "camera.r", "camera.yaw", "camera.pitch", "camera.fov", "disc.inner",
                                "disc.outer", "disc.powers", "disc.opacity"})
            keys.emplace_back(key);
    const VisibilityGradient found = found_of(scene, keys, fringes);
    const auto light = PictureLight::make(scene, keys);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const ParameterKind kind = (*light)->keys()[k].kind;
        const double size = size_of(found.by[k]), step = 3e-3 * size_of(found.value) / size;
        VisibilityGradient::Sums there[2];
        for (const int side : {0, 1}) {
            Scene other = scene;
            change_scene(kind, (side == 0 ? -step : step), other);
            there[side] = found_of(other, {}, fringes).value;
        }
        double off = 0;
        for (std::size_t i = 0; i < fringes.size(); ++i)
            off += std::norm(found.by[k][i] - (there[1][i] - there[0][i]) / (2 * step)) /
                   static_cast<double>(fringes.size());
        MESSAGE(fmt::format("{}: rms {:.6g}, off by {:.2g} of it", keys[k], size, std::sqrt(off) / size));
        CHECK(std::sqrt(off) < kSameSlope * size);
    }
}

constexpr double kTurned =
    2e-3;  // of the light: a step changes phases by up to 0.07 rad, whose third power differences leave out

TEST_CASE("picture visibility: rolls turn fringes, scales stretch them" * test::costly()) {
    const Scene scene = ring_scene();
    const std::vector<Fringes> fringes = some_fringes();
    const VisibilityGradient found = found_of(scene, {"camera.roll"}, fringes);
    constexpr double kStep = 3e-3;
    std::vector<Fringes> moved;
    for (const Fringes& one : fringes)
        for (const double step : {-kStep, kStep}) moved.push_back({one.right * (1 + step), one.down * (1 + step)});
    // A camera that rolls clockwise turns its picture the other way.
    for (const Fringes& one : fringes)
        for (const double step : {-kStep, kStep})
            moved.push_back({one.right * std::cos(step) - one.down * std::sin(step),
                             one.right * std::sin(step) + one.down * std::cos(step)});
    const VisibilityGradient there = found_of(scene, {}, moved);
    double off_scale = 0, off_roll = 0;
    for (std::size_t i = 0; i < fringes.size(); ++i) {
        const std::size_t n = 2 * i, m = 2 * (fringes.size() + i);
        off_scale =
            std::max(off_scale, std::abs(found.by_scale[i] - (there.value[n + 1] - there.value[n]) / (2 * kStep)));
        off_roll = std::max(off_roll, std::abs(found.by[0][i] - (there.value[m + 1] - there.value[m]) / (2 * kStep)));
    }
    MESSAGE(
        fmt::format("scale off by {:.2g}, roll by {:.2g} of the light", off_scale / found.flux, off_roll / found.flux));
    CHECK(off_scale < kTurned * found.flux);
    CHECK(off_roll < kTurned * found.flux);
}

TEST_CASE("picture visibility: what has none is told") {
    const auto refused = [](void (*change)(Scene&), const char* what) {
        Scene scene = ring_scene();
        change(scene);
        const auto light = PictureLight::make(scene, {"spin"}, 1e-6);
        REQUIRE(light);
        const auto found = visibility_gradient(**light, some_fringes());
        REQUIRE(!found);
        CHECK(found.error().message().find(what) != std::string::npos);
    };
    refused([](Scene& s) { s.disc->opacity = 1; }, "not rings");
    refused([](Scene& s) { set_field_of_view(s.camera, 2 * std::atan(5.0 / 500)); }, "whole");
    refused([](Scene& s) { s.camera.yaw = 0.5; }, "direction to the centre");
}

}  // namespace
