// Which effects a scene calls for: every combination of what a scene can contain, against a rule written out again
// here.
#include <doctest/doctest.h>

#include <algorithm>
#include <bitset>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "plan/effects.h"
#include "scene/bodies.h"
#include "scenefile/scene_file.h"

using namespace nullscope;

namespace {

using Bits = std::bitset<kEffectCount>;

EffectSet subset(Bits bits) {
    EffectSet set;
    for (const EffectRow* row : effect_rows()) {
        if (bits[static_cast<std::size_t>(row->effect)]) set.insert(row->effect);
    }
    return set;
}

// Subsets of at most three effects, and all but at most three.
std::vector<Bits> subsets() {
    constexpr std::size_t kNone = kEffectCount;
    std::vector<Bits> found;
    for (std::size_t i = 0; i <= kNone; ++i)
        for (std::size_t j = std::min(i + 1, kNone); j <= kNone; ++j)
            for (std::size_t k = std::min(j + 1, kNone); k <= kNone; ++k) {
                Bits bits;
                for (const std::size_t one : {i, j, k})
                    if (one != kNone) bits.set(one);
                found.insert(found.end(), {bits, ~bits});
            }
    return found;
}

// Exactly these, none twice, in the table's order.
void check_calls_for(const Scene& scene, const EffectSet& expected) {
    std::vector<Effect> order;
    for (const EffectReason& reason : required_effects(scene)) order.push_back(reason.effect);
    CHECK(order == expected.list());
}

}  // namespace

TEST_CASE("the effect table names every effect once, with define, help and need") {
    std::set<std::string_view> keys, defines;
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        const EffectRow& row = *effect_rows()[i];
        CHECK(static_cast<std::size_t>(row.effect) == i);
        CHECK(&effect_row(row.effect) == &row);
        CHECK(keys.insert(row.key).second);
        CHECK(defines.insert(row.define).second);
        CHECK(row.define.starts_with("EFFECT_"));
        CHECK(row.help.ends_with("."));
        CHECK_FALSE(row.needs.empty());
        CHECK_FALSE(row.cost.empty());
    }
}

TEST_CASE("an effect set is its content: subsets as map keys") {
    std::map<EffectSet, Bits> seen;
    for (const Bits bits : subsets()) {
        const EffectSet set = subset(bits);
        EffectSet again;
        for (const Effect effect : set.list()) again.insert(effect);
        CHECK(again == set);
        CHECK(set.list().size() == set.size());
        CHECK(set.keys().size() == set.size());
        CHECK(set.empty() == bits.none());
        for (const EffectRow* row : effect_rows()) {
            CHECK(set.contains(row->effect) == bits[static_cast<std::size_t>(row->effect)]);
        }
        CHECK(seen.emplace(set, bits).second);
    }
    CHECK(seen.size() == subsets().size());
    for (const Bits bits : subsets()) CHECK(seen.at(subset(bits)) == bits);
    CHECK(EffectSet{Effect::kSky, Effect::kDisc} == EffectSet{Effect::kDisc, Effect::kSky, Effect::kDisc});
    CHECK(EffectSet{Effect::kSky, Effect::kDisc}.keys() == std::vector<std::string_view>{"disc", "sky"});
}

TEST_CASE("a scene calls for exactly the effects of what is in it") {
    const std::vector<std::string> metrics = {"schwarzschild", "minkowski"};
    const std::vector<Vec3> velocities = {{0, 0, 0}, {0.5, 0, 0}, {0, -1e-300, 0}, {0, 0, 0.999999}};
    const std::vector<SkyKind> skies = {SkyKind::kStars, SkyKind::kImage, SkyKind::kBlack, SkyKind::kNebula,
                                        SkyKind::kPoints};
    std::vector<std::optional<DiscSpec>> discs(8);
    discs[1] = DiscSpec{};
    discs[2] = DiscSpec{};
    discs[2]->opacity = 0.5;
    discs[3] = DiscSpec{};
    discs[3]->edge = 0.1;
    discs[4] = discs[2];
    discs[4]->edge = 0.1;
    discs[5] = DiscSpec{};  // with an image that glows
    discs[5]->emission = DiscEmission::kThermal;
    discs[5]->image = "glow.png";
    discs[6] = discs[7] = discs[4];  // that glows without one; a switch off each
    discs[6]->emission = discs[7]->emission = DiscEmission::kThermal;

    for (const std::string& metric : metrics) {
        for (const Vec3 velocity : velocities) {
            for (const SkyKind sky : skies) {
                for (std::size_t disc = 0; disc < discs.size(); ++disc) {
                    Scene scene;
                    scene.spacetime.metric = metric;
                    scene.camera.velocity = velocity;
                    scene.sky.kind = sky;
                    scene.disc = discs[disc];
                    scene.light.shift = disc != 6;
                    scene.light.beaming = disc != 7;
                    scene.light.bolometric = disc == 3;
                    EffectSet expected;
                    if (metric != "minkowski") expected.insert(Effect::kLensing);
                    if (length(velocity) > 0.0) expected.insert(Effect::kAberration);
                    if (disc >= 1) expected.insert(Effect::kDisc);
                    if (disc >= 1 && disc <= 5) expected.insert(Effect::kDiscImage);
                    if (disc >= 2 && disc != 5) expected.insert(Effect::kTranslucentDisc);
                    if (disc >= 5) expected.insert(Effect::kThermalDisc);
                    const bool points = sky == SkyKind::kPoints, glows = points || disc >= 5;
                    if (glows && disc != 6) expected.insert(Effect::kShift);
                    if (glows && disc != 7) expected.insert(Effect::kBeaming);
                    if (glows && disc == 3) expected.insert(Effect::kBolometric);
                    if (points) expected.insert(Effect::kPointStars);
                    if (sky != SkyKind::kBlack) expected.insert(Effect::kSky);
                    if (disc >= 1 || metric != "minkowski") expected.insert(Effect::kRefine);

                    check_calls_for(scene, expected);
                }
            }
        }
    }
}

TEST_CASE("bodies and their looks call for exactly their effects: every combination") {
    const std::vector<TextureKind> textures = {TextureKind::kPlain,   TextureKind::kChecker, TextureKind::kGrid,
                                               TextureKind::kStripes, TextureKind::kNoise,   TextureKind::kFormula,
                                               TextureKind::kImage};
    const auto look_effect = [](TextureKind kind) -> std::optional<Effect> {
        if (kind == TextureKind::kPlain) return {};
        if (kind == TextureKind::kNoise) return Effect::kNoise;
        if (kind == TextureKind::kFormula) return Effect::kFormula;
        return kind == TextureKind::kImage ? Effect::kBodyImage : Effect::kPattern;
    };
    for (unsigned there = 0; there < 16; ++there) {
        for (const TextureKind a : textures) {
            for (const TextureKind b : textures) {
                Scene scene;
                scene.sky.kind = SkyKind::kBlack;
                scene.spacetime.metric = "minkowski";
                EffectSet expected;
                const auto look = [&](bool is_there, Effect effect, TextureKind kind) {
                    if (!is_there) return;
                    expected.insert(effect);
                    if (const auto texture = look_effect(kind)) expected.insert(*texture);
                };
                look((there & 1u) != 0, Effect::kSphere, a);
                look((there & 2u) != 0, Effect::kCylinder, b);
                look((there & 4u) != 0, Effect::kBall, a);
                look((there & 8u) != 0, Effect::kSurface, b);
                if ((there & 8u) != 0) add_body<SurfaceSpec>(scene).material.texture = b;
                if ((there & 1u) != 0) add_body<SphereSpec>(scene).material.texture = a;
                if ((there & 2u) != 0) add_body<CylinderSpec>(scene).material.texture = b;
                if ((there & 4u) != 0) add_body<BallSpec>(scene).material.texture = a;
                if (there != 0) expected.insert(Effect::kRefine);
                check_calls_for(scene, expected);
                CHECK(has_solids(expected) == (there != 0));
                CHECK(has_marched(expected) == (there > 1));
            }
        }
    }
}

TEST_CASE("textures of disc and sky call for exactly their effects: every combination") {
    const std::vector<TextureKind> textures = {TextureKind::kPlain,   TextureKind::kChecker, TextureKind::kGrid,
                                               TextureKind::kStripes, TextureKind::kNoise,   TextureKind::kFormula,
                                               TextureKind::kImage,   TextureKind::kGas};
    const std::vector<SkyKind> skies = {SkyKind::kBlack,   SkyKind::kPlain, SkyKind::kChecker, SkyKind::kGrid,
                                        SkyKind::kStripes, SkyKind::kNoise, SkyKind::kFormula};
    for (const TextureKind texture : textures) {
        for (const SkyKind sky : skies) {
            for (const bool thermal : {false, true}) {
                Scene scene;
                scene.spacetime.metric = "minkowski";
                scene.light = {false, false, false};
                scene.sky.kind = sky;
                scene.disc.emplace().material.texture = texture;
                if (thermal) scene.disc->emission = DiscEmission::kThermal;
                EffectSet expected = {Effect::kDisc, Effect::kRefine};
                if (thermal) expected.insert(Effect::kThermalDisc);
                if (texture < TextureKind::kImage) expected.insert(Effect::kDiscPattern);
                if (texture == TextureKind::kGas) expected.insert(Effect::kDiscGas);
                if (texture == TextureKind::kImage && !thermal) expected.insert(Effect::kDiscImage);
                if (sky != SkyKind::kBlack) expected.insert(Effect::kSkyPattern);
                for (const SkyKind kind : {SkyKind::kChecker, SkyKind::kGrid, SkyKind::kStripes})
                    if (sky == kind) expected.insert(Effect::kPattern);
                for (const TextureKind kind : {TextureKind::kChecker, TextureKind::kGrid, TextureKind::kStripes})
                    if (texture == kind) expected.insert(Effect::kPattern);
                if (sky == SkyKind::kNoise || texture == TextureKind::kNoise) expected.insert(Effect::kNoise);
                if (sky == SkyKind::kFormula || texture == TextureKind::kFormula) expected.insert(Effect::kFormula);
                check_calls_for(scene, expected);
                for (const Effect effect : expected.list()) {
                    const auto less = without_effect(scene, effect);
                    if (!less) continue;
                    const EffectSet left = effect_set(required_effects(*less));
                    CHECK_FALSE(left.contains(effect));
                    for (const Effect other : left.list()) CHECK(expected.contains(other));
                }
            }
        }
    }
}

TEST_CASE("limb darkening is of a disc that is thermal, and goes with either") {
    for (const bool thermal : {false, true})
        for (const bool darkened : {false, true}) {
            Scene scene;
            scene.picture.refine = false;
            scene.disc.emplace().effects.limb_darkening = darkened;
            if (thermal) scene.disc->emission = DiscEmission::kThermal;
            const EffectSet effects = effect_set(required_effects(scene));
            CHECK(effects.contains(Effect::kLimbDarkening) == (thermal && darkened));
            if (!(thermal && darkened)) continue;
            CHECK(required_effects(scene).back().reason == "disc.limb_darkening = \"on\"");
            EffectSet less = effects;
            less.erase(Effect::kLimbDarkening);
            CHECK(effect_set(required_effects(*without_effect(scene, Effect::kLimbDarkening))) == less);
            CHECK(
                !effect_set(required_effects(*without_effect(scene, Effect::kDisc))).contains(Effect::kLimbDarkening));
        }
}

TEST_CASE("what is done to a picture calls for exactly its effects: every combination") {
    for (unsigned bits = 0; bits < 32; ++bits) {
        Scene scene;
        scene.spacetime.metric = "minkowski";
        scene.sky.kind = SkyKind::kBlack;
        EffectSet expected;
        const auto has = [&](unsigned bit, Effect effect) {
            if ((bits >> bit & 1u) != 0) expected.insert(effect);
            return (bits >> bit & 1u) != 0;
        };
        scene.picture.bloom = has(0, Effect::kBloom) ? 0.01 : 0.0;
        scene.picture.auto_exposure = has(1, Effect::kAutoExposure);
        scene.picture.dither = has(2, Effect::kDither);
        if ((bits >> 3 & 3u) == 3) continue;  // one curve
        if (has(3, Effect::kToneFilm)) scene.picture.tone = ToneCurve::kFilm;
        if (has(4, Effect::kToneNeutral)) scene.picture.tone = ToneCurve::kNeutral;
        check_calls_for(scene, expected);
    }
}

TEST_CASE("the reason quotes the scene") {
    Scene scene;
    scene.camera.velocity = {0, 0, 0.5};
    scene.disc = DiscSpec{};
    scene.disc->opacity = 0.25;
    const std::vector<EffectReason> reasons = required_effects(scene);
    REQUIRE(reasons.size() == 7);
    CHECK(reasons[0].reason == "spacetime.metric = \"schwarzschild\"");
    CHECK(reasons[1].reason == "camera.velocity = [0, 0, 0.5]");
    CHECK(reasons[2].reason == "[disc] from 3 to 12");
    CHECK(reasons[3].reason == "disc.emission = \"image\", the one that ships");
    CHECK(reasons[4].reason == "disc.opacity = 0.25");
    CHECK(reasons[5].reason == "sky.kind = \"stars\"");
    CHECK(reasons[6].reason == "picture.refine = \"on\"");
}

TEST_CASE("edges are refined where there are any, and not where every pixel has several rays") {
    for (unsigned bits = 0; bits < 8; ++bits) {
        Scene scene;
        const bool bends = (bits & 1u) != 0, wanted = (bits & 2u) != 0, several = (bits & 4u) != 0;
        scene.spacetime.metric = bends ? "schwarzschild" : "minkowski";
        scene.picture.refine = wanted;
        scene.picture.samples = several ? 2 : 1;
        const EffectSet effects = effect_set(required_effects(scene));
        CHECK(effects.contains(Effect::kRefine) == (bends && wanted && !several));
        CHECK(effects.contains(Effect::kSamples) == several);
        CHECK(takes_samples(effects) == (several || (bends && wanted)));
    }
}

TEST_CASE("an unknown metric calls for no lensing") {
    Scene scene;
    scene.spacetime.metric = "no such metric";
    CHECK_FALSE(effect_set(required_effects(scene)).contains(Effect::kLensing));
}

TEST_CASE("a scene without one of its effects calls for no more than the others") {
    std::set<Effect> gone;
    for (const SceneInfo& info : shipped_scenes()) {
        const auto scene = load_scene(info.name);
        REQUIRE(scene);
        const EffectSet whole = effect_set(required_effects(*scene));
        for (const Effect effect : whole.list()) {
            CAPTURE(info.name);
            CAPTURE(effect_row(effect).key);
            const auto less = without_effect(*scene, effect);
            const bool bound = effect == Effect::kInner || effect == Effect::kBounce || effect == Effect::kStar ||
                               effect == Effect::kDiscImage || effect == Effect::kDiscPattern ||
                               effect == Effect::kThermalDisc || effect == Effect::kDiscGas ||
                               effect == Effect::kLightTimes;  // which goes with kDelay
            CHECK((less.has_value() || bound));
            if (!less) continue;
            const EffectSet left = effect_set(required_effects(*less));
            CHECK_FALSE(left.contains(effect));
            // A hole that no longer rotates has the table of one that never did.
            for (const Effect other : left.list())
                CHECK((whole.contains(other) || (effect == Effect::kSpin && other == Effect::kLensing)));
            gone.insert(effect);
        }
    }
    CHECK(gone.size() >= 8);  // the scenes that ship have most of them
}

TEST_CASE("effect sets are ordered by all their bits, those beyond 32 too") {
    const auto of = [](std::size_t number) { return EffectSet{static_cast<Effect>(number)}; };
    for (std::size_t i = 0; i < kEffectCount; ++i)
        for (std::size_t j = 0; j < kEffectCount; ++j) {
            CAPTURE(i);
            CAPTURE(j);
            CHECK((of(i) < of(j)) == (i < j));
        }
    std::set<EffectSet> keys;  // as the renderer's cache of programs has them
    for (std::size_t i = 0; i + 1 < kEffectCount; ++i)
        keys.insert({static_cast<Effect>(i), static_cast<Effect>(i + 1)});
    CHECK(keys.size() == kEffectCount - 1);
}
