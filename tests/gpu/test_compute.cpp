// Pictures and rays by compute shaders are those by fragment shaders: the same functions of the same text.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "command/ray_trace.h"
#include "gl/compute.h"
#include "plan/effects.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"
#include "support/costly.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;

struct Differences {
    long long values = 0, bits = 0;  // those whose bits differ
    float most = 0.0f, brightest = 0.0f;
    std::string places;  // of the first few
};

Differences differences(const Image<float>& a, const Image<float>& b) {
    Differences found;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int k = 0; k < 3; ++k, ++found.values) {
                const float by_fragment = a.at(x, y)[k], by_compute = b.at(x, y)[k];
                found.brightest = std::max(found.brightest, by_fragment);
                if (std::bit_cast<std::uint32_t>(by_fragment) == std::bit_cast<std::uint32_t>(by_compute)) continue;
                const float off = std::fabs(by_fragment - by_compute);
                found.most = std::isnan(off) ? INFINITY : std::max(found.most, off);
                if (++found.bits <= 5) found.places += fmt::format(" ({}, {})", x, y);
            }
    return found;
}

bool compares() {
    if (!gl::computes()) MESSAGE("this OpenGL is older than 4.3: nothing to compare");
    return gl::computes();
}

// Neighbours' differences are taken where rays are integrated, or found as an angle.
bool takes_differences(const EffectSet& effects) { return light_path_kind(effects) == LightPathKind::kMino; }

Scene thumbnail(const std::string& name) {
    Scene scene = *load_scene(name);
    scene.camera.width = 96, scene.camera.height = 54;
    return scene;
}

void check_same(const Differences& found, bool differences_taken, const std::string& name) {
    fmt::print("compute, {:<18} {} of {} values have other bits, by {:.1e} of the brightest at most{}\n", name,
               found.bits, found.values, found.most / std::max(found.brightest, 1e-30f), found.places);
    CAPTURE(name);
    CHECK(found.values > 0);
    if (differences_taken)
        CHECK(found.most <= 1e-6f * found.brightest);
    else
        CHECK(found.bits == 0);
}

TEST_CASE("compute: every scene that ships is the same picture by both stages" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    if (!compares()) return;
    Renderer& renderer = *session->renderer;
    int scenes = 0, computed = 0;
    test::Selection selection(10);
    for (const SceneInfo& info : shipped_scenes()) {
        if (!selection.takes_next()) continue;
        const Scene scene = thumbnail(info.name);
        REQUIRE(renderer.prepare(scene));
        renderer.compute(false);
        const Image<float> by_fragments = renderer.picture();
        const int before = renderer.computed().drawn();
        renderer.compute(true);
        const Image<float> by_compute = renderer.picture();
        CHECK_MESSAGE(renderer.computed().refusal().empty(), renderer.computed().refusal());
        computed += renderer.computed().drawn() > before ? 1 : 0;
        ++scenes;
        check_same(differences(by_fragments, by_compute), takes_differences(effect_set(required_effects(scene))),
                   info.name);
    }
    CHECK(scenes >= test::by_depth(6, 60, 60));
    CHECK(computed == scenes);
}

// Display encoding, samples that are added up, layers, rows drawn in pieces, methods that find an angle.
TEST_CASE("compute: whatever is drawn of a scene is the same by both stages" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    if (!compares()) return;
    Renderer& renderer = *session->renderer;
    for (const char* name : {"first-light", "kerr", "saturn"}) {
        CAPTURE(std::string(name));
        Scene scene = thumbnail(name);
        scene.picture.refine = false;
        const auto both = [&](auto draw) {
            renderer.compute(false);
            const auto by_fragments = draw();
            renderer.compute(true);
            const int before = renderer.computed().drawn();
            CHECK(draw().data == by_fragments.data);
            CHECK(renderer.computed().drawn() > before);
        };
        REQUIRE(renderer.prepare(scene));
        both([&] { return renderer.picture8(); });
        both([&] { return test::drawn_in_pieces(renderer, 96, 54, {0, 5, 21, 54}); });
        both([&] { return renderer.layer(PictureLayer::kSky); });
        renderer.limit_tiles(Tiles::kTraced);
        both([&] { return renderer.picture(); });
        renderer.limit_tiles(Tiles::kBodies);
        scene.picture.samples = 5;
        REQUIRE(renderer.prepare(scene));
        both([&] { return renderer.picture(); });
        renderer.compute(false);
        const RayFrame by_fragments = renderer.ray_data();
        renderer.compute(true);
        const int before = renderer.computed().drawn();
        const RayFrame by_compute = renderer.ray_data();
        CHECK(renderer.computed().drawn() == before + 1);
        bool same = true;
        for (std::size_t i = 0; i < by_fragments.pixels.size(); ++i) {
            const RayPixel &a = by_fragments.pixels[i], &b = by_compute.pixels[i];
            same = same && a.fate == b.fate && a.sky.x == b.sky.x && a.sky.y == b.sky.y && a.sky.z == b.sky.z &&
                   a.g == b.g && a.angle == b.angle && a.hit == b.hit && a.u == b.u && a.v == b.v && a.w == b.w;
        }
        CHECK(same);
    }
    Scene scene = thumbnail("sky-only");
    scene.picture.refine = false;
    for (const char* method : {"closed-form", "integrate", "table"}) {
        renderer.set_method(*parse_method(method));
        REQUIRE(renderer.prepare(scene));
        renderer.compute(false);
        const Image<float> by_fragments = renderer.picture();
        renderer.compute(true);
        check_same(differences(by_fragments, renderer.picture()), true, method);
    }
}

// Lattices of matter and interpolated rays: at rest and in motion, in one go and in pieces; the rays through the corners of tiles too.
TEST_CASE("compute: interpolated light and rays are the same by both stages" * test::costly()) {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    if (!compares()) return;
    Renderer& renderer = *session->renderer;
    renderer.limit_tiles(Tiles::kInterpolated);
    test::Selection selection(3);
    for (const char* name : {"soft-disc", "kerr", "m87-synchrotron", "hot-flow", "swarm", "first-light"}) {
        if (!selection.takes_next()) continue;
        Scene scene = thumbnail(name);
        scene.picture.refine = false;
        if (!scene.medium && scene.bodies.empty())
            scene.camera.width *= 5, scene.camera.height *= 5;  // smooth within a tile, or full of disc
        const int width = scene.camera.width, height = scene.camera.height;
        REQUIRE(renderer.prepare(scene));
        const EffectSet effects = effect_set(required_effects(scene));
        for (const bool draft : {false, true}) {
            renderer.draft(draft);
            renderer.compute(true);  // first: textures of tiles and nodes hold what was drawn before
            const int before = renderer.computed().drawn();
            const Image<float> by_compute = renderer.picture();
            CHECK(renderer.computed().drawn() >= before + 3);  // tiles or nodes; the picture in two kinds of tiles
            CHECK_MESSAGE(renderer.computed().refusal().empty(), renderer.computed().refusal());
            const Image<unsigned char> in_pieces = test::drawn_in_pieces(renderer, width, height, {0, 8, 24, height});
            CHECK(in_pieces.data == renderer.picture8().data);
            const Image<float> rays = renderer.interpolated_rays();
            renderer.compute(false);
            CHECK(rays.data == renderer.interpolated_rays().data);
            // Their last numbers: rays to the sky.
            if (interpolates(effects)) CHECK(std::ranges::count(rays.data, 1.0f) > width * height / 20);
            check_same(differences(renderer.picture(), by_compute), takes_differences(effects), name);
        }
        renderer.draft(false);
    }
}

// In tiles of each kind, and without; of 4, 16 and 36 rays.
TEST_CASE("compute: pixels with more rays are the same by both stages") {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    if (!compares()) return;
    Renderer& renderer = *session->renderer;
    test::Selection selection(3);  // programs of the second take 10 s to compile
    for (const char* name : {"first-light", "kerr-planet", "saturn", "soft-disc"}) {
        if (!selection.takes_next()) continue;
        const Scene scene = thumbnail(name);
        REQUIRE(renderer.prepare(scene));
        const Tiles most = scene.medium ? Tiles::kInterpolated : Tiles::kTraced;  // tiles by a lattice
        for (const Tiles tiles : {Tiles::kNone, most}) {
            renderer.limit_tiles(tiles);
            renderer.compute(true, false);
            const int first = renderer.computed().drawn();
            const Image<float> by_fragments = renderer.picture();
            const int whole = renderer.computed().drawn() - first;
            renderer.compute(true, true);
            const Image<float> by_compute = renderer.picture();
            CHECK(renderer.computed().drawn() - first > 2 * whole);
            CHECK(renderer.refined_share() > 0.02);
            check_same(differences(by_fragments, by_compute), takes_differences(effect_set(required_effects(scene))),
                       name);
        }
        renderer.limit_tiles(Tiles::kBodies);
    }
}

TEST_CASE("compute: lists of rays end alike by both stages") {
    Scene scene = thumbnail("first-light");
    scene.camera.width = 16, scene.camera.height = 9;
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    REQUIRE(spacetime);
    const std::vector<RayQuery> rays = cli::rays_of(scene.camera);
    const auto traced = [&](const char* stage) {
        std::vector<double> numbers;
        const cli::TraceOutput output{[&](std::size_t, RayRecord&& record) {
                                          numbers.insert(numbers.end(), {record.theta_inf, record.phi_inf});
                                          for (const RayRecord::Crossing& crossing : record.crossings)
                                              numbers.insert(numbers.end(), {crossing.r, crossing.phi});
                                      },
                                      [](long long) {}, [](std::size_t, Error error) { return error; }};
        cli::TraceOptions options;
        options.with = "gl", options.stage = stage, options.crossings = 3;
        CHECK(cli::trace_rays(scene, **spacetime, rays, options, output));
        return numbers;
    };
    const std::vector<double> by_fragments = traced("fragment"), by_compute = traced("compute");
    CHECK(by_fragments.size() >= 2 * rays.size());
    CHECK(std::ranges::equal(by_fragments, by_compute, [](double a, double b) {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    }));
}

TEST_CASE("compute: a text that the driver refuses is said in a line") {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    if (!compares()) return;
    ComputePicture computed;
    computed.want(true, false);
    const ComputePicture::Key key(Stage::kPicture, Output::kLinear, {}, {}, "", {});
    const auto none = [](const gl::Program&) {};
    const auto refused = [] {
        return std::string("layout(local_size_x = 64) in;\nvoid main() { float a; float b = a; nothing(); }\n");
    };
    CHECK(computed.draws());
    CHECK(computed.program(key, {gl::Format::kRgba32F}, refused, none) == nullptr);
    CHECK(computed.program(key, {gl::Format::kRgba32F}, refused, none) == nullptr);
    CHECK_FALSE(computed.draws());
    CHECK(computed.refusal().find('\n') == std::string::npos);
    CHECK(computed.refusal().find("refuses") != std::string::npos);
    CHECK(computed.refusal().find("nothing") != std::string::npos);  // not a warning that comes first
    CHECK_FALSE(computed.take_refusal().empty());
    CHECK(computed.take_refusal().empty());
}

}  // namespace
