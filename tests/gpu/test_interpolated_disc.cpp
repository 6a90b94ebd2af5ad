// Where interpolated rays cross a disc about a rotating hole (shaders/stage/disc_fit.glsl), against the crossings of traced ones.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "plan/effects.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;

// DISC_FIT_ERROR is 0.004 px by what is known of a tile.
constexpr double kToldPlace_px = 0.01;     // 0.0039 measured
constexpr double kToldDelay = 2.0e-4;      // r_s/c: what light and matter need for a hundredth of such a pixel
constexpr double kDelayRounding = 2.0e-7;  // of ray data, which are floats
constexpr double kBesideRim = 1.0e-2;      // r_s: nearer to a rim a ray may meet the disc and an interpolated one not

struct PlaceErrors {
    long long told = 0, all = 0,
              lost = 0;  // pixels; lost: of rays that do not meet the disc where it is told that they do
    double worst_px = 0, delay = 0;
};

// An opaque disc, so that ray data have its first crossing.
Scene opaque_disc(const std::string& name, int width, int height) {
    Scene scene = *load_scene(name);
    scene.picture.refine = false;
    scene.camera.width = width, scene.camera.height = height;
    scene.disc->opacity = 1, scene.disc->edge = 0;
    return scene;
}

// The larger part of an error of a place, in pixels to the right and upward.
double in_pixels(const RayFrame& rays, int x, int y, double dx, double dy) {
    const RayPixel &here = rays.at(x, y), &right = rays.at(x + 1, y), &below = rays.at(x, y + 1);
    const double rx = right.u - here.u, ry = right.v - here.v, bx = below.u - here.u, by = below.v - here.v,
                 area = std::abs(rx * by - ry * bx);
    return std::max(std::abs(dx * by - dy * bx), std::abs(dx * ry - dy * rx)) / area;
}

void measure(Renderer& renderer, const DiscSpec& disc, double camera_r, PlaceErrors& errors) {
    const RayFrame rays = renderer.ray_data();
    const Image<float> told = renderer.interpolated_places();
    for (int y = 0; y + 1 < rays.height; ++y)
        for (int x = 0; x + 1 < rays.width; ++x) {
            ++errors.all;
            const float* place = told.at(x, y);
            if (place[3] == 0) continue;
            ++errors.told;
            const double r = std::hypot(place[0], place[1]);
            if (r < disc.inner + kBesideRim || r > disc.outer - kBesideRim) continue;
            const RayPixel& ray = rays.at(x, y);
            if (ray.hit == 0) {
                ++errors.lost;
                continue;
            }
            if (ray.delay != 0) {  // told less the camera's radius
                const double late = std::abs(place[2] + camera_r - ray.delay) - kDelayRounding * ray.delay;
                errors.delay = std::max(errors.delay, late);
            }
            if (rays.at(x + 1, y).hit == 0 || rays.at(x, y + 1).hit == 0 || told.at(x + 1, y)[3] != place[3] ||
                told.at(x, y + 1)[3] != place[3])
                continue;
            errors.worst_px = std::max(errors.worst_px, in_pixels(rays, x, y, place[0] - ray.u, place[1] - ray.v));
        }
}

TEST_CASE("interpolated disc: places are those of traced rays" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    Renderer& renderer = *session->renderer;
    const int poses = test::by_depth(2, 8, 24);
    test::Selection selection(3);
    int scenes = 0;
    for (const SceneInfo& info : shipped_scenes()) {
        const Scene shipped = *load_scene(info.name);
        if (!shipped.disc || !interpolates_disc(effect_set(required_effects(shipped))) || !selection.takes_next())
            continue;
        const Scene scene = opaque_disc(info.name, 643, 363);
        ++scenes;
        std::mt19937 random(3);
        PlaceErrors errors;
        for (int i = 0; i <= poses; ++i) {
            const Scene pose = i == 0 ? scene : test::seen_from_elsewhere(scene, random, 0.6, 0.4);
            if (!renderer.prepare(pose)) continue;
            renderer.limit_tiles(Tiles::kInterpolated);
            measure(renderer, *pose.disc, pose.camera.r, errors);
        }
        fmt::print("interpolated disc, {:<14} {:.1f} % of the pixels, {:.4f} px at most, delay {:.1e} r_s, {} lost\n",
                   info.name, 100.0 * static_cast<double>(errors.told) / static_cast<double>(errors.all),
                   errors.worst_px, errors.delay, errors.lost);
        CAPTURE(info.name);
        CHECK(errors.told > 0);
        CHECK(errors.worst_px <= kToldPlace_px);
        CHECK(errors.delay <= kToldDelay);
        CHECK(errors.lost == 0);
    }
    CHECK(scenes >= 2);
}

// Of a picture with interpolated rays against one with traced ones.
struct ToldLight {
    long long told = 0, off = 0;
    double sum = 0, all = 0;
};

constexpr float kFarOff = 1.0e-2f;  // of the brightest
constexpr double kPixelsOff =
    1.0e-4;  // gas is looked at along the other side of a footprint whose sides are as long: 4e-6 measured
constexpr double kMeanOff = 3.0e-3;  // of the mean; 1.3e-3 measured, where a pixel is 0.3 degrees

void measure_light(Renderer& renderer, ToldLight& errors) {
    renderer.limit_tiles(Tiles::kInterpolated);
    const Image<float> picture = renderer.picture(), told = renderer.interpolated_places();
    renderer.limit_tiles(Tiles::kTraced);
    const Image<float> traced = renderer.picture();
    float brightest = 0;
    for (int y = 0; y < traced.height; ++y)
        for (int x = 0; x < traced.width; ++x) brightest = std::max(brightest, traced.at(x, y)[1]);
    for (int y = 0; y < traced.height; ++y)
        for (int x = 0; x < traced.width; ++x) {
            if (told.at(x, y)[3] == 0) continue;
            const float off = std::fabs(picture.at(x, y)[1] - traced.at(x, y)[1]);
            ++errors.told;
            errors.off += !(off <= kFarOff * brightest);
            errors.sum += off, errors.all += traced.at(x, y)[1];
        }
}

void check_light(Renderer& renderer, const std::string& name, const Scene& scene, int poses) {
    std::mt19937 random(2);
    ToldLight errors;
    for (int i = 0; i <= poses; ++i) {
        const Scene pose = i == 0 ? scene : test::seen_from_elsewhere(scene, random, 0.6, 0.4);
        if (renderer.prepare(pose)) measure_light(renderer, errors);
    }
    const double off = static_cast<double>(errors.off) / static_cast<double>(errors.told),
                 mean = errors.sum / errors.all;
    fmt::print(
        "interpolated disc, {:<14} light: {:.1e} of the pixels off by more than {} of the brightest, mean {:.1e}\n",
        name, off, kFarOff, mean);
    CAPTURE(name);
    CHECK(errors.told > 0);
    CHECK(off <= kPixelsOff);
    CHECK(mean <= kMeanOff);
}

TEST_CASE("interpolated disc: light is that of traced rays" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    const int poses = test::by_depth(1, 4, 8);
    test::Selection selection(3);
    for (const SceneInfo& info : shipped_scenes()) {
        Scene scene = *load_scene(info.name);
        if (!scene.disc || !interpolates_disc(effect_set(required_effects(scene))) || !selection.takes_next()) continue;
        scene.picture.refine = false;
        scene.camera.width = 643, scene.camera.height = 363;
        check_light(*session->renderer, info.name, scene, poses);
    }
}

TEST_CASE("interpolated disc: light of gas that falls inward, and the sky beside the rims of an opaque disc" *
          test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    const int poses = test::by_depth(1, 4, 8);
    Scene scene = *load_scene("kerr");
    scene.picture.refine = false;
    scene.camera.width = 643, scene.camera.height = 363;
    scene.disc->material.texture = TextureKind::kPlain;
    scene.disc->opacity = 1, scene.disc->edge = 0;
    Scene falling = scene;
    falling.spacetime.parameters["spin"] = 0.1;
    falling.camera.theta = 0.5, falling.camera.r = 9;
    falling.disc->inner = 1.2, falling.disc->outer = 3.2;  // most of it within the last stable orbit
    falling.disc->emissivity.by = Emissivity::kPowerLaw, falling.disc->effects.limb_darkening = true;
    check_light(*session->renderer, "falling gas", falling, poses);
    scene.camera.theta = 0.8;
    scene.disc->inner = 2.2, scene.disc->outer = 4.5, scene.disc->brightness = 0.3;
    check_light(*session->renderer, "rims", scene, poses);
}

}  // namespace
