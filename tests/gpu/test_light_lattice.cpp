// The light of matter between the nodes of lattices of the picture (shaders/stage/lattice.glsl) is that of the pixels' own rays.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "plan/effects.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"
#include "support/paired_cost.h"
#include "support/picture_off.h"

namespace {

using namespace nullscope;

Scene sized(Scene scene, int width, int height) {
    scene.picture.refine = false;  // one ray a pixel
    scene.camera.width = width, scene.camera.height = height;
    return scene;
}

Image<float> by(Renderer& renderer, Tiles most) {
    renderer.limit_tiles(most);
    return renderer.picture();
}

// Of the brightest light; flux: of all light's red; told: pixels whose light is not to the bit that of their own rays.
struct LightErrors {
    double most = 0, most_of_999 = 0, flux = 0, told = 0;
};
LightErrors errors(const Image<float>& picture, const Image<float>& exact) {
    std::vector<double> off;
    double brightest = 0;
    for (int y = 0; y < exact.height; ++y)
        for (int x = 0; x < exact.width; ++x)
            for (int k = 0; k < 3; ++k) {
                off.push_back(std::fabs(static_cast<double>(picture.at(x, y)[k]) - exact.at(x, y)[k]));
                brightest = std::max(brightest, static_cast<double>(exact.at(x, y)[k]));
            }
    std::ranges::sort(off);
    const double flux = test::sum_of(exact);
    return {off.back() / brightest, off[off.size() * 999 / 1000] / brightest,
            std::fabs(test::sum_of(picture) - flux) / flux,
            static_cast<double>(std::ranges::count_if(off, [](double one) { return one > 0; })) /
                static_cast<double>(off.size())};
}

struct Bounds {
    double most, most_of_999, flux;
};
// A cell is told to 0.5 % of its own light at one place in it and in four beside it.
constexpr Bounds kSmooth = {0.03, 0.004, 3e-4};  // measured: 0.022 (an edge), 0.0037, 2.2e-4
// With a limb that is a square root, and waves, which are in step with a cell's nodes and its place now and then. Measured: 0.024, 0.0042, 1e-3. Where
// that place is the middle of each cell: 0.45, 0.45, 5e-3.
constexpr Bounds kWaves = {0.05, 0.006, 2e-3};

LightErrors check_light(Renderer& renderer, const std::string& name, const Scene& scene, const Bounds& bounds) {
    if (!renderer.prepare(scene)) return {};  // where no frame is at rest
    const LightErrors found = errors(by(renderer, Tiles::kInterpolated), by(renderer, Tiles::kTraced));
    fmt::print("lattice, {:<16} of the brightest light: {:.5f} at most, 99.9 %: {:.5f}; flux {:.1e}; told {:.0f} %\n",
               name, found.most, found.most_of_999, found.flux, 100 * found.told);
    CAPTURE(name);
    CHECK(found.most <= bounds.most);
    CHECK(found.most_of_999 <= bounds.most_of_999);
    CHECK(found.flux <= bounds.flux);
    return found;
}

TEST_CASE("lattice: light between its nodes is that of the pixels' rays" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    const int width = test::by_depth(320, 1280, 1280), poses = test::by_depth(0, 2, 8);
    int scenes = 0;
    std::mt19937 random(5);
    test::Selection selection(2);
    for (const SceneInfo& info : shipped_scenes()) {
        const Scene scene = sized(*load_scene(info.name), width, width * 9 / 16);
        if (!interpolates_matter(effect_set(required_effects(scene)))) continue;
        if (test::depth() == test::Depth::kQuick && !selection.takes_next()) continue;
        ++scenes;
        const double view = scene.camera.width * scene.camera.pixel();
        CHECK(check_light(*session->renderer, info.name, scene, kSmooth).told > 0.2);
        for (int i = 0; i < poses; ++i)
            check_light(*session->renderer, info.name,
                        sized(test::seen_from_elsewhere(scene, random, 0.3 * view, 0), width / 2, width * 9 / 32),
                        kSmooth);
    }
    CHECK(scenes >= test::by_depth(1, 4, 4));
}

// A ball of matter in flat space, whose light has a wave a few pixels long.
Scene waves(double px) {
    Scene scene = *parse_scene(R"(
        [spacetime]
        metric = "minkowski"
        [camera]
        r = 10
        theta = 70
        fov = 14
        [sky]
        kind = "black"
        [object]
        mass_suns = 4.3e6
        [medium]
        kind = "formula"
        emission = "power-law"
        outer = 1
        steps = 64
    )",
                               "waves.toml", ".");
    scene = sized(std::move(scene), 200, 200);
    scene.medium->formulas.density = fmt::format("1 + 0.9*sin({}*y)", 2 * M_PI / (px * 10 * scene.camera.pixel()));
    return scene;
}

TEST_CASE("lattice: what is finer than its nodes lie is not lost between them") {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    for (const double px : {2.1, 3.9, 4.0, 8.0, 16.0, 31.0})
        check_light(*session->renderer, fmt::format("waves of {} px", px), waves(px), kWaves);
    CHECK(check_light(*session->renderer, "waves of 400 px", waves(400), kWaves).told > 0.3);
}

TEST_CASE("lattice: a picture drawn in pieces is the picture, with more rays at edges too" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    constexpr int kWidth = 190, kHeight = 108;
    Scene scene = sized(*load_scene("hot-flow"), kWidth, kHeight);
    scene.picture.refine = true;
    Renderer& renderer = *session->renderer;
    REQUIRE(renderer.prepare(scene));
    renderer.limit_tiles(Tiles::kTraced);
    const Image<unsigned char> traced = renderer.picture8();
    renderer.limit_tiles(Tiles::kInterpolated);
    const Image<unsigned char> whole = renderer.picture8();
    CHECK(
        test::off_between(test::drawn_in_pieces(renderer, kWidth, kHeight, {0, 8, 33, 34, 64, kHeight}), whole).most ==
        0);
    constexpr int kSeen = 3;          // of 255
    constexpr double kAtEdge = 5e-3;  // of all values: at the shadow's edge, of 16 rays in place of 36
    int others = 0;
    for (std::size_t i = 0; i < whole.data.size(); ++i) others += std::abs(whole.data[i] - traced.data[i]) > kSeen;
    CHECK(others <= kAtEdge * 3 * kWidth * kHeight);
}

// Of pictures in motion. Measured: 0.35 (next to the shadow's edge) and 0.48 (of grid-torus, there too), 0.043, 4.6e-3.
constexpr Bounds kDraft = {0.5, 0.05, 0.01};

TEST_CASE("lattice: pictures in motion follow fewer rays, and those at rest are what they were" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    Renderer& renderer = *session->renderer;
    for (const char* name : {"hot-flow", "m87-synchrotron", "grid-torus"}) {
        const Scene scene = sized(*load_scene(name), 480, 270);
        const LightErrors rest = check_light(renderer, name, scene, kSmooth);
        const Image<float> before = by(renderer, Tiles::kInterpolated);
        renderer.draft(true);
        const LightErrors motion = check_light(renderer, name, scene, kDraft);
        renderer.draft(false);
        const Image<float> after = by(renderer, Tiles::kInterpolated);
        CHECK(motion.told > rest.told + 0.02);
        CHECK(motion.most_of_999 > rest.most_of_999);
        CHECK(before.data == after.data);
    }
}

TEST_CASE("lattice: smooth matter costs a fraction of its rays" * test::costly()) {
    constexpr double kLeast = 2.5;  // of hot-flow at this size: 5.0 measured
    const auto cost = [] {
        auto session = test::open_gpu("egl");
        REQUIRE(session);
        Renderer& renderer = *session->renderer;
        REQUIRE(renderer.prepare(sized(*load_scene("hot-flow"), 640, 360)));
        const gl::Target target = gl::make_target(640, 360, gl::Format::kRgba8);
        const auto draw = [&](Tiles most) {
            renderer.limit_tiles(most);
            renderer.draw(target.framebuffer.id(), 640, 360, Output::kDisplay);
        };
        draw(Tiles::kInterpolated), draw(Tiles::kTraced);
        const test::PairedCost found = test::paired_cost(
            5, [&] { draw(Tiles::kInterpolated); }, [&] { draw(Tiles::kTraced); });
        fmt::print("by lattices and by rays: {:.4f} and {:.4f} core-s, ratio {:.3f} ({:.3f} to {:.3f})\n",
                   found.first_s, found.second_s, found.ratio, found.low, found.high);
        return found;
    };
    CHECK(test::within(1 / kLeast, cost).low <= 1 / kLeast);
}

}  // namespace
