// The text of compute shaders: that of the fragment shaders but for what a compute shader may not hold, and nothing of an effect that is off.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "plan/effects.h"
#include "scenefile/scene_file.h"
#include "shaderlib/passes.h"

using namespace nullscope;

namespace {

constexpr Stage kComputed[] = {Stage::kPicture,   Stage::kSkyTiles, Stage::kDiscTiles,
                               Stage::kBodyTiles, Stage::kRayData,  Stage::kRayList};

struct Texts {
    std::string fragment, compute;
};

Texts texts_of(Stage stage, const Scene& scene, Output output) {
    const EffectSet effects = effect_set(required_effects(scene));
    const BodyText bodies = body_text(scene, effects);
    return {shader_source(stage, effects, output, {}, scene.spacetime.metric, bodies).fragment,
            compute_source(stage, effects, output, {}, scene.spacetime.metric, bodies)};
}

// Those of every picture, and of this scene's, in tiles of each kind.
std::set<Stage> computed_stages(const Scene& scene) {
    std::set<Stage> stages(std::begin(kComputed), std::end(kComputed));
    for (const Tiles tiles : {Tiles::kBodies, Tiles::kTraced, Tiles::kInterpolated})
        for (const Pass& pass : passes(effect_set(required_effects(scene)), Output::kDisplay, tiles))
            if (computes(pass.stage)) stages.insert(pass.stage);
    return stages;
}

TEST_CASE("compute source: holds nothing that drivers refuse in a compute shader") {
    std::set<Stage> seen;
    for (const SceneInfo& info : shipped_scenes()) {
        const Scene scene = *load_scene(info.name);
        const std::set<Stage> stages = computed_stages(scene);
        seen.insert(stages.begin(), stages.end());
        for (const Stage stage : stages) {
            const std::string text = texts_of(stage, scene, Output::kDisplay).compute;
            for (const char* word : {"dFdx", "dFdy", "gl_FragCoord", "discard", "flat in", "#version"})
                CHECK_MESSAGE(text.find(word) == std::string::npos, info.name, ": ", word);
            CHECK(text.find("layout(local_size_x = GROUP_THREADS) in;") != std::string::npos);
        }
    }
    for (const Stage stage : {Stage::kRays, Stage::kTiles, Stage::kTilesTraced, Stage::kTilesInterpolated,
                              Stage::kLattice, Stage::kMatterTold, Stage::kMatterTraced})
        CHECK(seen.contains(stage));
}

// A node that a coarser lattice tells traces no ray: its thread does not come to where others would wait.
TEST_CASE("compute source: no thread of a lattice or of tiles waits for another") {
    for (const SceneInfo& info : shipped_scenes()) {
        const Scene scene = *load_scene(info.name);
        for (const Stage stage : computed_stages(scene))
            if (goes_before(stage))
                CHECK_MESSAGE(
                    texts_of(stage, scene, Output::kLinear).compute.find("GROUP_WAITS()") == std::string::npos,
                    info.name);
    }
}

// Neither effects that are absent nor another picture's code come in by this way: of each scene the texts are as long as each other.
TEST_CASE("compute source: is as long as the fragment shader's, whatever the scene has") {
    constexpr long long kOwnBytes = 1200;    // threads, stores, neighbours; 1164 at most
    constexpr long long kPatchBytes = 2400;  // of refined pixels
    long long most = 0;
    for (const SceneInfo& info : shipped_scenes()) {
        const Scene scene = *load_scene(info.name);
        const EffectSet effects = effect_set(required_effects(scene));
        const Texts texts = texts_of(Stage::kPicture, scene, Output::kLinear);
        const auto with_patches =
            static_cast<long long>(compute_source(Stage::kPicture, effects, Output::kLinear, {}, scene.spacetime.metric,
                                                  body_text(scene, effects), true)
                                       .size());
        const long long more =
            static_cast<long long>(texts.compute.size()) - static_cast<long long>(texts.fragment.size());
        most = std::max(most, more);
        CHECK_MESSAGE(more >= 0, info.name);
        CHECK_MESSAGE(more <= kOwnBytes, info.name);
        const long long patches = with_patches - static_cast<long long>(texts.compute.size());
        CHECK_MESSAGE((effects.contains(Effect::kRefine) ? patches > 0 && patches <= kPatchBytes : patches == 0),
                      info.name);
    }
    fmt::print("compute source: at most {} bytes more than the fragment shader's\n", most);
}

// Threads hand their values over only where neighbours are asked for.
TEST_CASE("compute source: waits for neighbours where rays are integrated, and nowhere else") {
    for (const char* name : {"kerr", "first-light", "flat"}) {
        const bool integrated = std::string(name) == "kerr";
        const std::string text = texts_of(Stage::kPicture, *load_scene(name), Output::kLinear).compute;
        CHECK((text.find("GROUP_WAITS()") != std::string::npos) == integrated);
        CHECK(texts_of(Stage::kRayData, *load_scene(name), Output::kLinear).compute.find("GROUP_WAITS()") ==
              std::string::npos);
    }
}

}  // namespace
