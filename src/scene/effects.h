// Effects: what the renderer can be asked to do, and which of it a scene calls for. What is not called for is not
// compiled, not built and not run. An effect is added by one enumerator, one row of kEffectTable and one line of
// required_effects().
#pragma once
#include <array>
#include <bitset>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

enum class Effect { kLensing, kAberration, kDisc, kDiscImage, kTranslucentDisc, kThermalDisc, kShift, kBeaming, kSky };
inline constexpr std::size_t kEffectCount = 9;

struct EffectRow {
    Effect effect;
    std::string_view key;     // in plans and messages
    std::string_view define;  // GLSL preprocessor name
    std::string_view help;    // one sentence
    std::string_view needs;   // what in a scene calls for it
};

// In the order of the enumerators.
inline constexpr std::array<EffectRow, kEffectCount> kEffectTable = {{
    {Effect::kLensing, "lensing", "EFFECT_LENSING", "Light follows the null geodesics of the metric.",
     "spacetime.metric is one that bends light"},
    {Effect::kAberration, "aberration", "EFFECT_ABERRATION",
     "Directions and frequencies are those of a camera that moves in the static frame.", "camera.velocity is not zero"},
    {Effect::kDisc, "disc", "EFFECT_DISC", "A flat disc lies in the equatorial plane.", "there is a [disc]"},
    {Effect::kDiscImage, "disc-image", "EFFECT_DISC_IMAGE", "The disc carries an image.",
     "disc.emission is \"image\" or there is a disc.image"},
    {Effect::kTranslucentDisc, "translucent-disc", "EFFECT_TRANSLUCENT_DISC",
     "What lies behind the disc shines through it.", "disc.opacity is below 1 or disc.edge is above 0"},
    {Effect::kThermalDisc, "thermal-disc", "EFFECT_THERMAL_DISC",
     "The disc's matter moves on geodesics and glows with the heat that it gains by falling.", "disc.emission is \"thermal\""},
    {Effect::kShift, "shift", "EFFECT_SHIFT", "Light has the colour that motion and gravity give it.",
     "something shines by its heat and light.shift is not \"off\""},
    {Effect::kBeaming, "beaming", "EFFECT_BEAMING", "Light has the brightness that motion and gravity give it.",
     "something shines by its heat and light.beaming is not \"off\""},
    {Effect::kSky, "sky", "EFFECT_SKY", "Escaped rays show the celestial sphere.", "sky.kind is not black"},
}};

constexpr const EffectRow& effect_row(Effect effect) { return kEffectTable[static_cast<std::size_t>(effect)]; }

// A set of effects; equal and ordered by content, so it can be a key of std::map.
class EffectSet {
public:
    EffectSet() = default;
    EffectSet(std::initializer_list<Effect> effects) {
        for (const Effect effect : effects) insert(effect);
    }
    void insert(Effect effect) { bits_.set(static_cast<std::size_t>(effect)); }
    bool contains(Effect effect) const { return bits_.test(static_cast<std::size_t>(effect)); }
    bool empty() const { return bits_.none(); }
    std::size_t size() const { return bits_.count(); }
    std::vector<Effect> list() const;            // in the order of the enumerators
    std::vector<std::string_view> keys() const;  // the same as keys
    friend bool operator==(const EffectSet& a, const EffectSet& b) { return a.bits_ == b.bits_; }
    friend bool operator<(const EffectSet& a, const EffectSet& b) { return a.bits_.to_ulong() < b.bits_.to_ulong(); }

private:
    std::bitset<kEffectCount> bits_;
};

struct EffectReason {
    Effect effect;
    std::string reason;  // what in this scene calls for it, with the value: "camera.velocity = [0, 0, 0.5]"
};

// Pure: no file is opened. In the order of the enumerators, each effect at most once. The scene must be valid (an
// unknown metric calls for no lensing).
std::vector<EffectReason> required_effects(const Scene& scene);
EffectSet effect_set(const std::vector<EffectReason>& reasons);

}  // namespace nullscope
