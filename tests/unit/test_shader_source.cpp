// The text that goes to the driver: nothing of an effect that is off is in it.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "scene/effects.h"
#include "shaderlib/embedded.h"
#include "shaderlib/shader_source.h"

using namespace nullscope;

namespace {

std::vector<EffectSet> all_sets() {
    std::vector<EffectSet> sets;
    for (unsigned bits = 0; bits < (1u << kEffectCount); ++bits) {
        EffectSet set;
        for (std::size_t i = 0; i < kEffectCount; ++i)
            if (bits >> i & 1u) set.insert(static_cast<Effect>(i));
        if (set.contains(Effect::kTranslucentDisc) && !set.contains(Effect::kDisc)) continue;
        if (set.contains(Effect::kInner) && !set.contains(Effect::kLensing)) continue;
        if (set.contains(Effect::kStar) && !set.contains(Effect::kInner)) continue;
        if (set.contains(Effect::kFarSky) && !set.contains(Effect::kInner)) continue;
        sets.push_back(set);
    }
    return sets;
}

// Identifiers that belong to one effect.
struct Mark { Effect effect; std::vector<std::string> words; };
const std::vector<Mark> kMarks = {
    {Effect::kLensing, {"strip_locate", "strip_texture", "StripRay", "sweep_to_sky"}},
    {Effect::kAberration, {"aberrate", "Aberration"}},
    {Effect::kDisc, {"disc_cross", "disc_texture", "DiscCrossing", "plane_meet"}},
    {Effect::kTranslucentDisc, {"fade"}},
    {Effect::kSky, {"celestial_sphere", "sky_texture"}},
    {Effect::kInner, {"frame.strip.w"}},
    {Effect::kFarSky, {"other_side", "other_side_texture"}},
    {Effect::kStar, {"star_surface", "star_square"}},
};

// Without the uniform block, which is one for all.
std::string body(const std::string& source) { return source.substr(source.find("uniform FrameBlock")); }

}  // namespace

TEST_CASE("shader source: an effect that is off leaves nothing in the picture's shader, one that is on leaves its marks") {
    for (const EffectSet& set : all_sets()) {
        const std::string text = body(shader_source(Stage::kPicture, set, Output::kDisplay).fragment);
        for (const Mark& mark : kMarks)
            for (const std::string& word : mark.words)
                CHECK_MESSAGE((text.find(word) != std::string::npos) == set.contains(mark.effect), word);
        CHECK(text.find("EFFECT_") == std::string::npos);
        CHECK(text.find("__cplusplus") == std::string::npos);
    }
}

TEST_CASE("shader source: every row of the effects table has marks here") {
    for (const EffectRow& row : kEffectTable) {
        bool found = false;
        for (const Mark& mark : kMarks) found = found || mark.effect == row.effect;
        CHECK_MESSAGE(found, row.key);
    }
}

TEST_CASE("shader source: linear output has no display encoding") {
    const EffectSet set = {Effect::kSky};
    CHECK(shader_source(Stage::kPicture, set, Output::kLinear).fragment.find("display_encode") == std::string::npos);
    CHECK(shader_source(Stage::kPicture, set, Output::kDisplay).fragment.find("display_encode") != std::string::npos);
}
