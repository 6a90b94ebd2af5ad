// Discs that are warped or have gaps, as the driver draws them: against the reference for random warps and cameras, and against flat discs.
#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "render/disc_warp_row.h"
#include "scene/disc_shape.h"
#include "sky/sky.h"
#include "support/draft.h"
#include "support/gpu_session.h"
#include "support/picture_off.h"
#include "support/places_off.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kWarpPlace_px = 0.02;  // of 1920 px of width

// Rows from the inner rim outward, each turned by up to `steepest` degrees from the one before.
DiscWarp random_warp(std::mt19937& random, const DiscSpec& disc, double steepest) {
    const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    DiscWarp warp;
    const int rows = 2 + static_cast<int>(random() % 5);
    double tilt = among(0, 60), node = among(-180, 180);
    for (int i = 0; i < rows; ++i) {
        warp.radii.push_back(disc.inner * std::pow(disc.outer / disc.inner, (i + among(0.1, 0.9)) / rows));
        const double apart = i == 0 ? 0.0 : std::log(warp.radii.back() / warp.radii[warp.radii.size() - 2]),
                     turn = std::min(steepest, 0.7 * kSteepestWarp * 180 / M_PI * apart);
        tilt = std::fabs(tilt + among(-turn, turn)), node += among(-turn, turn);
        warp.tilts_deg.push_back(tilt), warp.nodes_deg.push_back(node);
    }
    if (random() % 2 == 0) {
        const double ratio = disc.outer / disc.inner;
        for (const double share : {0.0, among(0.2, 0.4), among(0.5, 0.6), 1.0})
            warp.rings.push_back(share == 1.0 ? disc.outer : disc.inner * std::pow(ratio, share));
    }
    return warp;
}

Scene warp_scene(std::mt19937& random, int view) {
    const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Draft draft;
    if (view % 5 == 1) draft.metric("reissner-nordstrom", {{"charge", among(0.0, 1.0)}});
    if (view % 10 == 2) draft.metric("minkowski");
    draft.place(std::exp(among(1.0, 4.5)), std::acos(among(-0.99, 0.99))).size(8, 6);
    if (view % 7 == 3) draft.by(ObserverKind::kRain);
    const double whole = among(0.4, 1.6) * std::min(1.0, 25.0 / draft.scene.camera.r);
    draft.plane(whole * 8 / 1920).sky(SkyKind::kGrid);
    draft.disc(among(1.6, 4), among(6, 25));
    CameraSpec& camera = draft.scene.camera;
    camera.phi = among(-3, 3), camera.roll = among(-3, 3), camera.yaw = whole * among(-0.3, 0.3),
    camera.pitch = whole * among(-0.2, 0.2);
    DiscSpec& disc = *draft.scene.disc;
    disc.lean = {std::acos(among(-1, 1)), among(-3, 3), among(-0.1, 0.1)};
    disc.warp = random_warp(random, disc, 40);
    draft.scene.time = among(-20, 20);
    return draft;
}

// Next to the disc its places are closer together from pixel to pixel than floats: not there.
bool next_to_disc(const Scene& scene) {
    constexpr double kAbove = 0.1;
    const CameraSpec& camera = scene.camera;
    return std::fabs(dot(DiscShape(*scene.disc, scene.time).normal(camera.r),
                         world_from_static(camera.theta, camera.phi).a)) < kAbove;
}

TEST_CASE("disc warp: places of random warps and cameras are the reference's" * costly()) {
    on_one_context([](GpuSession& session) {
        const int views = by_depth(60, 300, 300);
        std::mt19937 random(55);
        PlacesOff off;
        for (int view = 0; view < views; ++view) {
            Scene scene = warp_scene(random, view);
            if (next_to_disc(scene)) scene.camera.r = std::max(scene.camera.r, 1.3 * scene.disc->outer);
            CAPTURE(view);
            off.add(session, scene, kWarpPlace_px);
        }
        off.check("disc warp", 10 * views);
    });
}

// Straight lines between its texels.
TEST_CASE("disc warp: the shader's table is its shape") {
    DiscSpec disc;
    disc.inner = 3, disc.outer = 20;
    disc.warp = {{4, 7, 9, 16}, {5, 20, 40, 30}, {0, 30, 60, 20}, {3, 8, 10, 20}};
    const DiscShape shape(disc, 3);
    const TexelGrid row = disc_warp_row(disc);
    REQUIRE(row.width == kDiscWarpCells + 1);
    const double from = std::log(disc.inner) - kDiscWarpBeside,
                 all = std::log(disc.outer / disc.inner) + 2 * kDiscWarpBeside;
    double most = 0;
    for (int i = 0; i < kDiscWarpCells; ++i) {
        const double r = std::exp(from + all * (i + 0.5) / kDiscWarpCells);
        const auto mean = [&](int k) {
            const auto at = static_cast<std::size_t>(4 * i + k);
            return 0.5 * (double(row.texels[at]) + double(row.texels[at + 4]));
        };
        most = std::max(most, length(Vec3{mean(0), mean(1), mean(2)} - shape.normal_in_base(r)));
    }
    fmt::print("disc warp: the table's normals within {:.1e}\n", most);
    CHECK(most < 4e-6);
}

Draft warm(double tilt_deg, double node_deg) {
    Draft draft = Draft{}.place(15, 1.2).plane(1.0).size(160, 96).at_time(30);
    draft.disc(3, 12).sky(SkyKind::kBlack);
    DiscSpec& disc = *draft.scene.disc;
    disc.lean = {tilt_deg * M_PI / 180, node_deg * M_PI / 180};
    disc.emission = DiscEmission::kThermal, disc.material.texture = TextureKind::kGas,
    disc.flow = DiscFlowKind::kKepler;
    disc.opacity = 0.8;
    return draft;
}

// A picture without the shadow's surroundings, where there are such rings.
Image<float> outside(Image<float> picture) {
    constexpr double kAround = 0.4;  // of the height
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (std::hypot(x + 0.5 - 0.5 * picture.width, y + 0.5 - 0.5 * picture.height) < kAround * picture.height)
                std::fill_n(picture.data.begin() + picture.channels * (y * picture.width + x), picture.channels, 0.0f);
    return picture;
}

// All of its light: late gas, shifts; but for rings thinner than a pixel, of which flat discs know how much they cover.
TEST_CASE("disc warp: equal rows are a disc that leans, all of its light") {
    on_one_context([](GpuSession& session) {
        const Draft one = warm(50, 35);
        Draft rows = warm(0, 0), wrong = warm(0, 0);
        rows.scene.disc->warp = {{3, 5, 12}, {50, 50, 50}, {35, 35, 35}, {}};
        wrong.scene.disc->warp = {{3, 5, 12}, {50, 50, 50}, {35, 36, 35}, {}};
        const Image<float> a = outside(picture_of(session, one)), b = outside(picture_of(session, rows)),
                           c = outside(picture_of(session, wrong));
        fmt::print("disc warp: equal rows are a leaning disc but for {:.1e} of its light; a degree beside {:.1e}\n",
                   light_off(a, b), light_off(a, c));
        CHECK(light_off(a, b) < 1e-4);
        CHECK(light_off(a, c) > 0.01);
    });
}

}  // namespace
