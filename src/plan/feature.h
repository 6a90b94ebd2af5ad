// Inside scene and for benches: all that the host says of one effect, in one place. An effect is added by an enumerator and a
// Feature in one of the files ..._features.cpp; what of it runs on the GPU is in shaders/, under its define or in a slot.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/assets.h"
#include "observer/observer.h"
#include "plan/effects.h"
#include "scene/scene.h"
#include "scene/scene_key.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// What several features ask of a frame.
struct FrameFacts {
    const Scene& scene;
    const Spacetime* spacetime;  // nullptr: an unknown metric
    const Observer* observer;    // nullptr: there is none
    bool planar;                 // its rays stay in planes
    bool moves;                  // the camera's motion changes something
    bool sky_light, sky_shift;   // the sky is a picture; its light is shifted
    const char* heat;            // what shines by its heat; nullptr: nothing
    EffectSet so_far;            // that the frame calls for, of the enumerators before
    bool bends() const { return planar && spacetime->bends_light() && scene.light.lensing; }
    bool thermal() const { return scene.disc && scene.disc->emission == DiscEmission::kThermal; }
    bool spot() const { return scene.disc && !scene.spots.empty(); }
    bool gas() const { return scene.medium && scene.medium->kind == MediumKind::kGas; }
    bool has_emission(MediumEmission kind) const {  // of a medium that has a choice
        return scene.medium && scene.medium->kind != MediumKind::kGas && scene.medium->emission == kind;
    }
    bool points() const { return scene.sky.kind == SkyKind::kPoints; }
    bool has_g() const { return scene.light.doppler || scene.light.gravity; }
};

// What in a scene calls for an effect, with the value: "camera.velocity = [0, 0, 0.5]". Nothing: it is not called for.
using Reason = std::optional<std::string>;
inline const Reason kNot = std::nullopt;
inline Reason reason_if(bool called, std::string words) { return called ? Reason(std::move(words)) : kNot; }

struct Feature : EffectRow {
    Reason (*calls)(const FrameFacts& facts);
    void (*without)(Scene& scene);  // switches it off; nullptr: it is the metric's, and cannot go alone
    // For benches: into an empty scene what the effect cannot be without, and then the effect.
    void (*before)(Scene& scene);
    void (*with)(Scene& scene);
    // Of a scene that cannot always be without it: can this one? nullptr: any can.
    bool (*alone)(const Scene& scene) = nullptr;
    std::vector<SceneKey> keys = {};  // of scene files, where it has its own
};

std::span<const Feature> light_features();
std::span<const Feature> disc_features();
std::span<const Feature> polarisation_features();
std::span<const Feature> bodies_features();
std::span<const Feature> medium_features();
std::span<const Feature> picture_features();
std::span<const Feature> projection_features();
std::vector<std::span<const Feature>> feature_groups();  // all of these
const Feature& feature_of(Effect effect);

// Parts of examples.
inline void nothing(Scene&) {}
inline void bare_disc(Scene& s) {
    s.spacetime.metric = "schwarzschild";
    s.disc.emplace();
}
inline void still_disc(Scene& s) { bare_disc(s), s.light.delay = false; }
inline void moving_disc(Scene& s) { still_disc(s), s.disc->flow = DiscFlowKind::kKepler; }
template <bool shift, bool beaming>
void glowing(Scene& s) {
    s.spacetime.metric = "schwarzschild";
    s.disc.emplace().emission = DiscEmission::kThermal;
    s.light = {shift, beaming};
}
inline void dark_wormhole(Scene& s) {
    s.spacetime.metric = "ellis";
    s.far_sky.kind = SkyKind::kBlack;
}
inline std::filesystem::path example_image() { return assets_directory() / "images" / "accretion-disc.png"; }

}  // namespace nullscope
