// Effects: what the renderer can be asked to do, and which of it a scene calls for. What is not called for is not
// compiled, not built and not run. An effect is added by one enumerator and one Feature (plan/feature.h).
#pragma once
#include <array>
#include <bitset>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

class Spacetime;
struct Observer;

enum class Effect {
    kLensing,
    kSpin,
    kSpinFall,
    kAberration,
    kDisc,
    kDiscImage,
    kDiscPattern,
    kTranslucentDisc,
    kThermalDisc,
    kShift,
    kBeaming,
    kBolometric,
    kSphere,
    kCylinder,
    kBall,
    kSurface,
    kPattern,
    kNoise,
    kFormula,
    kBodyImage,
    kGlow,
    kPointStars,
    kSky,
    kSkyShift,
    kSkyPattern,
    kInner,
    kBounce,
    kFarSky,
    kStar,
    kBloom,
    kAutoExposure,
    kToneFilm,
    kToneNeutral,
    kDither,
    kSides,
    kDelay,
    kLightTimes,
    kDiscFlow,
    kRingRates,
    kSpot,
    kBallPath,
    kPulse,
    kInnerHorizon,
    kLimbDarkening,
    kSamples,
    kDiscGas,
    kRefine,
    kNarrowDisc,
    kPolarisation,
    kPolariser,
    kZoom,
    kSpinRing,
    kSpinNear,
    kProjectionFirst,  // one for each Projection but the pinhole: projection_effect()
    kWarp = kProjectionFirst + kProjections - 1,
    kMediumFirst,  // one for each MediumKind: medium_effect()
    kMediumMotion = kMediumFirst + kMediumKinds,
    kMediumBlackBody,
    kMediumSynchrotron,
    kMediumPolarisation,
    kMediumBands,
    kMediumElectrons,
    kDiscLean,
    kSphereTurn,
    kCaps,
    kDiscWarp,
    kEnd  // no effect: how many there are
};
// That there is a medium of a kind.
constexpr Effect medium_effect(MediumKind kind) {
    return static_cast<Effect>(static_cast<int>(Effect::kMediumFirst) + static_cast<int>(kind));
}
// That the camera has a projection, which is no pinhole.
constexpr Effect projection_effect(Projection projection) {
    return static_cast<Effect>(static_cast<int>(Effect::kProjectionFirst) + static_cast<int>(projection) - 1);
}
inline constexpr auto kEffectCount = static_cast<std::size_t>(Effect::kEnd);

// Where any number of effects stand side by side in a shader, each by one function of its own file (shaderlib/slots.h).
// kDiscGlow: vec3 NAME(Trace, DiscCrossing, float delay), light of the disc's place whatever covers it. These add up.
// kDiscLight: float NAME(float cosine), factor on the disc's heat by the angle to the normal at which the light leaves its matter.
// kMedium: matter along the ray; one at a time, whose file defines medium_matter() and medium_free() (medium/matter.glsl).
enum class Slot { kNone, kDiscGlow, kDiscLight, kMedium };
struct SlotPart {
    Slot slot = Slot::kNone;
    std::string_view file, function = {};  // of shaders/
};

struct EffectRow {
    Effect effect;
    std::string_view key;     // in plans and messages
    std::string_view define;  // GLSL preprocessor name
    std::string_view help;    // one sentence
    std::string_view needs;   // what in a scene calls for it
    std::string_view cost;    // work that it adds; its tables and textures are those of render/frame_textures.h
    SlotPart part = {};       // of an effect that stands in a slot: all that the shader has of it
};

std::string_view kept(std::string text);  // for the views of rows: as long as the program runs

// In the order of the enumerators.
const EffectRow& effect_row(Effect effect);
std::vector<const EffectRow*> effect_rows();  // in the order of the enumerators

// A set of effects; equal and ordered by content, so it can be a key of std::map.
class EffectSet {
public:
    EffectSet() = default;
    EffectSet(std::initializer_list<Effect> effects) {
        for (const Effect effect : effects) insert(effect);
    }
    void erase(Effect effect) { bits_.reset(static_cast<std::size_t>(effect)); }
    void insert(Effect effect) { bits_.set(static_cast<std::size_t>(effect)); }
    bool contains(Effect effect) const { return bits_.test(static_cast<std::size_t>(effect)); }
    bool empty() const { return bits_.none(); }
    std::size_t size() const { return bits_.count(); }
    std::vector<Effect> list() const;            // in the order of the enumerators
    std::vector<std::string_view> keys() const;  // the same as keys
    friend bool operator==(const EffectSet& a, const EffectSet& b) { return a.bits_ == b.bits_; }
    // By the first effect that only one of them has: the set that has it comes first.
    friend bool operator<(const EffectSet& a, const EffectSet& b) {
        const auto differ = a.bits_ ^ b.bits_;
        for (std::size_t i = 0; i < kEffectCount; ++i)
            if (differ.test(i)) return a.bits_.test(i);
        return false;
    }

private:
    std::bitset<kEffectCount> bits_;
};

// The kind of path that a frame's light takes: orbits in planes, which straight light is drawn as too, or steps in Mino's time.
enum class LightPathKind { kPlanar, kMino };
LightPathKind light_path_kind(const EffectSet& effects);
// Where a picture is drawn in tiles, they tell apart: has_tiles: whether they may show a marched body (all outside of every horizon, on
// one side of the throat); tiles_classify_disc: whether they may show the disc;
// tiles_classify_full_disc: or nothing else; interpolates: whether rays may be interpolated in them;
// interpolates_disc: and where they cross the disc.
// interpolates_matter: whether light of matter may be, between nodes of lattices: where nothing but a sky is behind it.
bool has_tiles(const EffectSet& effects);
bool tiles_classify_disc(const EffectSet& effects);
bool tiles_classify_full_disc(const EffectSet& effects);
bool interpolates(const EffectSet& effects);
bool interpolates_disc(const EffectSet& effects);
bool interpolates_matter(const EffectSet& effects);
bool has_marched(
    const EffectSet& effects);  // bodies that are found by steps: all but the sphere, and that about a rotating hole
std::vector<Projection> projections_of(const EffectSet& effects);  // other than the pinhole
bool has_solids(const EffectSet& effects);                         // any solid body
bool polarises(const EffectSet& effects);                          // some light is polarised
bool has_medium(const EffectSet& effects);                         // matter along rays
bool uses_black_body(const EffectSet& effects);                    // in the picture's shader: the table of their light
bool takes_samples(const EffectSet& effects);                      // pixels with several rays each
EffectSet with_one_ray(EffectSet effects);                         // a pixel: without those of several
bool meets_objects(const EffectSet& effects);  // anything that needs positions along rays: ray ends, orbit table
bool moves(const EffectSet& effects);          // a body whose place, shape or surface depends on time

struct EffectReason {
    Effect effect;
    std::string reason;  // what in this scene calls for it, with the value: "camera.velocity = [0, 0, 0.5]"
};

// Whether the camera's motion changes anything. observer: the scene's.
bool motion_is_seen(const Spacetime& spacetime, const Observer& observer, const Scene& scene);

// Pure: no file is opened. In the order of the enumerators, each effect at most once. The scene must be valid (an
// unknown metric calls for no lensing).
std::vector<EffectReason> required_effects(const Scene& scene);
// The same, of what is made already: the scene's spacetime and observer, nullptr where there is none.
std::vector<EffectReason> required_effects(const Scene& scene, const Spacetime* spacetime, const Observer* observer);
EffectSet effect_set(const std::vector<EffectReason>& reasons);

// The scene as it is without one of its effects, which then calls for all others but those that need this one. nullopt: the effect
// cannot go alone (kInner and kStar are the metric's, a disc has one light at least).
std::optional<Scene> without_effect(const Scene& scene, Effect effect);

}  // namespace nullscope
