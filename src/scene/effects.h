// Effects: what the renderer can be asked to do, and which of it a scene calls for. What is not called for is not
// compiled, not built and not run. An effect is added by one enumerator, one row of kEffectTable and one line of
// required_effects().
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
    kDiscFlow,
    kSpot,
    kBallPath,
    kPulse,
    kInnerHorizon
};
inline constexpr std::size_t kEffectCount = 40;

struct EffectRow {
    Effect effect;
    std::string_view key;     // in plans and messages
    std::string_view define;  // GLSL preprocessor name
    std::string_view help;    // one sentence
    std::string_view needs;   // what in a scene calls for it
    std::string_view cost;    // what it adds: tables, textures, work a pixel
};

// In the order of the enumerators.
inline constexpr std::array<EffectRow, kEffectCount> kEffectTable = {{
    {Effect::kLensing, "lensing", "EFFECT_LENSING", "Light follows the null geodesics of the metric.",
     "spacetime.metric is one that bends light and does not rotate, and light.lensing is not \"off\"",
     "deflection table, strip; one fetch and two straight lines a pixel"},
    {Effect::kSpin, "spin", "EFFECT_SPIN", "Light follows the null geodesics of a rotating hole.",
     "spacetime.metric is kerr or kerr-newman, and spin is above 0", "some 8 steps of five forces a pixel, at most 64"},
    {Effect::kSpinFall, "spin-fall", "EFFECT_SPIN_FALL",
     "Rays cross the horizon of a rotating hole to a camera that falls.",
     "the hole rotates, and camera.observer is \"rain\", \"fall\" or \"throw\"", "a square root a force"},
    {Effect::kAberration, "aberration", "EFFECT_ABERRATION",
     "Directions and frequencies are those of a camera that moves in its observer's frame.",
     "camera.velocity is not zero, or camera.observer is \"orbit\", and light.aberration or light.doppler is not "
     "\"off\"",
     "one division a pixel"},
    {Effect::kDisc, "disc", "EFFECT_DISC", "A flat disc lies in the equatorial plane.", "there is a [disc]",
     "ray ends, orbit map; four fetches a crossing"},
    {Effect::kDiscImage, "disc-image", "EFFECT_DISC_IMAGE", "The disc carries an image.",
     "disc.texture is \"image\", and disc.emission too or there is a disc.image",
     "a picture with mip levels; one or two fetches a crossing"},
    {Effect::kDiscPattern, "disc-pattern", "EFFECT_DISC_PATTERN",
     "The disc is covered by a colour, a pattern or a formula.", "disc.texture is not \"image\"",
     "arithmetic a crossing"},
    {Effect::kTranslucentDisc, "translucent-disc", "EFFECT_TRANSLUCENT_DISC",
     "What lies behind the disc shines through it.", "disc.opacity is below 1 or disc.edge is above 0",
     "every crossing is shaded, not the first alone"},
    {Effect::kThermalDisc, "thermal-disc", "EFFECT_THERMAL_DISC",
     "The disc's matter moves on geodesics and glows with the heat that it gains by falling.",
     "disc.emission is \"thermal\"", "disc flow, black body; six fetches a crossing"},
    {Effect::kShift, "shift", "EFFECT_SHIFT", "Light has the colour that motion and gravity give it.",
     "something shines by its heat, light.shift is not \"off\", nor are both light.doppler and light.gravity",
     "one logarithm a crossing or star"},
    {Effect::kBeaming, "beaming", "EFFECT_BEAMING", "Light has the brightness that motion and gravity give it.",
     "something shines by its heat, light.beaming is not \"off\", nor are both light.doppler and light.gravity",
     "one logarithm a crossing or star"},
    {Effect::kBolometric, "bolometric", "EFFECT_BOLOMETRIC", "Brightness is power at all wavelengths.",
     "something shines by its heat and light.band is \"bolometric\"", "nothing"},
    {Effect::kSphere, "sphere", "EFFECT_SPHERE", "A solid sphere about the centre ends rays.", "there is a [sphere]",
     "ray ends, orbit map; some four steps of four fetches where it is seen"},
    {Effect::kCylinder, "cylinder", "EFFECT_CYLINDER", "A solid disc of finite thickness ends rays.",
     "there is a [cylinder]", "ray ends, orbit map; strides of four fetches, at most 128"},
    {Effect::kBall, "ball", "EFFECT_BALL", "A solid sphere anywhere ends rays.", "there is a [ball]",
     "ray ends, orbit map; strides of four fetches, at most 128, shared with other bodies"},
    {Effect::kSurface, "surface", "EFFECT_SURFACE", "A solid given by a formula ends rays.", "there is a [surface]",
     "ray ends, orbit map; equal strides of four fetches and seven times the formula"},
    {Effect::kPattern, "pattern", "EFFECT_PATTERN",
     "A body, the disc or the sky has a checker, a grid of coordinates or stripes.",
     "a texture or sky.kind is checker, grid or stripes", "arithmetic where it is seen"},
    {Effect::kNoise, "noise", "EFFECT_NOISE", "A body, the disc or the sky has noise on it.",
     "a texture or sky.kind is noise", "eight hashes an octave, four octaves, where it is seen"},
    {Effect::kFormula, "formula", "EFFECT_FORMULA", "A formula of the scene file is part of the shader.",
     "a texture or sky.kind is a formula", "four times the formula where it is seen"},
    {Effect::kBodyImage, "body-image", "EFFECT_BODY_IMAGE", "A body has an image on it.",
     "a body's texture is an image", "a picture with mip levels; one fetch where the body is seen"},
    {Effect::kPointStars, "point-stars", "EFFECT_POINT_STARS", "Stars are points, each with all its images.",
     "sky.kind is \"points\"",
     "a pass of its own: a vertex a star and image; star lens, black body; about a rotating hole a mesh of rays on the "
     "host"},
    {Effect::kSky, "sky", "EFFECT_SKY", "Escaped rays show the celestial sphere.",
     "sky.kind is stars, image or points, and there are no sky.even_stars", "a cube map; one fetch a pixel"},
    {Effect::kSkyShift, "sky-shift", "EFFECT_SKY_SHIFT",
     "The light of the sky's picture has the colour and brightness that g gives it.",
     "there is a sky.temperature, and the camera moves or is not far away",
     "a factor; black body and one logarithm a pixel where the camera moves"},
    {Effect::kSkyPattern, "sky-pattern", "EFFECT_SKY_PATTERN", "Escaped rays show a colour, a pattern or a formula.",
     "sky.kind is plain, checker, grid, stripes, noise or formula", "arithmetic a pixel"},
    {Effect::kInner, "inner", "EFFECT_INNER", "Rays that pass the critical direction inward end somewhere to see.",
     "spacetime.metric is a wormhole, a star or a charge without horizon", "more octaves of the strip"},
    {Effect::kBounce, "bounce", "EFFECT_BOUNCE",
     "Rays that pass the critical direction inward turn and come back to the same sky.",
     "spacetime.metric is a charge without horizon", "more octaves of the strip, about the centre"},
    {Effect::kFarSky, "far-sky", "EFFECT_FAR_SKY", "Rays through the wormhole show the sky of its other side.",
     "spacetime.metric is a wormhole and far_sky.kind is not black", "a cube map; one fetch a pixel"},
    {Effect::kStar, "star", "EFFECT_STAR", "Rays end on the surface of a star.", "spacetime.metric is a star",
     "arithmetic where the star is seen"},
    {Effect::kBloom, "bloom", "EFFECT_BLOOM", "Lens and eye scatter light about its place.", "picture.bloom is above 0",
     "the picture in linear light, halved again and again and added up"},
    {Effect::kAutoExposure, "auto-exposure", "EFFECT_AUTO_EXPOSURE", "Exposure follows the picture's mean luminance.",
     "picture.auto_exposure is \"on\"", "the picture in linear light, halved again and again"},
    {Effect::kToneFilm, "tone-film", "EFFECT_TONE_FILM", "Bright light is compressed as by film.",
     "picture.tone is \"film\"", "arithmetic"},
    {Effect::kToneNeutral, "tone-neutral", "EFFECT_TONE_NEUTRAL", "Bright light is compressed, other colours are kept.",
     "picture.tone is \"neutral\"", "arithmetic"},
    {Effect::kDither, "dither", "EFFECT_DITHER", "Noise hides the steps of 8 bits.", "picture.dither is \"on\"",
     "arithmetic"},
    {Effect::kSides, "sides", "EFFECT_SIDES", "Bodies stand on either side of a wormhole's throat.",
     "spacetime.metric is a wormhole and there is a body", "a logarithm and a root a stride"},
    {Effect::kDelay, "delay", "EFFECT_DELAY", "Light takes time: what moves is seen where it was when its light left.",
     "something changes with time and light.delay is not \"off\"",
     "delay map; four fetches and a logarithm a crossing or a look at a body; about a rotating hole a root a force"},
    {Effect::kDiscFlow, "disc-flow", "EFFECT_DISC_FLOW",
     "Every ring of the disc's pattern moves with the matter's speed.", "disc.flow is \"kepler\"",
     "the pattern twice a crossing"},
    {Effect::kSpot, "spot", "EFFECT_SPOT", "Hot spots are on an orbit in the disc.", "there is a [spot] and a [disc]",
     "arithmetic a crossing; black body where one is"},
    {Effect::kBallPath, "ball-path", "EFFECT_BALL_PATH", "The ball moves.", "ball.motion is not \"still\"",
     "the ball's way; two fetches a stride"},
    {Effect::kPulse, "pulse", "EFFECT_PULSE", "The sphere pulsates.", "sphere.swing is above 0",
     "strides of four fetches"},
    {Effect::kInnerHorizon, "inner-horizon", "EFFECT_INNER_HORIZON",
     "The time that light takes is that of a hole with an inner horizon.",
     "light takes time about a hole with spacetime.charge", "a logarithm a crossing or a look at a body"},
}};

constexpr const EffectRow& effect_row(Effect effect) { return kEffectTable[static_cast<std::size_t>(effect)]; }

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
    // Not to_ulong(): where long has 32 bits (Windows, WebAssembly) it throws for the effects from number 32 on.
    friend bool operator<(const EffectSet& a, const EffectSet& b) { return a.bits_.to_ullong() < b.bits_.to_ullong(); }

private:
    static_assert(kEffectCount <= 64, "operator< compares sets as numbers of 64 bits");
    std::bitset<kEffectCount> bits_;
};

// The kind of path that a frame's light takes: orbits in planes, which straight light is drawn as too, or steps in Mino's time.
enum class LightPathKind { kPlanar, kMino };
LightPathKind light_path_kind(const EffectSet& effects);
bool has_marched(
    const EffectSet& effects);  // bodies that are found by strides: all but the sphere, and that about a rotating hole
bool has_solids(const EffectSet& effects);     // any solid body
bool shades_heat(const EffectSet& effects);    // black bodies in the picture's shader: the table of their light
bool meets_objects(const EffectSet& effects);  // anything that needs positions along rays: ray ends, orbit map
bool moves(const EffectSet& effects);          // a body that is elsewhere, or another, at another time

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
