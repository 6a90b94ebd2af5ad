// Which shaders take less is measured once a device and kind of scene, and remembered in a file that others may have written.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "render/stage_times.h"
#include "render/stage_trial.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
namespace fs = std::filesystem;

constexpr StageTimes kByCompute{12.0, 3.0}, kByFragments{2.0, 2.5};

TEST_CASE("stage times: what is kept is found by those who read the file after") {
    const TemporaryFolder folder("stages");
    const fs::path file = folder.path / "nullscope" / "stages.csv";
    StageMemory first(file), second(file);
    const std::string device = "A \"card\", 4.6", kind = "kerr strip, tiles: lensing disc";
    REQUIRE(first.keep(device, kind, kByCompute));
    REQUIRE(second.keep(device, "flat", kByFragments));  // which did not know of the first's
    CHECK_FALSE(second.find("another card", kind));
    const StageMemory later(file);
    REQUIRE(later.find(device, kind));
    CHECK(later.find(device, kind)->computes());
    CHECK(later.find(device, kind)->compute_ms == doctest::Approx(3.0));
    REQUIRE(later.find(device, "flat"));
    CHECK_FALSE(later.find(device, "flat")->computes());
    REQUIRE(first.keep(device, kind, kByFragments));  // measured again
    CHECK(StageMemory(file).of_kind(kind).size() == 1);
    CHECK_FALSE(StageMemory(file).find(device, kind)->computes());
    StageMemory nowhere{fs::path()};
    CHECK(nowhere.keep(device, kind, kByCompute));
    CHECK(nowhere.find(device, kind));
}

TEST_CASE("stage times: rows that say nothing are as none, and the oldest are forgotten") {
    const TemporaryFolder folder("stages");
    const fs::path file = folder.path / "stages.csv";
    std::ofstream(file)
        << "device,kind,fragment_ms,compute_ms\n\"open,a,1,2\na,b,1\na,b,-1,2\na,b,nan,2\na,b,1,1e300\na,c,4,2\n";
    StageMemory memory(file);
    CHECK_FALSE(memory.find("a", "b"));
    CHECK(memory.find("a", "c"));
    for (std::size_t i = 0; i < StageMemory::kMostRows; ++i)
        REQUIRE(memory.keep("a", "kind " + std::to_string(i), kByFragments));
    CHECK_FALSE(StageMemory(file).find("a", "c"));
    CHECK(StageMemory(file).find("a", "kind 0"));
}

TEST_CASE("stage times: what takes less draws from then on, and what gives up leaves fragments") {
    auto session = test::open_gpu("egl");
    REQUIRE(session);
    Renderer& renderer = *session->renderer;
    Scene scene = *load_scene("first-light");
    scene.camera.width = 64, scene.camera.height = 36;
    REQUIRE(renderer.prepare(scene));
    CHECK(stage_kind(renderer).starts_with("schwarzschild strip, "));
    const gl::Target target = gl::make_target(64, 36, gl::Format::kRgba8);
    int frames = 0;
    const auto try_at = [&](double fragment_ms, double compute_ms, int most) {
        frames = 0;
        return try_stages(renderer, [&]() -> std::optional<double> {
            if (frames++ == most) return std::nullopt;
            const bool compute = renderer.computed().draws();
            renderer.draw(target.framebuffer.id(), 64, 36, Output::kDisplay);
            return compute ? compute_ms : fragment_ms;
        });
    };
    if (!gl::computes()) {
        CHECK_FALSE(try_at(1, 2, 100)->refusal.empty());
        return;
    }
    auto trial = try_at(5.0, 1.0, 100);
    REQUIRE(trial);
    CHECK(trial->refusal.empty());
    CHECK(trial->times.compute_ms == 1.0);
    CHECK(renderer.computed().draws());
    const int whole = frames;
    REQUIRE(try_at(1.0, 5.0, 100));
    CHECK_FALSE(renderer.computed().draws());
    for (int most = 0; most < whole; ++most) {
        CHECK_FALSE(try_at(5.0, 1.0, most));
        CHECK_FALSE(renderer.computed().draws());
    }
}

}  // namespace
