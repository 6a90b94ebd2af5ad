// What a picture costs that is drawn in bands of rows, as the viewer does, over one that is drawn at once.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "scenefile/scene_file.h"
#include "studio/bands.h"
#include "support/gpu_session.h"
#include "support/paired_cost.h"

namespace {

using namespace nullscope;

constexpr int kBandedWidth = 1280,
              kBandedHeight = 96;  // rows as wide as the viewer's window; their number does not matter

constexpr double kMost = 1.1;  // issue: "a viewer's frame at most 1.1 times the bench's"
// The smallest bands, of pictures that take 3 s and more: not that of a row, which takes as long as four.
constexpr double kMostSmall = 1.3;

// Of so many rows.
struct Bands {
    const char* scene = "torus";
    bool refined = false;
    int rows = 0;
    Tiles tiles = Tiles::kBodies;
};

// A picture in bands over one that is drawn at once.
test::PairedCost cost_of_bands(int pairs, const Bands& bands) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    Scene scene = *load_scene(bands.scene);
    scene.camera.width = kBandedWidth, scene.camera.height = kBandedHeight;
    Renderer& renderer = *session->renderer;
    renderer.refine(bands.refined);
    renderer.limit_tiles(bands.tiles);
    REQUIRE(renderer.prepare(scene));
    const gl::Target target = gl::make_target(kBandedWidth, kBandedHeight, gl::Format::kRgba8);
    const auto whole = [&] { renderer.draw(target.framebuffer.id(), kBandedWidth, kBandedHeight, Output::kDisplay); };
    whole();
    const auto in_bands = [&] {
        for (int first = 0; first < kBandedHeight; first += bands.rows) {
            renderer.draw_rows(target.framebuffer.id(), kBandedWidth, kBandedHeight, Output::kDisplay, first,
                               std::min(first + bands.rows, kBandedHeight));
            gl::finish();
        }
    };
    const test::PairedCost cost = test::paired_cost(pairs, in_bands, whole);
    fmt::print("{}: bands of {} rows, {}: {:.4f} core-s, the whole {:.4f}, ratio {:.3f} ({:.3f} to {:.3f})\n",
               bands.scene, bands.rows, bands.refined ? "edges refined" : "in flight", cost.first_s, cost.second_s,
               cost.ratio, cost.low, cost.high);
    return cost;
}

TEST_CASE("bands: a picture in bands costs little more than the whole" * test::costly()) {
    const int pairs = test::by_depth(5, 11, 21);
    for (const bool refined : {false, true})
        for (const auto& [rows, bound] : {std::pair{viewer::kFirstRows, kMost}, {viewer::kBlockRows, kMostSmall}})
            CHECK(test::within(bound, [&, rows = rows] {
                      return cost_of_bands(pairs, {.refined = refined, .rows = rows});
                  }).low <= bound);
    CHECK(cost_of_bands(pairs, {.rows = 1}).ratio > kMostSmall);  // that the check can fail
}

// Lattices whose rows ended with each band's: 1.30.
TEST_CASE("bands: lattices of matter's light are drawn ahead of them" * test::costly()) {
    const Bands bands{.scene = "hot-flow", .rows = viewer::kFirstRows, .tiles = Tiles::kInterpolated};
    CHECK(test::within(kMost, [&] { return cost_of_bands(test::by_depth(5, 11, 21), bands); }).low <= kMost);
}

}  // namespace
